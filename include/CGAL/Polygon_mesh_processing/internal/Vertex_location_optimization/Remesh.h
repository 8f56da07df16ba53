// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_REMESH_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_REMESH_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Index_groups.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Mesh_arrays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

enum class Vertex_kind : char
{
  FREE,
  ON_CURVE, // moves along with the constrained edges or the border
  FIXED
};

struct Constraints
{
  std::vector<Vertex_kind> kinds; // of the vertices
  std::vector<Index> edges;       // the constrained edges and the border edges
};

// The mesh that is optimized, M_t after t iterations.
struct Remesh : Mesh_arrays
{
  Remesh(Mesh_arrays mesh, Constraints c)
    : Mesh_arrays(std::move(mesh)), constraints(std::move(c)), initial_points(points), previous_points(points),
      next_points(points), mean_edge_length(compute_mean_edge_length()),
      corners_of_vertices(points.size(), 3 * number_of_faces(), [this](Index corner) { return vertex(corner); })
  {}

  // calls f(c) for each corner c at vertex i
  template <typename F>
  void for_each_corner(std::size_t i, const F& f) const
  {
    corners_of_vertices.for_each(i, f);
  }

  bool is_free(std::size_t i) const { return constraints.kinds[i] == Vertex_kind::FREE; }

  // whether the placement leaves vertex i where it is
  bool is_at_rest(std::size_t i) const
  {
    constexpr double rounding = 1e-9; // relative to the mean edge length; what a planar part may move by mistake
    return squared_distance(next_points[i], points[i]) <= square(rounding * mean_edge_length);
  }

  Vector last_displacement(std::size_t i) const { return points[i] - previous_points[i]; }

  double largest_displacement() const
  {
    double largest2 = 0;
    for(std::size_t i = 0; i < points.size(); ++i)
      largest2 = (std::max)(largest2, (next_points[i] - points[i]).squared_length());
    return std::sqrt(largest2);
  }

  // since M_0
  std::size_t number_of_moved_vertices() const
  {
    std::size_t number = 0;
    for(std::size_t i = 0; i < points.size(); ++i)
      number += points[i] != initial_points[i];
    return number;
  }

  // goes on to M_t+1; `next_points` are to be set then
  void advance()
  {
    previous_points.swap(points);
    points = next_points;
  }

  // the points of M_t are those of the base
  const Constraints constraints;
  const std::vector<Point> initial_points; // of M_0
  std::vector<Point> previous_points;      // of M_t-1; of M_0 in the first iteration
  std::vector<Point> next_points;          // p^_i, which become the points of M_t+1

  const double mean_edge_length; // of M_0
  Mesh_arrays surroundings;      // the rest of the user's mesh, if that matters
  const Index_groups corners_of_vertices;

private:
  double compute_mean_edge_length() const
  {
    double sum = 0;
    std::size_t count = 0;
    for(std::size_t e = 0; e < edges.size(); ++e)
      if(!is_diagonal(e))
      {
        sum += norm(points[edges[e][1]] - points[edges[e][0]]);
        ++count;
      }
    return count == 0 ? 0 : sum / count;
  }
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_REMESH_H
