// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_MEASURE_PROJECTIONS_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_MEASURE_PROJECTIONS_H

#include "meshes.h"
#include "standard_tree.h"
#include "Table.h"

#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>

#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/Cartesian_converter.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

// Nanoseconds a query of `project(query, foot)`, which improves the foot of that query.
template <typename Point, typename Foot, typename Project>
double nanoseconds(const std::vector<Point>& queries, std::vector<Foot>& feet, const Project& project)
{
  const double seconds = thread_time_of([&] {
    for(std::size_t i = 0; i < queries.size(); ++i)
      feet[i] = project(queries[i], feet[i]);
  });
  return 1e9 * seconds / static_cast<double>(queries.size());
}

// A search from scratch, and one with the query's own foot as hint.
template <typename Point, typename Tree>
std::vector<double>
cold_and_warm(const std::vector<Point>& queries, const Tree& tree, std::vector<typename Tree::Foot>& feet)
{
  using Foot = typename Tree::Foot;
  feet.resize(queries.size());
  const double cold = nanoseconds(queries, feet, [&](const Point& q, const Foot&) { return tree.project(q); });
  const double warm = nanoseconds(queries, feet, [&](const Point& q, const Foot& foot) { return tree.project(q, foot); });
  return { cold, warm };
}

template <typename Point, typename Surface>
void add_surface_rows(Table& table, const std::string& name, const std::vector<Point>& queries, const Surface& surface)
{
  using Foot = typename Surface::Foot;
  std::vector<Foot> feet;
  std::vector<double> row = cold_and_warm(queries, surface, feet);
  row.push_back(nanoseconds(queries, feet, [&](const Point& q, const Foot& f) {
    return surface.patches().project_locally({ q.x(), q.y(), q.z() }, f);
  }));
  table.add_row(name, row);
}

inline void measure_projections(std::ofstream& csv, const Mesh& reference, const Mesh& mesh)
{
  using Simple_kernel = CGAL::Simple_cartesian<double>;
  using Simple_mesh = CGAL::Surface_mesh<Simple_kernel::Point_3>;
  const CGAL::Cartesian_converter<Kernel, Simple_kernel> to_simple;
  Simple_mesh simple_reference;
  CGAL::copy_face_graph(reference, simple_reference);

  const Standard_tree<Mesh> tree(reference);
  const Standard_tree<Simple_mesh> simple_tree(simple_reference);
  const PMP::Flat_triangle_surface<Mesh> flat(reference);
  const Surface curved(reference);

  Table table(csv, "nanoseconds a projection (cold, with its own foot as hint, near its own foot)",
              { "cold", "warm", "near" });
  std::vector<Point> queries = vertices_and_midpoints(mesh);
  for(const std::string order : { ", order of the mesh", ", Hilbert order" })
  {
    if(order == ", Hilbert order")
      CGAL::hilbert_sort(queries.begin(), queries.end(), Kernel());
    std::vector<Simple_kernel::Point_3> simple_queries;
    for(const Point& query : queries)
      simple_queries.push_back(to_simple(query));

    std::vector<Standard_tree<Mesh>::Foot> feet;
    table.add_row("AABB tree, EPICK" + order, cold_and_warm(queries, tree, feet));
    std::vector<Standard_tree<Simple_mesh>::Foot> simple_feet;
    table.add_row("AABB tree, double" + order, cold_and_warm(simple_queries, simple_tree, simple_feet));
    add_surface_rows(table, "flat surface" + order, queries, flat);
    add_surface_rows(table, "PN surface" + order, queries, curved);
  }
}

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_MEASURE_PROJECTIONS_H
