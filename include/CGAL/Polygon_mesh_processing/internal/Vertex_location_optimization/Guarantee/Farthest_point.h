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

// Finds the point of a triangle that is farthest from the reference, by branch and bound: the triangle is cut into parts,
// first where it may be farthest away, until none can have a distance above the largest one known. The distance changes no
// faster than the point: it exceeds that at the nearest corner by no more than the way there. Usually, much less is added: if
// the reference were its tangent plane at the point closest to a corner, the largest distance would be at a corner, and the
// differences between the distances of the corners from the reference and from this plane tell how the reference bends. For a
// triangle not much larger than the distance itself, only the first bound is used.
template <typename Reference>
class Farthest_point
{
  using Foot = typename Reference::Foot;
  using Triangle = std::array<Point, 3>;

public:
  explicit Farthest_point(const Reference& reference) : m_reference(reference) {}

  // The largest distance of a triangle if that is larger than `bound`; otherwise `bound`. `hints` are feet of
  // points near its corners. With `is_any_enough` it is not the largest distance, but one that is larger than `bound`.
  double
  operator()(const Triangle& t, const std::array<Foot, 3>& hints, const double bound, const bool is_any_enough = false) const
  {
    const double size = radius(t);
    const int min_level = level_of_reference(t, hints[0]);
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
      const bool is_certain = part.level < certain_level && size < large * largest;
      part.bound =
        part.level < min_level ? std::numeric_limits<double>::infinity() : upper_bound(samples, part, size, is_certain);
      if(!may_be_larger(part))
        return;
      parts.push_back(part);
      std::push_heap(parts.begin(), parts.end());
    };
    samples.push_back(sample(t, { 0, 0 }, hints[0], near));
    samples.push_back(sample(t, { 1, 0 }, hints[1], near));
    samples.push_back(sample(t, { 0, 1 }, hints[2], near));
    add({ { { 0, 1, 2 } }, 0 });
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
  static constexpr double large = 8;         // the size, relative to the largest distance, above which planes are trusted
  static constexpr int certain_level = 3;    // below it, planes are not trusted if this takes few cuts
  static constexpr double safety = 3;        // of what the reference bends by; it trades time for what may be missed
  static constexpr double rounding = 1e-9;   // relative to the size of the triangle; below it distances are noise
  static constexpr double tolerance = 0.002; // of the result; it saves the last few parts
  static constexpr int max_level = 10;       // a part of that level is 1/1024 as long as the triangle
  static constexpr int max_cuts = 256;       // it bounds the time between overlapping sheets

  struct Sample
  {
    Coordinates coordinates; // in the triangle
    Point point;
    Foot foot;
    Tangent_plane<Reference> plane; // that touches the reference there
    double distance;
  };

  using Samples = std::vector<Sample>;

  struct Part
  {
    bool operator<(const Part& other) const { return bound < other.bound; }

    std::array<int, 3> corners; // among the samples
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
  static double radius(const Triangle& t) { return std::sqrt(squared_longest_side(t) / 3); }

  // of the distance in a part; `size` is the radius of the triangle
  static double upper_bound(const Samples& samples, const Part& part, const double size, const bool is_certain)
  {
    const std::array<const Sample*, 3> corners{ { &samples[part.corners[0]], &samples[part.corners[1]],
                                                  &samples[part.corners[2]] } };
    double largest = 0, bend = std::numeric_limits<double>::infinity();
    for(const Sample* a : corners)
    {
      double from_plane = 0;
      for(const Sample* b : corners)
        from_plane = (std::max)(from_plane, std::abs(b->distance - a->plane.distance(b->point)));
      bend = (std::min)(bend, from_plane);
      largest = (std::max)(largest, a->distance);
    }
    const double radius = std::ldexp(size, -part.level);
    return largest + (is_certain ? radius : (std::min)(radius, safety * bend));
  }

  Sample sample(const Triangle& t, const Coordinates& x, const Foot& hint, const double near) const
  {
    const Point p = point_at(t, x);
    const auto [foot, signed_distance] = walk_or_search(m_reference, p, hint, near);
    return { x, p, foot, Tangent_plane<Reference>(m_reference, foot), std::abs(signed_distance) };
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
    const int level = part.level + 1;
    return { { { { { c[0], m[2], m[1] } }, level },
               { { { m[2], c[1], m[0] } }, level },
               { { { m[1], m[0], c[2] } }, level },
               { { { m[0], m[1], m[2] } }, level } } };
  }

  const Reference& m_reference;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FARTHEST_POINT_H
