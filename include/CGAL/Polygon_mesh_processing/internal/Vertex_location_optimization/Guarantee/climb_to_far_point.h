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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CLIMB_TO_FAR_POINT_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CLIMB_TO_FAR_POINT_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Flat_triangle.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Patch_tree.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/triangle_coordinates.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// A point of the reference, and the face of a mesh that is closest to it.
struct Far_point
{
  Point point;
  Index face;
  double distance;
};

// given the faces in `tree`, of which `hint` is one nearby
inline Far_point find_closest_face(const Patch_tree<Flat_triangle>& tree, const Point& p, const Index hint)
{
  const Patch_foot foot = tree.project(p, hint);
  return { p, foot.patch, norm(p - tree.point(foot)) };
}

// the longest distance between corners of the patch that a foot is in
template <typename Reference>
double length_of_patch(const Reference& reference, const Patch_foot& foot)
{
  const auto corner = [&](double u, double v) { return reference.point({ foot.patch, { u, v } }); };
  const Point p = corner(0, 0), q = corner(1, 0), r = corner(0, 1);
  return std::sqrt((std::max)({ squared_distance(p, q), squared_distance(q, r), squared_distance(r, p) }));
}

// Calls f(foot) for the middle of each side of the patches, once where two meet.
template <typename Reference, typename F>
void for_each_middle_of_side(const Reference& reference, const F& f)
{
  constexpr std::array<Coordinates, 3> middles{ { { 0.5, 0.5 }, { 0, 0.5 }, { 0.5, 0 } } };
  for(Index i = 0; i < reference.number_of_patches(); ++i)
    for(Index k = 0; k < 3; ++k)
    {
      const Index across = reference.corner_across(i, k);
      if(across == no_index || i < across / 3)
        f(Patch_foot{ i, middles[k] });
    }
}

// The point of its patch to which climbing from `foot` leads, with the height value(foot), by steps along the sides, which are
// halved where none leads higher.
template <typename Value>
Patch_foot climb_in_patch(Patch_foot foot, const Value& value)
{
  constexpr double first_step = 1. / 4, last_step = 1. / 64; // relative to the sides; they trade time for the top
  double highest = value(foot);
  for(double step = first_step; step >= last_step;)
  {
    bool is_higher = false;
    const auto [u, v] = foot.coordinates;
    for(int i = -1; i <= 1; ++i)
      for(int j = -1; j <= 1; ++j)
      {
        const double new_u = std::clamp(u + i * step, 0., 1.), new_v = std::clamp(v + j * step, 0., 1 - new_u);
        const Patch_foot candidate{ foot.patch, { new_u, new_v } };
        const double height = value(candidate);
        if(height > highest)
        {
          highest = height;
          foot = candidate;
          is_higher = true;
        }
      }
    if(!is_higher)
      step /= 2;
  }
  return foot;
}

// Where climbing over the reference from one of its points leads, away from the faces in `tree`: from corner to corner if it
// is so fine that this `crosses_patches`, and then between the corners; or that point itself if it leads nowhere above `limit`.
template <typename Reference>
Far_point climb_to_far_point(const Reference& reference,
                             const Point& p,
                             const Patch_tree<Flat_triangle>& tree,
                             const Index hint,
                             const bool crosses_patches,
                             const double limit)
{
  Far_point top = find_closest_face(tree, p, hint);
  if constexpr(Reference::walks)
  {
    const auto closest_face = [&](const Patch_foot& foot) { return find_closest_face(tree, reference.point(foot), hint); };
    const auto height = [&](const Patch_foot& foot) { return closest_face(foot).distance; };
    Patch_foot foot = reference.project(p);
    if(crosses_patches)
      foot = reference.climb(foot, height);
    Far_point highest = closest_face(foot);
    constexpr double large = 0.5; // relative to the distance; between the corners of smaller patches nothing is far higher
    const double length = length_of_patch(reference, foot);
    if(length > large * limit && highest.distance + length > limit) // no distance is steeper than one
      highest = closest_face(climb_in_patch(foot, height));
    if(highest.distance > top.distance)
      top = highest;
  }
  return top;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CLIMB_TO_FAR_POINT_H
