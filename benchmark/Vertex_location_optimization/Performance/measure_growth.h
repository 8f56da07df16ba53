// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_MEASURE_GROWTH_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_MEASURE_GROWTH_H

#include "Growth_curve.h"
#include "heap_use.h"
#include "meshes.h"
#include "standard_tree.h"
#include "Table.h"

#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

// Optimizes `mesh` with both methods, and adds what it takes to the table and to the curves, and beside it one projection of
// the vertices and midpoints with the standard tree.
inline void add_growth(Table& table,
                       std::vector<Growth_curve>& curves,
                       double size,
                       const Mesh& mesh,
                       const Mesh& reference,
                       const Surface& surface)
{
  const double projection = time_of_standard_projection(mesh, reference);
  auto curve = curves.begin();
  const auto add = [&](double seconds) {
    curve->sizes.push_back(size);
    curve->seconds.push_back(seconds);
    const double n = static_cast<double>(mesh.number_of_vertices());
    table.add_row(curve->name, { n, double(reference.number_of_faces()), seconds, 1e6 * seconds / n, seconds / projection });
    ++curve;
  };
  add(projection);
  for(PMP::Placement_method method : placement_methods)
    add(time_of_optimization(mesh, surface, method));
}

inline std::vector<Growth_curve> empty_curves()
{
  std::vector<Growth_curve> curves{ { "projection", {}, {} } };
  for(PMP::Placement_method method : placement_methods)
    curves.push_back({ name_of(method), {}, {} });
  return curves;
}

inline const std::vector<std::string>& growth_columns()
{
  static const std::vector<std::string> columns{ "vertices", "triangles", "seconds", "microseconds a vertex",
                                                 "/ projection" };
  return columns;
}

// Remeshes of 1K, 4K and 16K vertices, then of 64K and so on, which are subdivisions of the last.
inline std::vector<Growth_curve>
measure_growth_with_remesh(std::ofstream& csv, const Mesh& reference, std::size_t number_of_subdivisions)
{
  std::vector<Growth_curve> curves = empty_curves();
  Table table(csv, "growth with the remesh", growth_columns());
  const Surface surface(reference);
  Mesh mesh;
  for(double n : { 1e3, 4e3, 16e3 })
  {
    mesh = remeshed(reference, edge_length_for(n));
    add_growth(table, curves, mesh.number_of_vertices(), mesh, reference, surface);
  }
  for(std::size_t i = 0; i < number_of_subdivisions; ++i)
  {
    mesh = loop_subdivided(mesh);
    add_growth(table, curves, mesh.number_of_vertices(), mesh, reference, surface);
  }
  return curves;
}

// One remesh, of 16K vertices; references of 20K triangles, 60K and so on.
inline std::vector<Growth_curve>
measure_growth_with_reference(std::ofstream& csv, const Mesh& input, std::size_t number_of_subdivisions)
{
  std::vector<Growth_curve> curves = empty_curves();
  Table table(csv, "growth with the reference", growth_columns());
  const Mesh mesh = remeshed(input, edge_length_for(16e3));
  Mesh reference = remeshed(input, edge_length_for(10e3));
  for(std::size_t i = 0; i <= number_of_subdivisions; ++i)
  {
    if(i > 0)
      reference = subdivided(reference, 1);
    add_growth(table, curves, reference.number_of_faces(), mesh, reference, Surface(reference));
  }
  return curves;
}

inline void print_exponents(std::ofstream& csv,
                            const std::vector<Growth_curve>& of_remesh,
                            const std::vector<Growth_curve>& of_reference)
{
  Table table(csv, "exponents of the growth; the paper: O(n log m), n for the remesh and m for the reference",
              { "measured", "paper" });
  for(const Growth_curve& curve : of_remesh)
    table.add_row(curve.name + ", of n", { exponent(curve), 1 });
  for(const Growth_curve& curve : of_reference)
  {
    table.add_row(curve.name + ", of m", { exponent(curve), 0 });
    table.add_row(curve.name + ", of log m", { exponent_of_logarithm(curve), 1 });
  }
}

// One million vertices and five million triangles, with the memory of the whole process.
inline void measure_large(std::ofstream& csv, const Mesh& input)
{
  Mesh mesh = remeshed(input, edge_length_for(16e3));
  for(int i = 0; i < 3; ++i)
    mesh = loop_subdivided(mesh);
  const Mesh reference = subdivided(remeshed(input, edge_length_for(10e3)), 5);
  Table table(csv, "large meshes", { "vertices", "triangles", "surface", "seconds", "peak GiB" });
  const double start = thread_time();
  const Surface surface(reference);
  const double construction = thread_time() - start;
  for(PMP::Placement_method method : placement_methods)
  {
    const double seconds = time_of_optimization(mesh, surface, method);
    table.add_row(name_of(method), { double(mesh.number_of_vertices()), double(reference.number_of_faces()), construction,
                                     seconds, peak_of_process() / (1 << 30) });
  }
}

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_MEASURE_GROWTH_H
