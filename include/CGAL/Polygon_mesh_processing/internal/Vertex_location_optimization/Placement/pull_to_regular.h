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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PULL_TO_REGULAR_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PULL_TO_REGULAR_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The displacement of v that makes the triangle v, p, q more regular; `length` is that of the sides of the triangles around.
// It is the sum of two terms: the vector to the apex of the equilateral triangle over pq, damped with its length, as very
// irregular triangles need not become equilateral; and the direction in which the smallest angle grows fastest, smoothed to
// a mean of the three angles with weights that decrease with the lengths of the opposite sides.
inline Vector pull_to_regular(const Point& v, const Point& p, const Point& q, const double length)
{
  constexpr double apex_part = 1. / 4, angle_part = 1. / 6; // with twice as much of the second the iterations do not settle

  const Vector side = q - p, from_p = v - p, from_q = v - q;
  const Vector normal = normalized(cross_product(side, from_p));
  const std::array<double, 3> lengths2{ side.squared_length(), from_q.squared_length(), from_p.squared_length() };
  const double shortest2 = *std::min_element(lengths2.begin(), lengths2.end());
  if(normal == NULL_VECTOR || !(shortest2 > 0))
    return NULL_VECTOR;

  const Vector to_apex = (std::sqrt(3.) / 2) * cross_product(normal, side) - (from_p + from_q) / 2;

  std::array<double, 3> weights; // of the angles at v, p, q
  double sum_of_weights = 0;
  for(int k = 0; k < 3; ++k)
  {
    weights[k] = square(square(square(shortest2 / lengths2[k])));
    sum_of_weights += weights[k];
  }
  // by the gradients of the angles at p and q; that at v shrinks by as much as they grow
  const Vector gradient = ((weights[1] - weights[0]) / lengths2[2]) * cross_product(normal, from_p) -
                          ((weights[2] - weights[0]) / lengths2[1]) * cross_product(normal, from_q);

  return (apex_part / (1 + 3 * norm(to_apex) / std::sqrt(lengths2[0]))) * to_apex +
         (angle_part * square(length) / sum_of_weights) * gradient;
}

// The same for v and its neighbors p and q in a polygon of more than three corners, whose fans give the ear v, p, q the
// weight 2 / n: the way to the apex of the ear of a regular polygon, on the outer side of pq as seen along the normal.
inline Vector
pull_to_regular_polygon(const Point& v, const Point& p, const Point& q, const Vector& normal, const double weight_of_ear)
{
  constexpr double apex_part = 1. / 4; // as for a triangle

  const Vector side = q - p, from_p = v - p, from_q = v - q;
  const Vector ear_normal = normalized(cross_product(side, from_p));
  const double length = norm(side);
  if(ear_normal == NULL_VECTOR)
    return NULL_VECTOR;
  const Vector up = ear_normal * normal < 0 ? -ear_normal : ear_normal; // the corner may be a notch
  const Vector to_apex = (std::tan(CGAL_PI * weight_of_ear / 2) / 2) * cross_product(up, side) - (from_p + from_q) / 2;
  return (apex_part / (1 + 3 * norm(to_apex) / length)) * to_apex;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PULL_TO_REGULAR_H
