// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FOOT_ESTIMATE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FOOT_ESTIMATE_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/triangle_coordinates.h>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// What is known of the foot of a point on a patch before it is computed.
struct Foot_estimate
{
  Coordinates coordinates; // where to begin
  double lower_bound;      // of the distance
  double upper_bound;
};

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FOOT_ESTIMATE_H
