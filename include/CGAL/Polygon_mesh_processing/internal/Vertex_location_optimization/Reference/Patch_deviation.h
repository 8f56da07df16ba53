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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PATCH_DEVIATION_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PATCH_DEVIATION_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// How far a patch, or several, are from the flat triangles, at the midpoints of the sides and at the barycenters.
struct Patch_deviation
{
  double area = 0, integral = 0, maximum = 0;

  Patch_deviation& operator+=(const Patch_deviation& other)
  {
    area += other.area;
    integral += other.integral;
    maximum = (std::max)(maximum, other.maximum);
    return *this;
  }
};

template <typename Patch>
Patch_deviation deviation_of_patch(const Patch& patch)
{
  const Point p = patch.point({ 0, 0 });
  const Vector n = normalized(area_normal(p, patch.point({ 1, 0 }), patch.point({ 0, 1 })));
  const auto at = [&](double u, double v) { return std::abs((patch.point({ u, v }) - p) * n); };
  const std::array<double, 3> at_midpoints{ { at(0.5, 0), at(0, 0.5), at(0.5, 0.5) } };
  const double area = patch.area();
  return { area, area * (at_midpoints[0] + at_midpoints[1] + at_midpoints[2]) / 3,
           (std::max)({ at_midpoints[0], at_midpoints[1], at_midpoints[2], at(1. / 3, 1. / 3) }) };
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PATCH_DEVIATION_H
