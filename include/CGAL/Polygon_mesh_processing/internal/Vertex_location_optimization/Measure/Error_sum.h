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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_ERROR_SUM_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_ERROR_SUM_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>

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

// The distance of all these faces; `Face` is a `Face_error`.
template <typename ConcurrencyTag, typename Face>
Error_sum sum_of_faces(const std::vector<Face>& faces)
{
  return sum_over_indices<ConcurrencyTag, Error_sum>(faces.size(), [&](std::size_t f) { return Error_sum(faces[f]); });
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_ERROR_SUM_H
