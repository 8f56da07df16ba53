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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FARTHEST_POINT_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FARTHEST_POINT_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Face_sampling.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/walk_or_search.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Reference_access.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/triangle_coordinates.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The plane that touches the reference at a point.
template <typename Reference>
class Tangent_plane
{
public:
  Tangent_plane(const Reference& reference, const typename Reference::Foot& foot)
    : m_point(reference.point(foot)), m_normal(reference.normal(foot))
  {}

  // infinite if there is no such plane
  double distance(const Point& p) const
  {
    return m_normal == NULL_VECTOR ? std::numeric_limits<double>::infinity() : std::abs((p - m_point) * m_normal);
  }

private:
  Point m_point;
  Vector m_normal;
};

// The largest distance of a triangle, given its corners, from the closest one of three planes: if the reference coincides
// with this plane below the triangle, no point can be farther away.
template <typename Plane>
double distance_to_planes(const std::array<Point, 3>& corners, const std::array<Plane, 3>& planes)
{
  const auto from_plane = [&](const Plane& plane) {
    return (std::max)({ plane.distance(corners[0]), plane.distance(corners[1]), plane.distance(corners[2]) });
  };
  return (std::min)({ from_plane(planes[0]), from_plane(planes[1]), from_plane(planes[2]) });
}

// The same for a triangle with feet in its corners and at the midpoints of the sides opposite to them, for each of the four
// triangles between these: the largest distance.
template <typename Reference>
double distance_to_planes_of_quarters(const Reference& reference,
                                      const std::array<Point, 3>& corners,
                                      const Face_feet<typename Reference::Foot>& feet)
{
  using Plane = Tangent_plane<Reference>;
  const auto planes_at = [&](const auto& f) {
    return std::array<Plane, 3>{ { Plane(reference, f[0]), Plane(reference, f[1]), Plane(reference, f[2]) } };
  };
  const std::array<Point, 3> midpoints{ { midpoint(corners[1], corners[2]), midpoint(corners[2], corners[0]),
                                          midpoint(corners[0], corners[1]) } };
  const std::array<Plane, 3> planes = planes_at(feet.of_corners), midpoint_planes = planes_at(feet.of_midpoints);
  double largest = distance_to_planes(midpoints, midpoint_planes);
  for(int k = 0; k < 3; ++k)
  {
    std::array<Point, 3> t = midpoints;
    std::array<Plane, 3> p = midpoint_planes;
    t[k] = corners[k];
    p[k] = planes[k];
    largest = (std::max)(largest, distance_to_planes(t, p));
  }
  return largest;
}

// Finds the point of a triangle that is farthest from the reference, by branch and bound: the triangle is cut into parts,
// first where it may be farthest away, until none can have a distance above the largest one known. The distance inside a
// part is bounded by that at its corners and, where it is smooth, by its slopes, measured in the part and in the one that it
// was cut from; where the reference has an edge, by its tangent planes at the closest points. No slope exceeds one; for a
// triangle not much larger than the distance itself, only this bound is used.
template <typename Reference>
class Farthest_point
{
  using Foot = typename Reference::Foot;
  using Plane = Tangent_plane<Reference>;
  using Triangle = std::array<Point, 3>;

public:
  explicit Farthest_point(const Reference& reference) : m_reference(reference) {}

  // The largest distance of a triangle if that is larger than `bound`; otherwise `bound`. `hint` is the foot of a point
  // nearby. With `is_any_enough` it is not the largest distance, but one that is larger than `bound`.
  double operator()(const Triangle& t, const Foot& hint, const double bound, const bool is_any_enough = false) const
  {
    const double size = radius(t);
    const int min_level = level_of_reference(t, hint);
    constexpr double near = 0; // the corners are searched for
    double largest = bound;
    Samples samples;
    samples.reserve(3 + 3 * max_cuts);
    std::vector<Part> parts; // a heap
    parts.reserve(1 + 3 * max_cuts);
    const auto may_be_larger = [&](const Part& part) { return part.bound > (1 + tolerance) * largest + rounding * size; };
    const auto add = [&](Part part) {
      for(int corner : part.corners)
        largest = (std::max)(largest, samples[corner].distance);
      if(part.level == max_level)
        return;
      part.bound = part.level < min_level ? std::numeric_limits<double>::infinity() : upper_bound(samples, part, size);
      if(!may_be_larger(part))
        return;
      parts.push_back(part);
      std::push_heap(parts.begin(), parts.end());
    };
    for(const Coordinates& corner : { Coordinates{ 0, 0 }, Coordinates{ 1, 0 }, Coordinates{ 0, 1 } })
      samples.push_back(sample(t, corner, hint, near));
    add({ { { 0, 1, 2 } }, 1, 0 });
    for(int cuts = 0; !parts.empty() && cuts < max_cuts && !(is_any_enough && largest > bound); ++cuts)
    {
      if(!may_be_larger(parts.front()))
        break;
      std::pop_heap(parts.begin(), parts.end());
      const Part part = parts.back();
      parts.pop_back();
      for(const Part& child : cut(t, part, largest, samples))
        add(child);
    }
    return largest;
  }

private:
  static constexpr double large = 8;         // the size, relative to the largest distance, above which slopes are trusted
  static constexpr int certain_level = 3;    // below it, slopes are not trusted if this takes few cuts
  static constexpr double safety = 2;        // of the slopes; it trades time for what may be missed between the corners
  static constexpr double margin = 1.5;      // of the distance to a plane, from which the reference bends away
  static constexpr double rounding = 1e-9;   // relative to the size of the triangle; below it the slopes are noise
  static constexpr double tolerance = 0.002; // of the result; it saves the last few parts
  static constexpr int max_level = 10;       // a part of that level is 1/1024 as long as the triangle
  static constexpr int max_cuts = 256; // it bounds the time where slopes are of little use, as between overlapping sheets

