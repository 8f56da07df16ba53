// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_ERROR_SUM_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_ERROR_SUM_H

#include <algorithm>
#include <cmath>
#include <limits>

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

// the distance of some faces to the reference
struct Error_sum
{
  double area = 0;
  double distance = 0;         // its integral
  double squared_distance = 0; // the integral of its square
  double max = 0;

  Error_sum() = default;
  Error_sum(const Face_error& face)
    : area(face.area), distance(face.area * face.mean), squared_distance(face.area * face.mean_square), max(face.max)
  {}

  Error_sum& operator+=(const Error_sum& other)
  {
    area += other.area;
    distance += other.distance;
    squared_distance += other.squared_distance;
    max = (std::max)(max, other.max);
    return *this;
  }

  double mean() const { return mean_of(distance, area); }
  double rms() const { return std::sqrt(mean_of(squared_distance, area)); }
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_ERROR_SUM_H
