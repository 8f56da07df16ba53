// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_OPTIMIZATION_OPTIONS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_OPTIMIZATION_OPTIONS_H

#include <CGAL/Polygon_mesh_processing/Placement_method.h>

#include <cstddef>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// The parameters of the user.
struct Optimization_options
{
  Placement_method placement_method;
  double convergence_threshold; // relative to the mean edge length
  bool do_self_intersection_tests;
  std::size_t number_of_iterations = 30;
  std::size_t number_of_free_iterations = 20;
  std::size_t number_of_relaxation_steps = 1;
  double regularity_weight = 0.15; // of LEAST_SQUARES
};

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_OPTIMIZATION_OPTIONS_H