  struct Sample
  {
    Coordinates coordinates; // in the triangle
    Point point;
    Foot foot;
    Plane plane; // that touches the reference there
    double distance;
  };

  using Samples = std::vector<Sample>;

  struct Part
  {
    bool operator<(const Part& other) const { return bound < other.bound; }

    std::array<int, 3> corners; // among the samples
    double slope;               // that the distance may have in it
    int level;                  // how often it was cut
    double bound = 0;           // of the distance in it
  };

  // How often a triangle must be cut until its parts are no larger than the patches of the reference: before, a peak of the
  // reference may be between the corners of a part.
  int level_of_reference(const Triangle& t, const Foot& hint) const
  {
    constexpr int min_level = 2, max_level_of_reference = 3; // they trade time for narrow peaks
    const double patch_area = m_reference.area_at(hint);
    double area = norm(area_normal(t[0], t[1], t[2])) / 2 / (1 << 2 * (min_level - 1));
    int level = min_level;
    for(; level < max_level_of_reference && patch_area > 0 && area > 4 * patch_area; area /= 4)
      ++level;
    return level;
  }

  // how far the points of a triangle are from its nearest corner at most, roughly: exactly if it is equilateral
  static double radius(const Triangle& t)
  {
    return std::sqrt(
      (std::max)({ squared_distance(t[0], t[1]), squared_distance(t[1], t[2]), squared_distance(t[2], t[0]) }) / 3);
  }

  static double upper_bound(const Samples& samples, const Part& part, const double size)
  {
    const Sample &a = samples[part.corners[0]], &b = samples[part.corners[1]], &c = samples[part.corners[2]];
    const double largest = (std::max)({ a.distance, b.distance, c.distance });
    const double radius = std::ldexp(size, -part.level);
    const double to_plane = distance_to_planes(std::array<Point, 3>{ { a.point, b.point, c.point } },
                                               std::array<Plane, 3>{ { a.plane, b.plane, c.plane } });
    return (std::min)(largest + radius, (std::max)(largest + part.slope * radius, margin * to_plane));
  }

  Sample sample(const Triangle& t, const Coordinates& x, const Foot& hint, const double near) const
  {
    const Point p = point_at(t, x);
    const Foot foot = walk_or_search(m_reference, p, hint, near);
    return { x, p, foot, Plane(m_reference, foot), distance_to_foot(p, m_reference, foot) };
  }

  // The four triangles between the corners of a part and the midpoints of its sides, which are sampled. Distances above
  // `largest` are exact.
  std::array<Part, 4> cut(const Triangle& t, const Part& part, const double largest, Samples& samples) const
  {
    const std::array<int, 3>& c = part.corners;
    const double largest_at_corners = (std::max)({ samples[c[0]].distance, samples[c[1]].distance, samples[c[2]].distance });
    const double near = (std::min)(largest, near_by(largest_at_corners, radius(t)));
    std::array<int, 3> m; // opposite to the corners
    for(int k = 0; k < 3; ++k)
    {
      const Sample &a = samples[c[(k + 1) % 3]], &b = samples[c[(k + 2) % 3]];
      const Coordinates middle{ (a.coordinates.u + b.coordinates.u) / 2, (a.coordinates.v + b.coordinates.v) / 2 };
      const auto is_there = [&](const Sample& s) { return s.coordinates.u == middle.u && s.coordinates.v == middle.v; };
      const auto known = std::find_if(samples.begin(), samples.end(), is_there); // from the part on the other side
      m[k] = static_cast<int>(known - samples.begin());
      if(known == samples.end())
        samples.push_back(sample(t, middle, a.foot, near));
    }
    std::array<Part, 4> children{ { { { { c[0], m[2], m[1] } }, 0, 0 },
                                    { { { m[2], c[1], m[0] } }, 0, 0 },
                                    { { { m[1], m[0], c[2] } }, 0, 0 },
                                    { { { m[0], m[1], m[2] } }, 0, 0 } } };
    double steepest = 0;
    for(Part& child : children)
    {
      child.level = part.level + 1;
      child.slope = safety * slope(samples, child);
      steepest = (std::max)(steepest, child.slope);
    }
    // where the distance is smooth its slopes change by half as much over half the length
    double inherited = part.level == 0 ? steepest : part.slope / 2;
    if(radius(t) < large * largest && part.level < certain_level)
      inherited = 1; // no slope is larger; certainty takes few cuts here
    for(Part& child : children)
      child.slope = std::clamp(child.slope, (std::min)(inherited, 1.), 1.);
    return children;
  }

  // the largest slope along the sides of a part
  static double slope(const Samples& samples, const Part& part)
  {
    double result = 0;
    for(int k = 0; k < 3; ++k)
    {
      const Sample &a = samples[part.corners[k]], &b = samples[part.corners[(k + 1) % 3]];
      const double length = std::sqrt(squared_distance(a.point, b.point));
      if(length > 0)
        result = (std::max)(result, std::abs(a.distance - b.distance) / length);
    }
    return result;
  }

  const Reference& m_reference;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FARTHEST_POINT_H
