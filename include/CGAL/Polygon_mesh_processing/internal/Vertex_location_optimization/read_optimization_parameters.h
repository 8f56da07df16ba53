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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_READ_OPTIMIZATION_PARAMETERS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_READ_OPTIMIZATION_PARAMETERS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Placement/make_placement.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/named_parameters.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_parameters.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

struct Allow_all_moves
{
  template <typename Vertex, typename Point>
  bool operator()(const Vertex&, const Point&, const Point&) const
  {
    return true;
  }
};

// The value of a parameter, which can also be given as a `std::optional`; an empty one stands for the default.
inline std::optional<double> to_optional_double(const std::optional<double>& parameter) { return parameter; }

template <typename Number>
std::optional<double> to_optional_double(const Number& parameter)
{
  return to_double(parameter);
}

// The options among the parameters, else the defaults of the placement method.
template <typename NamedParameters>
Optimization_options read_options(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  Optimization_options options =
    default_options(choose_parameter(get_parameter(np, internal_np::placement_method), PIECEWISE_LINEAR));
  options.number_of_iterations =
    choose_parameter(get_parameter(np, internal_np::number_of_iterations), options.number_of_iterations);
  options.number_of_free_iterations =
    choose_parameter(get_parameter(np, internal_np::number_of_free_iterations), options.number_of_free_iterations);
  options.number_of_relaxation_steps =
    choose_parameter(get_parameter(np, internal_np::number_of_relaxation_steps), std::optional<std::size_t>());
  if(const std::optional<double> threshold =
       to_optional_double(choose_parameter(get_parameter(np, internal_np::convergence_threshold), std::optional<double>())))
    options.convergence_threshold = threshold;
  options.do_self_intersection_tests =
    choose_parameter(get_parameter(np, internal_np::do_self_intersection_tests), options.do_self_intersection_tests);
  options.regularity_weight =
    to_optional_double(choose_parameter(get_parameter(np, internal_np::regularity_weight), std::optional<double>()));
  options.guarantee_both_directions =
    choose_parameter(get_parameter(np, internal_np::guarantee_both_directions), options.guarantee_both_directions);
  options.preserve_volume = choose_parameter(get_parameter(np, internal_np::preserve_volume), options.preserve_volume);
  return options;
}

// Calls f(i) for each vertex i at the point of another one: a copy of a non-manifold vertex, for example.
template <typename F>
void for_each_coincident_vertex(const std::vector<Point>& points, const F& f)
{
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index(0));
  std::sort(order.begin(), order.end(), [&](Index i, Index j) { return points[i] < points[j]; });
  for(std::size_t k = 1; k < order.size(); ++k)
    if(points[order[k]] == points[order[k - 1]])
    {
      f(order[k - 1]);
      f(order[k]);
    }
}

// The vertices that constraints and borders keep from moving freely. Constrained edges and the border of `pmesh` hold their
// vertices or, with `relax_constraints`, guide them. The vertices of faces that are not selected stay, and so do vertices at
// the same point, as they must not separate.
template <typename PolygonMesh, typename Selection, typename VertexPointMap, typename NamedParameters>
Constraints read_constraints(const PolygonMesh& pmesh,
                             const Selection& selection,
                             const Mesh_arrays& mesh,
                             const Mesh_descriptors<PolygonMesh>& descriptors,
                             const VertexPointMap& vpm,
                             const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using vertex_descriptor = typename boost::graph_traits<PolygonMesh>::vertex_descriptor;

  const std::vector<char> is_constrained = find_constrained_edges(mesh, descriptors, np);
  const auto vertex_is_constrained = choose_parameter(get_parameter(np, internal_np::vertex_is_constrained),
                                                      Static_boolean_property_map<vertex_descriptor, false>());
  const bool relax_constraints = choose_parameter(get_parameter(np, internal_np::relax_constraints), false);

  Constraints constraints;
  constraints.kinds.assign(mesh.points.size(), Vertex_kind::FREE);
  for(Index e = 0; e < mesh.edges.size(); ++e)
    if(is_constrained[e] || (mesh.is_border(e) && is_border(descriptors.edges[e], pmesh)))
    {
      constraints.edges.push_back(e);
      for(Index i : mesh.edges[e])
        constraints.kinds[i] = relax_constraints ? Vertex_kind::ON_CURVE : Vertex_kind::FIXED;
    }
  for(std::size_t i = 0; i < mesh.points.size(); ++i)
    if(get(vertex_is_constrained, descriptors.vertices[i]) || !selection.has_all_faces_at(descriptors.vertices[i]))
      constraints.kinds[i] = Vertex_kind::FIXED;

  std::vector<Point> points = mesh.points; // followed by those of the vertices that are not read
  if constexpr(!Selection::is_whole_mesh)
    for(auto v : vertices(pmesh))
      if(!selection.has_vertex(v))
        points.push_back(convert<Point>(get(vpm, v)));
  for_each_coincident_vertex(points, [&](Index i) {
    if(i < constraints.kinds.size())
      constraints.kinds[i] = Vertex_kind::FIXED;
  });
  return constraints;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_READ_OPTIMIZATION_PARAMETERS_H
