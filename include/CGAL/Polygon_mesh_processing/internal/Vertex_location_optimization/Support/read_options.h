// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_READ_OPTIONS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_READ_OPTIONS_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Placement/make_placement.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Placement/Optimization_options.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/named_parameters.h>

#include <CGAL/number_utils.h>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

struct Allow_all_moves
{
  template <typename Vertex, typename Point>
  bool operator()(const Vertex&, const Point&, const Point&) const { return true; }
};

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
    choose_parameter(get_parameter(np, internal_np::number_of_relaxation_steps), options.number_of_relaxation_steps);
  options.convergence_threshold =
    to_double(choose_parameter(get_parameter(np, internal_np::convergence_threshold), options.convergence_threshold));
  options.do_self_intersection_tests =
    choose_parameter(get_parameter(np, internal_np::do_self_intersection_tests), options.do_self_intersection_tests);
  options.regularity_weight =
    to_double(choose_parameter(get_parameter(np, internal_np::regularity_weight), options.regularity_weight));
  return options;
}

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_READ_OPTIONS_H
