// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FLAT_TRIANGLE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FLAT_TRIANGLE_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// Barycentric coordinates of a point of a triangle with respect to its corners 1 and 2; that of corner 0 is 1 - u - v.
struct Coordinates
{
  std::array<double, 3> barycentric() const { return { 1 - u - v, u, v }; }

  double u = 1. / 3.;
  double v = 1. / 3.;
};

inline Point point_at(const std::array<Point, 3>& t, const Coordinates& x)
{
  return t[0] + (x.u * (t[1] - t[0]) + x.v * (t[2] - t[0]));
}

// Coordinate along [0, 1] of the point of the segment pq that is closest to x.
inline double closest_on_segment(const Point& p, const Point& q, const Point& x)
{
  const Vector d = q - p;
  const double length2 = d.squared_length();
  return length2 > 0 ? (std::min)(1., (std::max)(0., ((x - p) * d) / length2)) : 0.;
}

// Coordinates of the projection of x to the plane of the triangle; not numbers if the triangle has no area.
inline Coordinates project_to_plane(const std::array<Point, 3>& t, const Point& x)
{
  const Vector a = t[1] - t[0], b = t[2] - t[0], d = x - t[0];
  const Vector n = cross_product(a, b);
  const double n2 = n.squared_length();
  if(!(n2 > 0))
    return { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN() };
  return { (cross_product(d, b) * n) / n2, (cross_product(a, d) * n) / n2 };
}

// Coordinates of the point of the triangle that is closest to x; any triangle, also one without an area.
inline Coordinates closest_on_triangle(const std::array<Point, 3>& t, const Point& x)
{
  const Coordinates projection = project_to_plane(t, x);
  const auto [w, u, v] = projection.barycentric();
  if(u >= 0 && v >= 0 && w >= 0)
    return projection;

  // the foot is on a side that x is beyond
  Coordinates best;
  double best_distance = (std::numeric_limits<double>::max)();
  const auto try_side = [&](const Coordinates& foot)
  {
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

// What is known of the foot of a point on a patch before it is computed.
struct Foot_estimate
{
  Coordinates coordinates; // where to begin
  double lower_bound;      // of the distance
  double upper_bound;
};

// A triangle as a patch of a reference surface. A patch has
//   - bbox(), a box that contains it;
//   - point(x) and normal(x), a unit vector or the null vector;
//   - estimate_foot(q), which is cheap, and flat_coordinates(q), those of the projection to the plane of its corners, which
//     is even cheaper and may be beyond its sides;
//   - improve_foot(q, x, d2): if the patch has a point that is closer to q than sqrt(d2), sets x, which must be those of
//     the estimate, to its coordinates and d2 to its squared distance, and returns true;
//   - improve_foot_from(q, x, d2), the same with any x near the foot.
class Flat_triangle
{
public:
  Flat_triangle() = default;
  explicit Flat_triangle(const std::array<Point, 3>& corners) : m_corners(corners) {}

  Bbox_3 bbox() const { return m_corners[0].bbox() + m_corners[1].bbox() + m_corners[2].bbox(); }
  double area() const { return norm(area_normal(m_corners[0], m_corners[1], m_corners[2])) / 2; }
  Point point(const Coordinates& x) const { return point_at(m_corners, x); }
  Vector normal(const Coordinates&) const
  {
    return normalized(area_normal(m_corners[0], m_corners[1], m_corners[2]));
  }

  Coordinates flat_coordinates(const Point& query) const { return project_to_plane(m_corners, query); }

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

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FLAT_TRIANGLE_H
