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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MESH_ARRAYS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MESH_ARRAYS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// A triangle mesh in contiguous arrays, in an order in which what is close on the mesh is close in memory: see
// `Vertex_order`. Edges and faces are in the order of their first vertices, with which they begin.
//
// Corner c = 3 f + k is the corner k of face f. The edge opposite to corner k of f is `face_edges[f][k]`: it goes from
// the corner k + 1 to the corner k + 2 of f, or back.
//
// A polygon, a face of the user's mesh with more than three corners, stands for the mean of its fans: the faces are their
// triangles, each with a weight, and the edges include diagonals. An ear is the triangle that cuts off one corner of its
// polygon: both its sides there are edges of the polygon. Traversals around a vertex go from ear to ear, and `edge_corners`
// has one corner for each side of an edge, of any of the triangles there.
struct Mesh_arrays
{
  std::vector<Point> points;
  std::vector<std::array<Index, 3>> faces; // the vertices at the corners
  std::vector<std::array<Index, 3>> face_edges;
  std::vector<std::array<Index, 2>> edges;
  std::vector<std::array<Index, 2>> edge_corners; // the corners opposite to an edge; no_index: none, a border edge

  // empty unless there is a polygon
  std::vector<double> weights; // of the faces
  std::vector<Index> polygons; // which face of the user's mesh each face is of
  std::vector<Index> ears;     // for each corner that of the ear at the same corner of its polygon
  std::vector<char> diagonals; // whether an edge is one

  bool has_polygons() const { return !polygons.empty(); }
  Index polygon(std::size_t f) const { return has_polygons() ? polygons[f] : static_cast<Index>(f); }

  std::size_t number_of_polygons() const
  {
    return has_polygons() ? 1 + *std::max_element(polygons.begin(), polygons.end()) : number_of_faces();
  }

  double weight(std::size_t f) const { return weights.empty() ? 1 : weights[f]; }

  double total_weight() const
  {
    return weights.empty() ? static_cast<double>(number_of_faces()) : std::accumulate(weights.begin(), weights.end(), 0.);
  }

  Index ear(Index corner) const { return ears.empty() ? corner : ears[corner]; }
  bool is_diagonal(std::size_t e) const { return !diagonals.empty() && diagonals[e]; }

  std::size_t number_of_faces() const { return faces.size(); }
  const std::array<Index, 3>& face(std::size_t f) const { return faces[f]; }
  Index first_vertex(std::size_t f) const { return faces[f][0]; }

  // the first one of the edges, or faces, that begin with vertex i or one after it
  std::size_t first_edge_from(std::size_t i) const { return first_from(i, edges); }
  std::size_t first_face_from(std::size_t i) const { return first_from(i, faces); }

  std::array<Point, 3> triangle(std::size_t f) const { return triangle(f, points); }

  // face f with its vertices at other points
  std::array<Point, 3> triangle(std::size_t f, const std::vector<Point>& at) const
  {
    const std::array<Index, 3>& v = faces[f];
    return { at[v[0]], at[v[1]], at[v[2]] };
  }

  Point midpoint(std::size_t e) const { return midpoint(e, points); }

  Point midpoint(std::size_t e, const std::vector<Point>& at) const
  {
    return CGAL::midpoint(at[edges[e][0]], at[edges[e][1]]);
  }

  Point barycenter(std::size_t f) const
  {
    const std::array<Point, 3> t = triangle(f);
    return centroid(t[0], t[1], t[2]);
  }

  Vector area_normal(std::size_t f) const { return area_normal(f, points); }

  Vector area_normal(std::size_t f, const std::vector<Point>& at) const
  {
    const std::array<Point, 3> t = triangle(f, at);
    return vertex_location::area_normal(t[0], t[1], t[2]);
  }

  double triangle_area(std::size_t f) const { return norm(area_normal(f)) / 2; }

  // The area that face f represents, that of the triangle times its weight: integrals over the mesh are sums over these
  // areas.
  double area(std::size_t f) const { return area(f, points); }

  double area(std::size_t f, const std::vector<Point>& at) const
  {
    const double area_of_triangle = norm(area_normal(f, at)) / 2;
    return weights.empty() ? area_of_triangle : weights[f] * area_of_triangle;
  }

  Index vertex(Index corner) const { return faces[corner / 3][corner % 3]; }
  static Index next(Index corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
  static Index previous(Index corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }
  Index opposite_edge(Index corner) const { return face_edges[corner / 3][corner % 3]; }
  Index edge_at_first_vertex(std::size_t f) const { return face_edges[f][1]; }

  bool is_border(std::size_t e) const
  {
    return !is_diagonal(e) && (edge_corners[e][0] == no_index || edge_corners[e][1] == no_index);
  }

  // A corner opposite to the same edge on its other side; no_index at a border. Not for diagonals.
  Index corner_across(Index corner) const
  {
    const std::array<Index, 2>& corners = edge_corners[opposite_edge(corner)];
    const bool is_first =
      has_polygons() ? corners[0] != no_index && polygons[corners[0] / 3] == polygons[corner / 3] : corners[0] == corner;
    return is_first ? corners[1] : corners[0];
  }

  // The ear at the same vertex across the edge that is opposite to the next corner of an ear; no_index at a border.
  Index corner_across_next(Index corner) const
  {
    const Index opposite = corner_across(next(corner));
    return opposite == no_index ? no_index : ear(next(opposite));
  }

  // the same across the edge that is opposite to the previous corner
  Index corner_across_previous(Index corner) const
  {
    const Index opposite = corner_across(previous(corner));
    return opposite == no_index ? no_index : ear(previous(opposite));
  }

private:
  template <typename Elements>
  static std::size_t first_from(std::size_t i, const Elements& elements)
  {
    return std::partition_point(elements.begin(), elements.end(), [&](const auto& e) { return e[0] < i; }) -
           elements.begin();
  }
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MESH_ARRAYS_H
