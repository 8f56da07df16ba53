// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_WALK_OR_SEARCH_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_WALK_OR_SEARCH_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The closest point: by walking if that leads to it beyond doubt, to a point that is not farther away than `near` and whose
// normal leads to p; by a search otherwise.
template <typename Reference>
typename Reference::Foot
walk_or_search(const Reference& reference, const Point& p, const typename Reference::Foot& hint, const double near)
{
  constexpr double cosine = 0.9; // at least, of the angle to the normal
  if(!Reference::walks)
    return reference.project(p, hint);
  const auto foot = reference.project_locally(p, hint);
  const Vector offset = p - reference.point(foot);
  const double distance2 = offset.squared_length();
  const bool is_sure =
    distance2 <= square(near) && square(offset * reference.normal(foot)) >= square(cosine) * distance2;
  return is_sure ? foot : reference.project(p, foot);
}

// How far away a closest point may be near to others with these distances, or it is doubtful.
inline double near_by(const double largest_distance)
{
  constexpr double factor = 2.5; // a distance that is smooth changes less; it trades time for exactness
  return factor * largest_distance;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_WALK_OR_SEARCH_H
