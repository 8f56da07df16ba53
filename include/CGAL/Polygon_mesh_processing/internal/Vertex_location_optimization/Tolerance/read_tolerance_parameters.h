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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_READ_TOLERANCE_PARAMETERS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_READ_TOLERANCE_PARAMETERS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/named_parameters.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Tolerance/find_coarsest_remesh.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

template <typename NamedParameters>
Search_limits read_search_limits(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  const double precision = to_double(choose_parameter(get_parameter(np, internal_np::edge_length_precision), 0.02));
  const std::size_t number = choose_parameter(get_parameter(np, internal_np::maximum_number_of_remeshings), std::size_t(12));
  return { precision, number };
}

// Whether constrained edges or border edges do not pass straight through a vertex.
template <typename TriangleMesh, typename EdgeIsConstrainedMap>
bool is_corner(typename boost::graph_traits<TriangleMesh>::vertex_descriptor v,
               const TriangleMesh& input,
               const EdgeIsConstrainedMap& is_constrained)
{
  const auto vpm = get(vertex_point, input);
  std::vector<Vector> directions;
  for(auto h : halfedges_around_target(v, input))
    if(is_border_edge(h, input) || get(is_constrained, edge(h, input)))
      directions.push_back(convert<Point>(get(vpm, source(h, input))) - convert<Point>(get(vpm, v)));
  if(directions.empty())
    return false;
  return directions.size() != 2 || !Feature_curves::goes_straight_through(directions[0], directions[1]);
}

template <typename TriangleMesh, typename NamedParameters>
Kept_elements find_kept_elements(const TriangleMesh& input, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using graph_traits = boost::graph_traits<TriangleMesh>;
  using edge_descriptor = typename graph_traits::edge_descriptor;

  const auto is_constrained = choose_parameter(get_parameter(np, internal_np::edge_is_constrained),
                                               Static_boolean_property_map<edge_descriptor, false>());
  Kept_elements kept;
  for(edge_descriptor e : edges(input))
    kept.edges.push_back(get(is_constrained, e));
  for(auto v : vertices(input))
    kept.vertices.push_back(halfedge(v, input) != graph_traits::null_halfedge() && is_corner(v, input, is_constrained));
  return kept;
}

// The faces of the input, with the creases that np2 asks for; else with the constrained edges as creases, if there are.
template <typename ConcurrencyTag, typename TriangleMesh, typename NamedParameters1, typename NamedParameters2>
Flat_triangle_surface<TriangleMesh>
make_input_surface(const TriangleMesh& input, const NamedParameters1& np1, const NamedParameters2& np2)
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  constexpr bool has_creases = !is_default_parameter<NamedParameters2, internal_np::edge_is_constrained_t>::value ||
                               !is_default_parameter<NamedParameters2, internal_np::sharpness_angle_t>::value;
  constexpr bool has_constraints = !is_default_parameter<NamedParameters1, internal_np::edge_is_constrained_t>::value;
  if constexpr(!has_creases && has_constraints)
    return Flat_triangle_surface<TriangleMesh>(
      input, parameters::edge_is_constrained_map(get_parameter(np1, internal_np::edge_is_constrained)), ConcurrencyTag());
  else
    return Flat_triangle_surface<TriangleMesh>(input, np2, ConcurrencyTag());
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_READ_TOLERANCE_PARAMETERS_H
