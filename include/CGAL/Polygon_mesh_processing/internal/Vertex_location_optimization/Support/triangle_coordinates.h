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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_TRIANGLE_COORDINATES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_TRIANGLE_COORDINATES_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <limits>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Barycentric coordinates of a point of a triangle with respect to its corners 1 and 2; that of corner 0 is 1 - u - v.
struct Coordinates
{
  std::array<double, 3> barycentric() const { return { 1 - u - v, u, v }; }

  double u = 1. / 3.;
  double v = 1. / 3.;
};

constexpr Coordinates barycenter_coordinates{}; // of the barycenter

// Below this, a barycentric coordinate is taken to be 0, and the point to be on that side. It accounts for rounding.
constexpr double boundary_tolerance = 1e-12;

inline bool is_inside(const std::array<double, 3>& barycentric)
{
  return *std::min_element(barycentric.begin(), barycentric.end()) > boundary_tolerance;
}

inline Point point_at(const std::array<Point, 3>& t, const Coordinates& x)
{
  return t[0] + (x.u * (t[1] - t[0]) + x.v * (t[2] - t[0]));
}

inline Bbox_3 bounding_box(const std::array<Point, 3>& t)
{
  const auto min = [](double a, double b, double c) { return (std::min)((std::min)(a, b), c); };
  const auto max = [](double a, double b, double c) { return (std::max)((std::max)(a, b), c); };
  return { min(t[0].x(), t[1].x(), t[2].x()), min(t[0].y(), t[1].y(), t[2].y()), min(t[0].z(), t[1].z(), t[2].z()),
           max(t[0].x(), t[1].x(), t[2].x()), max(t[0].y(), t[1].y(), t[2].y()), max(t[0].z(), t[1].z(), t[2].z()) };
}

// Evenly distributed points of a triangle, in any number: consecutive ones follow the additive recurrence by powers of the
// plastic number, which has low discrepancy.
inline Coordinates low_discrepancy_coordinates(const std::size_t number)
{
  constexpr double plastic_number = 1.3247179572447460; // the real root of x^3 = x + 1
  constexpr double step_u = 1 / plastic_number, step_v = step_u / plastic_number;
  double integer_part;
  const double u = std::modf(0.5 + step_u * number, &integer_part);
  const double v = std::modf(0.5 + step_v * number, &integer_part);
  return u + v > 1 ? Coordinates{ 1 - u, 1 - v } : Coordinates{ u, v };
}

// Calls f(x) for a point of each of the s * s triangles that the sides of a triangle, cut into s pieces, make. The points
// are quasi-random, so that a mean over them has hardly any bias; for the same s, each `number` gives different ones.
template <typename F>
void for_each_stratified_sample(const std::size_t s, const std::size_t number, const F& f)
{
  std::size_t number_of_point = number * s * s;
  for(std::size_t i = 0; i < s; ++i)
    for(std::size_t j = 0; j < s - i; ++j)
    {
      const Coordinates x = low_discrepancy_coordinates(number_of_point++);
      f(Coordinates{ (i + x.u) / s, (j + x.v) / s });
      if(i + j + 1 == s)
        continue;
      const Coordinates y = low_discrepancy_coordinates(number_of_point++);
      f(Coordinates{ (i + 1 - y.u) / s, (j + 1 - y.v) / s });
    }
}

// Coordinate along [0, 1] of the point of the segment pq that is closest to x.
inline double closest_on_segment(const Point& p, const Point& q, const Point& x)
{
  const Vector d = q - p;
  const double length2 = d.squared_length();
  return length2 > 0 ? (std::min)(1., (std::max)(0., ((x - p) * d) / length2)) : 0.;
}

// The plane of a triangle.
class Triangle_plane
{
public:
  explicit Triangle_plane(const std::array<Point, 3>& t)
    : m_corner(t[0]), m_a(t[1] - t[0]), m_b(t[2] - t[0]), m_normal(cross_product(m_a, m_b)),
      m_normal2(m_normal.squared_length())
  {}

  // coordinates of the projection of x; not numbers if the triangle has no area
  Coordinates project(const Point& x) const
  {
    if(!(m_normal2 > 0))
      return { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN() };
    const Vector d = x - m_corner;
    return { (cross_product(d, m_b) * m_normal) / m_normal2, (cross_product(m_a, d) * m_normal) / m_normal2 };
  }

private:
  Point m_corner;
  Vector m_a, m_b, m_normal;
  double m_normal2;
};

inline Coordinates project_to_plane(const std::array<Point, 3>& t, const Point& x) { return Triangle_plane(t).project(x); }

// Coordinates of the point of the triangle that is closest to x, which has a known projection to its plane; any triangle,
// also one without an area.
inline Coordinates closest_on_triangle(const std::array<Point, 3>& t, const Point& x, const Coordinates& projection)
{
  const auto [w, u, v] = projection.barycentric();
  if(u >= 0 && v >= 0 && w >= 0)
    return projection;

  // the foot is on a side that x is beyond
  Coordinates best;
  double best_distance = (std::numeric_limits<double>::max)();
  const auto try_side = [&](const Coordinates& foot) {
    const double distance = squared_distance(point_at(t, foot), x);
    if(distance < best_distance)
    {
      best_distance = distance;
      best = foot;
    }
  };
  if(!(v >= 0))
    try_side({ closest_on_segment(t[0], t[1], x), 0 });
  if(!(u >= 0))
    try_side({ 0, closest_on_segment(t[0], t[2], x) });
  if(!(w >= 0))
  {
    const double s = closest_on_segment(t[1], t[2], x);
    try_side({ 1 - s, s });
  }
  return best;
}

inline Coordinates closest_on_triangle(const std::array<Point, 3>& t, const Point& x)
{
  return closest_on_triangle(t, x, project_to_plane(t, x));
}

// Which sides of the triangle, opposite to its corners, are farther from its point x than sqrt(d2).
inline std::array<bool, 3> sides_farther_than(const std::array<Point, 3>& t, const Coordinates& x, const double d2)
{
  const std::array<double, 3> lambda = x.barycentric();
  const double n2 = area_normal(t[0], t[1], t[2]).squared_length(); // that of the heights times the sides
  const auto is_farther = [&](int k) {
    return square(lambda[k]) * n2 > d2 * squared_distance(t[(k + 1) % 3], t[(k + 2) % 3]);
  };
  return { is_farther(0), is_farther(1), is_farther(2) };
}

// What is known of the foot of a point on a patch before it is computed.
struct Foot_estimate
{
  Coordinates coordinates; // where to begin
  double lower_bound;      // of the distance
  double upper_bound;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_TRIANGLE_COORDINATES_H
