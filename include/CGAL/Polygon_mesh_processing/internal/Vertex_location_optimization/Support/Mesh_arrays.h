// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MESH_ARRAYS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MESH_ARRAYS_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// A triangle mesh in contiguous arrays, in an order in which what is close in space is close in memory: the vertices along
// a space-filling curve, edges and faces in the order of their first vertices, with which they begin.
//
// Corner c = 3 f + k is the corner k of face f. The edge opposite to corner k of f is `face_edges[f][k]`: it goes from
// the corner k + 1 to the corner k + 2 of f, or back.
struct Mesh_arrays
{
  std::vector<Point> points;
  std::vector<std::array<Index, 3>> faces; // the vertices at the corners
  std::vector<std::array<Index, 3>> face_edges;
  std::vector<std::array<Index, 2>> edges;
  std::vector<std::array<Index, 2>> edge_corners; // the corners opposite to an edge; no_index: none, a border edge

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

  double area(std::size_t f) const { return area(f, points); }
  double area(std::size_t f, const std::vector<Point>& at) const { return norm(area_normal(f, at)) / 2; }

  Index vertex(Index corner) const { return faces[corner / 3][corner % 3]; }
  static Index next(Index corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
  static Index previous(Index corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }
  Index opposite_edge(Index corner) const { return face_edges[corner / 3][corner % 3]; }
  Index edge_at_first_vertex(std::size_t f) const { return face_edges[f][1]; }
  bool is_border(std::size_t e) const { return edge_corners[e][0] == no_index || edge_corners[e][1] == no_index; }

  // the corner opposite to the same edge on its other side; no_index at a border
  Index corner_across(Index corner) const
  {
    const std::array<Index, 2>& corners = edge_corners[opposite_edge(corner)];
    return corners[0] == corner ? corners[1] : corners[0];
  }

  // the corner at the same vertex in the face across the edge that is opposite to the next corner; no_index at a border
  Index corner_across_next(Index corner) const
  {
    const Index opposite = corner_across(next(corner));
    return opposite == no_index ? no_index : next(opposite);
  }

  // the same across the edge that is opposite to the previous corner
  Index corner_across_previous(Index corner) const
  {
    const Index opposite = corner_across(previous(corner));
    return opposite == no_index ? no_index : previous(opposite);
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
