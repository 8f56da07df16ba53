// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MESH_ARRAYS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MESH_ARRAYS_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// A triangle mesh in contiguous arrays, in an order in which what is close in space is close in memory: the vertices along
// a space-filling curve, edges and faces in the order of their first vertices, with which they begin.
//
// Corner c = 3 f + k is the corner k of face f. The edge opposite to corner k of f is `face_edges[f][k]`: it goes from
// the corner k + 1 to the corner k + 2 of f, or back. A face is known by its edges alone.
struct Mesh_arrays
{
  std::vector<Point> points;
  std::vector<std::array<Index, 3>> face_edges;
  std::vector<std::array<Index, 2>> edges;
  std::vector<std::array<Index, 2>> edge_corners; // the corners opposite to an edge; no_index: none, a border edge

  std::size_t number_of_faces() const { return face_edges.size(); }
  Index first_vertex(std::size_t f) const { return edges[face_edges[f][2]][0]; }

  // the first one of the edges, or faces, that begin with vertex i or one after it
  std::size_t first_edge_from(std::size_t i) const
  {
    return std::partition_point(edges.begin(), edges.end(), [&](const auto& e) { return e[0] < i; }) - edges.begin();
  }
  std::size_t first_face_from(std::size_t i) const
  {
    return std::partition_point(face_edges.begin(), face_edges.end(),
                                [&](const auto& e) { return edges[e[2]][0] < i; }) - face_edges.begin();
  }

  // the vertices of face f; two of its edges begin with the first one
  std::array<Index, 3> face(std::size_t f) const
  {
    const std::array<Index, 2>& to_second = edges[face_edges[f][2]];
    return { to_second[0], to_second[1], edges[face_edges[f][1]][1] };
  }

  std::array<Point, 3> triangle(std::size_t f) const { return triangle(f, points); }

  // face f with its vertices at other points
  std::array<Point, 3> triangle(std::size_t f, const std::vector<Point>& at) const
  {
    const std::array<Index, 3> v = face(f);
    return { at[v[0]], at[v[1]], at[v[2]] };
  }

  Point midpoint(std::size_t e) const { return CGAL::midpoint(points[edges[e][0]], points[edges[e][1]]); }

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

  Index vertex(Index corner) const { return face(corner / 3)[corner % 3]; }
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
};

// The descriptors behind the elements of a `Mesh_arrays`.
template <typename TriangleMesh>
struct Mesh_descriptors
{
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices;
  std::vector<typename boost::graph_traits<TriangleMesh>::edge_descriptor> edges;
  std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> halfedges; // to the first vertex of each face
};

// Whether `tmesh` can be worked on: all its faces are triangles and all its coordinates are finite.
template <typename TriangleMesh, typename VertexPointMap>
bool is_valid_input(const TriangleMesh& tmesh, const VertexPointMap& vpm)
{
  for(auto v : vertices(tmesh))
    if(!is_finite(convert<Point>(get(vpm, v))))
      return false;
  return is_triangle_mesh(tmesh);
}

// Copies `tmesh`, for which `is_valid_input(tmesh, vpm)` must hold, and appends to `descriptors`.
template <typename TriangleMesh, typename VertexPointMap>
Mesh_arrays make_mesh_arrays(const TriangleMesh& tmesh,
                             const VertexPointMap& vpm,
                             Mesh_descriptors<TriangleMesh>& descriptors)
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using edge_descriptor = typename boost::graph_traits<TriangleMesh>::edge_descriptor;

  Mesh_arrays mesh;

  // vertices along a space-filling curve
  auto vertex_index = get(dynamic_vertex_property_t<Index>(), tmesh);
  {
    std::vector<std::pair<Point, vertex_descriptor>> order;
    for(vertex_descriptor v : vertices(tmesh))
      order.emplace_back(convert<Point>(get(vpm, v)), v);
    using First = First_of_pair_property_map<std::pair<Point, vertex_descriptor>>;
    hilbert_sort(order.begin(), order.end(), Spatial_sort_traits_adapter_3<Kernel, First>());

    mesh.points.reserve(order.size());
    descriptors.vertices.reserve(order.size());
    for(const auto& [point, v] : order)
    {
      put(vertex_index, v, static_cast<Index>(mesh.points.size()));
      mesh.points.push_back(point);
      descriptors.vertices.push_back(v);
    }
  }

  auto sort_by_first_vertex = [](auto& keyed)
  {
    std::stable_sort(keyed.begin(), keyed.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  };

  auto edge_index = get(dynamic_edge_property_t<Index>(), tmesh);
  {
    std::vector<std::pair<Index, edge_descriptor>> order;
    for(edge_descriptor e : edges(tmesh))
      order.emplace_back((std::min)(get(vertex_index, source(e, tmesh)), get(vertex_index, target(e, tmesh))), e);
    sort_by_first_vertex(order);

    mesh.edges.reserve(order.size());
    descriptors.edges.reserve(order.size());
    for(const auto& key_and_edge : order)
    {
      const edge_descriptor e = key_and_edge.second;
      put(edge_index, e, static_cast<Index>(mesh.edges.size()));
      const auto ends = std::minmax({ get(vertex_index, source(e, tmesh)), get(vertex_index, target(e, tmesh)) });
      mesh.edges.push_back({ ends.first, ends.second });
      descriptors.edges.push_back(e);
    }
  }

  std::vector<std::pair<Index, halfedge_descriptor>> face_order; // a face by the halfedge to its first vertex
  for(auto f : faces(tmesh))
  {
    const auto around = halfedges_around_face(halfedge(f, tmesh), tmesh);
    const auto first = std::min_element(around.begin(), around.end(), [&](halfedge_descriptor g, halfedge_descriptor h)
    {
      return get(vertex_index, target(g, tmesh)) < get(vertex_index, target(h, tmesh));
    });
    face_order.emplace_back(get(vertex_index, target(*first, tmesh)), *first);
  }
  sort_by_first_vertex(face_order);

  mesh.face_edges.reserve(face_order.size());
  mesh.edge_corners.resize(mesh.edges.size(), { no_index, no_index });
  descriptors.halfedges.reserve(face_order.size());
  for(const auto& key_and_halfedge : face_order)
  {
    const Index f = static_cast<Index>(mesh.face_edges.size());
    mesh.face_edges.emplace_back();
    Index k = 0;
    for(auto h : halfedges_around_face(key_and_halfedge.second, tmesh))
    {
      // the edge opposite to a corner is that of the halfedge after the next
      const Index e = get(edge_index, edge(prev(h, tmesh), tmesh));
      mesh.face_edges[f][k] = e;
      mesh.edge_corners[e][mesh.edge_corners[e][0] == no_index ? 0 : 1] = 3 * f + k;
      ++k;
    }
    descriptors.halfedges.push_back(key_and_halfedge.second);
  }
  return mesh;
}

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MESH_ARRAYS_H
