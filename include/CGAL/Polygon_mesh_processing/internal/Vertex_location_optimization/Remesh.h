// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
//
// Author(s)     : The Vertex_location_optimization authors

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_REMESH_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_REMESH_H

#include <CGAL/license/Vertex_location_optimization.h>

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
      next_points(points), lengths(compute_lengths()),
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
    constexpr double rounding = 1e-9; // relative to the lengths of the edges; what a planar part may move by mistake
    return squared_distance(next_points[i], points[i]) <= square(rounding * lengths[i]);
  }

  Vector last_displacement(std::size_t i) const { return points[i] - previous_points[i]; }

  // of an edge or a face, by its vertices
  template <std::size_t n>
  double length_at(const std::array<Index, n>& vertices) const
  {
    double sum = 0;
    for(Index i : vertices)
      sum += lengths[i];
    return sum / n;
  }

  double length_of_face(std::size_t f) const { return length_at(face(f)); }

  double largest_displacement() const
  {
    double largest2 = 0;
    for(std::size_t i = 0; i < points.size(); ++i)
      largest2 = (std::max)(largest2, (next_points[i] - points[i]).squared_length());
    return std::sqrt(largest2);
  }

  bool is_closed() const
  {
    for(std::size_t e = 0; e < edges.size(); ++e)
      if(is_border(e))
        return false;
    return !edges.empty();
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

  // goes back to M_0
  void restart() { points = previous_points = next_points = initial_points; }

  // the points of M_t are those of the base
  const Constraints constraints;
  const std::vector<Point> initial_points; // of M_0
  std::vector<Point> previous_points;      // of M_t-1; of M_0 in the first iteration
  std::vector<Point> next_points;          // p^_i, which become the points of M_t+1

  // The mean length of the edges around each vertex of M_0. All quantities that are relative to the size of the triangles
  // refer to it, so that meshes with strongly varying edge lengths are treated alike everywhere.
  const std::vector<double> lengths;
  Mesh_arrays surroundings; // the rest of the user's mesh, if it is needed
  const Index_groups corners_of_vertices;

private:
  // Averages over two rings of neighbors, as the edges of a single vertex vary even in a uniform mesh.
  std::vector<double> compute_lengths() const
  {
    std::vector<double> lengths_of_edges(points.size(), 0);
    for_each_end([&](Index i, Index j) { lengths_of_edges[i] += norm(points[j] - points[i]); });
    std::vector<double> sums(points.size(), 0);
    std::vector<Index> numbers_of_edges(points.size(), 0), numbers(points.size(), 0);
    for_each_end([&](Index i, Index) { ++numbers_of_edges[i]; });
    for_each_end([&](Index i, Index j) {
      sums[i] += lengths_of_edges[j];
      numbers[i] += numbers_of_edges[j];
    });
    for(std::size_t i = 0; i < sums.size(); ++i)
      sums[i] /= (std::max)(numbers[i], Index(1));
    return sums;
  }

  // calls f(i, j) and f(j, i) for each edge ij
  template <typename F>
  void for_each_end(const F& f) const
  {
    for(std::size_t e = 0; e < edges.size(); ++e)
      if(!is_diagonal(e))
      {
        f(edges[e][0], edges[e][1]);
        f(edges[e][1], edges[e][0]);
      }
  }
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_REMESH_H
