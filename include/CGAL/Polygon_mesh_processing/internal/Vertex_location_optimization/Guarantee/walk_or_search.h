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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_WALK_OR_SEARCH_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_WALK_OR_SEARCH_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Reference_access.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// A closest point, and how far away it is, see `signed_distance_to_foot()`.
template <typename Foot>
struct Foot_at_distance
{
  Foot foot;
  double signed_distance;
};

// The closest point: by walking if the result is certain, that is, not farther away than `near` and with p nearly along its
// normal; otherwise by a search.
template <typename Reference>
Foot_at_distance<typename Reference::Foot>
walk_or_search(const Reference& reference, const Point& p, const typename Reference::Foot& hint, const double near)
{
  constexpr double cosine = 0.9; // at least, of the angle to the normal
  const auto search = [&](const typename Reference::Foot& nearby) -> Foot_at_distance<typename Reference::Foot> {
    const auto foot = reference.project(p, nearby);
    return { foot, signed_distance_to_foot(p, reference, foot) };
  };
  if(!Reference::walks)
    return search(hint);
  const auto foot = reference.project_locally(p, hint);
  const Vector offset = p - reference.point(foot);
  const double distance2 = offset.squared_length(), height = offset * reference.normal(foot);
  const bool is_sure = distance2 <= square(near) && square(height) >= square(cosine) * distance2;
  if(!is_sure)
    return search(foot);
  return { foot, std::copysign(std::sqrt(distance2), height) };
}

// How far away a closest point may be that walking leads to, near to points with these distances on a face of this size.
inline double near_by(const double largest_distance, const double size)
{
  constexpr double factor = 2.5; // a distance that is smooth changes less
  constexpr double far = 0.1;    // relative to the size; other sheets are thought to be farther away
  return (std::min)(factor * largest_distance, far * size); // both trade time for exactness
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_WALK_OR_SEARCH_H
