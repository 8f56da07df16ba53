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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_READ_PARAMETERS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_READ_PARAMETERS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_mesh.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <functional>
#include <type_traits>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// the vertex point map among the parameters, else the mesh's own; a readable one if `TriangleMesh` is const
template <typename TriangleMesh, typename NamedParameters>
auto read_vertex_point_map(TriangleMesh& tmesh, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  using Get_map = GetVertexPointMap<std::remove_const_t<TriangleMesh>, NamedParameters>;
  if constexpr(std::is_const<TriangleMesh>::value)
    return typename Get_map::const_type(
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, tmesh)));
  else
    return typename Get_map::type(
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_property_map(vertex_point, tmesh)));
}

// what a named parameter holds: itself, or the object to which std::ref() refers
template <typename T>
T& unwrap_reference(T& t)
{
  return t;
}

template <typename T>
T& unwrap_reference(std::reference_wrapper<T>& t)
{
  return t.get();
}

// marks the edges that the user constrains
template <typename TriangleMesh, typename NamedParameters>
std::vector<char>
find_constrained_edges(const Mesh_arrays& mesh, const Mesh_descriptors<TriangleMesh>& descriptors, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using edge_descriptor = typename boost::graph_traits<TriangleMesh>::edge_descriptor;

  const auto edge_is_constrained = choose_parameter(get_parameter(np, internal_np::edge_is_constrained),
                                                    Static_boolean_property_map<edge_descriptor, false>());
  std::vector<char> is_constrained(mesh.edges.size());
  for(std::size_t e = 0; e < mesh.edges.size(); ++e)
    is_constrained[e] = !mesh.is_diagonal(e) && get(edge_is_constrained, descriptors.edges[e]);
  return is_constrained;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_READ_PARAMETERS_H
