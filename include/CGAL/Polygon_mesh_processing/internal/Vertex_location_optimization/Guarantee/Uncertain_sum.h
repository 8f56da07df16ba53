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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_UNCERTAIN_SUM_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_UNCERTAIN_SUM_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <cmath>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// A sum that is estimated from samples, and its variance.
struct Uncertain_sum
{
  double sum = 0, variance = 0;

  Uncertain_sum& operator+=(const Uncertain_sum& other)
  {
    sum += other.sum;
    variance += other.variance;
    return *this;
  }

  // exceeded in one of some forty cases if the errors are normally distributed
  double upper_bound() const
  {
    constexpr double deviations = 2;
    return sum + deviations * std::sqrt(variance);
  }
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_UNCERTAIN_SUM_H
