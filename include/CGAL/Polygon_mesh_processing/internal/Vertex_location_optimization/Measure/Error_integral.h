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

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>
#include <CGAL/Polygon_mesh_processing/Vertex_location_optimization_report.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// A sum over a weight: 0 where there is no weight, infinite rather than not a number where the numbers overflow.
inline double mean_of(double sum, double weight)
{
  const double mean = weight == 0 ? 0 : sum / weight;
  return std::isnan(mean) ? std::numeric_limits<double>::infinity() : mean;
}

// the distance of a face to the reference
struct Face_error
{
  double area = 0;
  double mean = 0;
  double mean_square = 0;
  double max = 0;
};

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

  // neither rounding nor uncertain faces must make these negative
  double mean() const { return (std::max)(0., mean_of(distance, area)); }
  double mean_square() const { return (std::max)(0., mean_of(squared_distance, area)); }
  Approximation_error error() const { return { mean(), std::sqrt(mean_square()), max }; }
};

inline Error_integral integral_over(const Face_error& face)
{
  return { face.area, face.area * face.mean, face.area * face.mean_square, face.max };
}

// The distance of all these faces; `Face` is a `Face_error`.
template <typename ConcurrencyTag, typename Face>
Error_integral integral_over_faces(const std::vector<Face>& faces)
{
  return sum_over_indices<ConcurrencyTag, Error_integral>(faces.size(),
                                                          [&](std::size_t f) { return integral_over(faces[f]); });
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_ERROR_INTEGRAL_H
