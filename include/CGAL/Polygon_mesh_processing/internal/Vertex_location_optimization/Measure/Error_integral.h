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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_ERROR_INTEGRAL_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_ERROR_INTEGRAL_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/Vertex_location_optimization_report.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Distances over a surface, or over a part of it, on the way to their mean.
struct Error_integral
{
  double area = 0;
  double distance = 0;         // its integral
  double squared_distance = 0; // the integral of its square
  double max = 0;

  Error_integral& operator+=(const Error_integral& other)
  {
    area += other.area;
    distance += other.distance;
    squared_distance += other.squared_distance;
    max = (std::max)(max, other.max);
    return *this;
  }

  Approximation_error error() const
  {
    if(!(area > 0))
      return { 0, 0, max };
    return { distance / area, std::sqrt(squared_distance / area), max };
  }
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_ERROR_INTEGRAL_H
