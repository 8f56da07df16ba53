// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_MEASURE_RATIOS_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_MEASURE_RATIOS_H

#include "../sparse_least_squares.h"
#include "meshes.h"
#include "Phase_timer.h"
#include "standard_tree.h"
#include "Table.h"

#include <cstddef>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

struct Baselines
{
  double remeshing = 0;  // (a) of the remeshing that made the mesh
  double projection = 0; // (b) of one projection of the vertices and midpoints through the standard tree
  double sparse_fit = 0; // (c)
};

inline double time_of_sparse_fit(Mesh mesh, const Surface& surface)
{
  return thread_time_of([&] { fit_sparse_least_squares(mesh, surface, [](Mesh::Vertex_index) { return false; }); });
}

inline Phase_timer time_phases(Mesh mesh, const Surface& surface, PMP::Placement_method method)
{
  Phase_timer timer;
  timer.start();
  PMP::optimize_vertex_locations(mesh, surface, CGAL::parameters::placement_method(method).visitor(std::ref(timer)));
  timer.stop();
  return timer;
}

inline void print_iterations(std::ofstream& csv, PMP::Placement_method method, const Phase_timer& timer)
{
  Table table(csv, std::string("phases: ") + name_of(method) + ", milliseconds of each iteration",
              { "sample", "place", "relax", "correct" });
  for(std::size_t i = 0; i < timer.iterations().size(); ++i)
  {
    std::vector<double> row;
    for(std::size_t phase = 0; phase < Phase_timer::guarantee; ++phase)
      row.push_back(1e3 * timer.iterations()[i][phase]);
    table.add_row("iteration " + std::to_string(i + 1), row);
  }
}

// The whole call, its phases, and what it is compared with, in seconds.
inline void measure_ratios(std::ofstream& csv, const Mesh& reference, double edge_length)
{
  Baselines base;
  const Mesh mesh = remeshed(reference, edge_length, &base.remeshing);
  base.projection = time_of_standard_projection(mesh, reference);
  Table baselines(csv, "baselines, seconds", { "vertices", "triangles", "seconds" });
  const double n = mesh.number_of_vertices(), m = reference.number_of_faces();
  baselines.add_row("(a) isotropic remeshing", { n, m, base.remeshing });
  baselines.add_row("(b) standard tree, samples once", { n, m, base.projection });
  const double start = thread_time();
  const Surface surface(reference);
  baselines.add_row("PN surface and its tree", { n, m, thread_time() - start });
  base.sparse_fit = time_of_sparse_fit(mesh, surface);
  baselines.add_row("(c) sparse least-squares fit", { n, m, base.sparse_fit });

  std::vector<Phase_timer> timers;
  Table table(
    csv, "ratios: the whole call, the reference apart",
    { "iterations", "seconds", "/ (a)", "/ (b)", "/ (c)", "sample", "place", "relax", "correct", "guarantee", "apart" });
  for(PMP::Placement_method method : placement_methods)
  {
    const double seconds = time_of_optimization(mesh, surface, method);
    timers.push_back(time_phases(mesh, surface, method));
    std::vector<double> row{ double(timers.back().iterations().size()), seconds, seconds / base.remeshing,
                             seconds / base.projection, seconds / base.sparse_fit };
    row.insert(row.end(), timers.back().total().begin(), timers.back().total().end());
    table.add_row(name_of(method), row);
  }
  for(std::size_t i = 0; i < timers.size(); ++i)
    print_iterations(csv, placement_methods[i], timers[i]);
}

// Remeshing the model, and the whole call with the mesh itself as the reference.
inline void compare_with_remeshing(std::ofstream& csv, const Mesh& input, double edge_length)
{
  double remeshing = 0;
  const Mesh mesh = remeshed(input, edge_length, &remeshing);
  Table table(csv, "the model as it is: remeshing, and the whole call with the reference",
              { "vertices", "remeshing", "seconds", "ratio" });
  for(PMP::Placement_method method : placement_methods)
  {
    Mesh copy = mesh;
    const double seconds =
      thread_time_of([&] { PMP::optimize_vertex_locations(copy, input, CGAL::parameters::placement_method(method)); });
    table.add_row(name_of(method), { double(mesh.number_of_vertices()), remeshing, seconds, seconds / remeshing });
  }
}

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_MEASURE_RATIOS_H
