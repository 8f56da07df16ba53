// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_READ_MESH_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_READ_MESH_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Mesh_arrays.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

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

// Copies the vertices along a space-filling curve, and numbers them.
template <typename TriangleMesh, typename VertexPointMap, typename VertexIndexMap>
void copy_vertices(const TriangleMesh& tmesh,
                   const VertexPointMap& vpm,
                   VertexIndexMap& vertex_index,
                   Mesh_arrays& mesh,
                   Mesh_descriptors<TriangleMesh>& descriptors)
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Point_and_vertex = std::pair<Point, vertex_descriptor>;

  std::vector<Point_and_vertex> order;
  for(vertex_descriptor v : vertices(tmesh))
    order.emplace_back(convert<Point>(get(vpm, v)), v);
  hilbert_sort(order.begin(), order.end(),
               Spatial_sort_traits_adapter_3<Kernel, First_of_pair_property_map<Point_and_vertex>>());

  mesh.points.reserve(order.size());
  descriptors.vertices.reserve(order.size());
  for(const auto& [point, v] : order)
  {
    put(vertex_index, v, static_cast<Index>(mesh.points.size()));
    mesh.points.push_back(point);
    descriptors.vertices.push_back(v);
  }
}

template <typename Descriptor>
void sort_by_first_vertex(std::vector<std::pair<Index, Descriptor>>& order)
{
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
}

// Copies the edges in the order of their first vertices, and numbers them.
template <typename TriangleMesh, typename VertexIndexMap, typename EdgeIndexMap>
void copy_edges(const TriangleMesh& tmesh,
                const VertexIndexMap& vertex_index,
                EdgeIndexMap& edge_index,
                Mesh_arrays& mesh,
                Mesh_descriptors<TriangleMesh>& descriptors)
{
  using edge_descriptor = typename boost::graph_traits<TriangleMesh>::edge_descriptor;

  std::vector<std::pair<Index, edge_descriptor>> order;
  for(edge_descriptor e : edges(tmesh))
    order.emplace_back((std::min)(get(vertex_index, source(e, tmesh)), get(vertex_index, target(e, tmesh))), e);
  sort_by_first_vertex(order);

  mesh.edges.reserve(order.size());
  descriptors.edges.reserve(order.size());
  for(const auto& [first, e] : order)
  {
    put(edge_index, e, static_cast<Index>(mesh.edges.size()));
    mesh.edges.push_back({ first, (std::max)(get(vertex_index, source(e, tmesh)), get(vertex_index, target(e, tmesh))) });
    descriptors.edges.push_back(e);
  }
  mesh.edge_corners.resize(mesh.edges.size(), { no_index, no_index });
}

// Copies the faces in the order of their first vertices.
template <typename TriangleMesh, typename VertexIndexMap, typename EdgeIndexMap>
void copy_faces(const TriangleMesh& tmesh,
                const VertexIndexMap& vertex_index,
                const EdgeIndexMap& edge_index,
                Mesh_arrays& mesh,
                Mesh_descriptors<TriangleMesh>& descriptors)
{
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  std::vector<std::pair<Index, halfedge_descriptor>> order; // a face by the halfedge to its first vertex
  for(auto f : faces(tmesh))
  {
    const auto around = halfedges_around_face(halfedge(f, tmesh), tmesh);
    const auto first = std::min_element(around.begin(), around.end(), [&](halfedge_descriptor g, halfedge_descriptor h) {
      return get(vertex_index, target(g, tmesh)) < get(vertex_index, target(h, tmesh));
    });
    order.emplace_back(get(vertex_index, target(*first, tmesh)), *first);
  }
  sort_by_first_vertex(order);

  mesh.faces.resize(order.size());
  mesh.face_edges.resize(order.size());
  descriptors.halfedges.reserve(order.size());
  for(Index f = 0; f < order.size(); ++f)
  {
    Index k = 0;
    for(auto h : halfedges_around_face(order[f].second, tmesh))
    {
      // the edge opposite to a corner is that of the halfedge after the next
      const Index e = get(edge_index, edge(prev(h, tmesh), tmesh));
      mesh.faces[f][k] = get(vertex_index, target(h, tmesh));
      mesh.face_edges[f][k] = e;
      mesh.edge_corners[e][mesh.edge_corners[e][0] == no_index ? 0 : 1] = 3 * f + k;
      ++k;
    }
    descriptors.halfedges.push_back(order[f].second);
  }
}

// Copies `tmesh` to empty arrays; returns false, and copies nothing, if it cannot be worked on.
template <typename TriangleMesh, typename VertexPointMap>
bool read_mesh(const TriangleMesh& tmesh,
               const VertexPointMap& vpm,
               Mesh_arrays& mesh,
               Mesh_descriptors<TriangleMesh>& descriptors)
{
  const bool is_valid = is_valid_input(tmesh, vpm);
  CGAL_precondition(is_valid);
  if(!is_valid)
    return false;

  auto vertex_index = get(dynamic_vertex_property_t<Index>(), tmesh);
  auto edge_index = get(dynamic_edge_property_t<Index>(), tmesh);
  copy_vertices(tmesh, vpm, vertex_index, mesh, descriptors);
  copy_edges(tmesh, vertex_index, edge_index, mesh, descriptors);
  copy_faces(tmesh, vertex_index, edge_index, mesh, descriptors);
  return true;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_READ_MESH_H
