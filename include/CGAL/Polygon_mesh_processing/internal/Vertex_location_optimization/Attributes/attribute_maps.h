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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_ATTRIBUTE_MAPS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_ATTRIBUTE_MAPS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/Attribute_value.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_mesh.h>

#include <CGAL/Surface_mesh/Properties.h>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Whether the values of a map are those of the corners of the faces, not those of the vertices.
template <typename TriangleMesh, typename Map>
struct Is_corner_map : std::is_same<typename boost::property_traits<Map>::key_type,
                                    typename boost::graph_traits<TriangleMesh>::halfedge_descriptor>
{};

// Whether a map has a value for a key. This can be tested for the maps of `Surface_mesh`: a map of another mesh, or a
// removed one, may have no value.
template <typename Map, typename Key>
bool has_value_for(const Map& map, const Key& key)
{
  using Value = typename boost::property_traits<Map>::value_type;
  if constexpr(std::is_base_of<Properties::Property_map_base<Key, Value, Map>, Map>::value)
    return bool(map) && static_cast<std::size_t>(key) < static_cast<std::size_t>(map.end() - map.begin());
  else
    return true;
}

// Calls f(c, h) for each corner c of the mesh, where h is the halfedge in its face that points to it.
template <typename TriangleMesh, typename F>
void for_each_corner_halfedge(const TriangleMesh& tmesh,
                              const Mesh_arrays& mesh,
                              const Mesh_descriptors<TriangleMesh>& descriptors,
                              const F& f)
{
  for(std::size_t c = 0; c < 3 * mesh.number_of_faces(); c += 3)
  {
    const auto halfedges = corner_halfedges(tmesh, mesh, descriptors, c / 3);
    for(std::size_t k = 0; k < 3; ++k)
      f(c + k, halfedges[k]);
  }
}

// whether a map of the vertices or of the corners has values for all of them
template <typename TriangleMesh, typename Map>
bool has_all_values(const TriangleMesh& tmesh,
                    const Mesh_arrays& mesh,
                    const Mesh_descriptors<TriangleMesh>& descriptors,
                    const Map& map)
{
  bool has_all = true;
  if constexpr(Is_corner_map<TriangleMesh, Map>::value)
    for_each_corner_halfedge(tmesh, mesh, descriptors,
                             [&](std::size_t, auto h) { has_all = has_all && has_value_for(map, h); });
  else
    for(auto v : descriptors.vertices)
      has_all = has_all && has_value_for(map, v);
  return has_all;
}

// the values at the corners of the faces, from a map of the vertices or of the corners, as `convert` makes them
template <typename T, typename TriangleMesh, typename Map, typename Convert>
std::vector<T> read_corner_values(const TriangleMesh& tmesh,
                                  const Mesh_arrays& mesh,
                                  const Mesh_descriptors<TriangleMesh>& descriptors,
                                  const Map& map,
                                  const Convert& convert)
{
  std::vector<T> values(3 * mesh.number_of_faces());
  if constexpr(Is_corner_map<TriangleMesh, Map>::value)
    for_each_corner_halfedge(tmesh, mesh, descriptors, [&](std::size_t c, auto h) { values[c] = convert(get(map, h)); });
  else
    for(std::size_t c = 0; c < values.size(); ++c)
      values[c] = convert(get(map, descriptors.vertices[mesh.vertex(static_cast<Index>(c))]));
  return values;
}

// Writes at_corner(c) for each corner c to a map of the corners, or at_vertex(i) for each vertex i to one of the vertices.
template <typename TriangleMesh, typename Map, typename AtCorner, typename AtVertex>
void write_values(const TriangleMesh& tmesh,
                  const Mesh_arrays& mesh,
                  const Mesh_descriptors<TriangleMesh>& descriptors,
                  Map& map,
                  const AtCorner& at_corner,
                  const AtVertex& at_vertex)
{
  if constexpr(Is_corner_map<TriangleMesh, Map>::value)
    for_each_corner_halfedge(tmesh, mesh, descriptors, [&](std::size_t c, auto h) { put(map, h, at_corner(c)); });
  else
    for(std::size_t i = 0; i < descriptors.vertices.size(); ++i)
      put(map, descriptors.vertices[i], at_vertex(i));
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_ATTRIBUTE_MAPS_H
