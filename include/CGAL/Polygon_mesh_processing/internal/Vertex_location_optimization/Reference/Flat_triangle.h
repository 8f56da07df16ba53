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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FLAT_TRIANGLE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FLAT_TRIANGLE_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/triangle_coordinates.h>

#include <CGAL/Bbox_3.h>

#include <array>
#include <cmath>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// A face of the reference as it is, a `Surface_patch`, see `Patch_tree` and `Reference_patches`.
class Flat_triangle
{
public:
  Flat_triangle() = default;
  explicit Flat_triangle(const std::array<Point, 3>& corners) : m_corners(corners) {}

  Bbox_3 bbox() const { return bounding_box(m_corners); }
  const std::array<Point, 3>& corners() const { return m_corners; }
  double deviation() const { return 0; }
  double area() const { return norm(area_normal(m_corners[0], m_corners[1], m_corners[2])) / 2; }
  Point point(const Coordinates& x) const { return point_at(m_corners, x); }
  Vector normal(const Coordinates&) const { return normalized(area_normal(m_corners[0], m_corners[1], m_corners[2])); }

  Coordinates flat_coordinates(const Point& query) const { return project_to_plane(m_corners, query); }

  std::array<bool, 3> sides_farther_than(const Coordinates& x, double squared_distance) const
  {
    return vertex_location::sides_farther_than(m_corners, x, squared_distance);
  }

  Foot_estimate estimate_foot(const Point& query) const
  {
    const Coordinates foot = closest_on_triangle(m_corners, query);
    const double distance = std::sqrt(squared_distance(query, point(foot)));
    return { foot, distance, distance };
  }

  bool improve_foot(const Point& query, const Coordinates& foot, double& squared_distance_bound) const
  {
    const double distance = squared_distance(query, point(foot));
    if(!(distance < squared_distance_bound))
      return false;
    squared_distance_bound = distance;
    return true;
  }

  bool improve_foot_from(const Point& query, Coordinates& x, double& squared_distance_bound) const
  {
    const Coordinates foot = closest_on_triangle(m_corners, query);
    if(!improve_foot(query, foot, squared_distance_bound))
      return false;
    x = foot;
    return true;
  }

private:
  std::array<Point, 3> m_corners;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FLAT_TRIANGLE_H
