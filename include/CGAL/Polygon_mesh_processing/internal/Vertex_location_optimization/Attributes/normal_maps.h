// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_NORMAL_MAPS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_NORMAL_MAPS_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_mesh.h>

#include <type_traits>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Whether the normals of a map are those of the corners of the faces, not those of the vertices.
template <typename TriangleMesh, typename NormalMap>
struct Is_corner_map : std::is_same<typename boost::property_traits<NormalMap>::key_type,
                                    typename boost::graph_traits<TriangleMesh>::halfedge_descriptor>
{};

// Calls f(c, h) for each corner c of the mesh, where h is the halfedge in its face that points to it.
template <typename TriangleMesh, typename F>
void for_each_corner_halfedge(const TriangleMesh& tmesh, const Mesh_descriptors<TriangleMesh>& descriptors, const F& f)
{
  std::size_t corner = 0;
  for(auto first : descriptors.halfedges)
    for(auto h : halfedges_around_face(first, tmesh))
      f(corner++, h);
}

// the normals at the corners of the faces, from a map of the vertices or of the corners
template <typename TriangleMesh, typename NormalMap>
std::vector<Vector> read_corner_normals(const TriangleMesh& tmesh,
                                        const Mesh_arrays& mesh,
                                        const Mesh_descriptors<TriangleMesh>& descriptors,
                                        const NormalMap& normal_map)
{
  std::vector<Vector> normals(3 * mesh.number_of_faces());
  if constexpr(Is_corner_map<TriangleMesh, NormalMap>::value)
    for_each_corner_halfedge(tmesh, descriptors,
                             [&](std::size_t c, auto h) { normals[c] = convert<Vector>(get(normal_map, h)); });
  else
    for(std::size_t c = 0; c < normals.size(); ++c)
      normals[c] = convert<Vector>(get(normal_map, descriptors.vertices[mesh.vertex(static_cast<Index>(c))]));
  return normals;
}

template <typename TriangleMesh, typename NormalMap>
void write_vertex_normals(const Mesh_descriptors<TriangleMesh>& descriptors,
                          const std::vector<Vector>& normals,
                          NormalMap& normal_map)
{
  using Normal = typename boost::property_traits<NormalMap>::value_type;
  for(std::size_t i = 0; i < normals.size(); ++i)
    put(normal_map, descriptors.vertices[i], convert<Normal>(normals[i]));
}

template <typename TriangleMesh, typename NormalMap>
void write_corner_normals(const TriangleMesh& tmesh,
                          const Mesh_descriptors<TriangleMesh>& descriptors,
                          const std::vector<Vector>& normals,
                          NormalMap& normal_map)
{
  using Normal = typename boost::property_traits<NormalMap>::value_type;
  for_each_corner_halfedge(tmesh, descriptors,
                           [&](std::size_t c, auto h) { put(normal_map, h, convert<Normal>(normals[c])); });
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_NORMAL_MAPS_H
