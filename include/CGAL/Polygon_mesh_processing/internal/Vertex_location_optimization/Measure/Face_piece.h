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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACE_PIECE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACE_PIECE_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/Quadratic_interpolant.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Reference_access.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// A point of a face and what is closest to it on the reference.
template <typename Reference>
struct Distance_sample
{
  using Foot = typename Reference::Foot;

  Distance_sample() = default;
  Distance_sample(const Point& p, const Reference& reference, const Foot& foot, bool exact = true)
    : point(p), offset(reference.point(foot) - p), distance(norm(offset)), patch_area(reference.area_at(foot)), foot(foot),
      is_exact(exact)
  {}

  Point point;
  Vector offset; // to the closest point
  double distance;
  double patch_area; // of the patch that the closest point is in
  Foot foot;
  bool is_exact; // otherwise, the closest point may be another one
};

// A piece of a face, with samples at its corners and at the midpoints of the sides opposite to them.
template <typename Reference>
struct Face_piece
{
  using Sample = Distance_sample<Reference>;

  // of a whole face; take_sample(p, s) is the sample at p, which is near the sample s
  template <typename TakeSample>
  Face_piece(const std::array<Sample, 3>& samples, const TakeSample& take_sample) : corners(samples)
  {
    for(int k = 0; k < 3; ++k)
      midpoints[k] = halfway(corners[(k + 1) % 3], corners[(k + 2) % 3], take_sample);
  }

  // of a whole face, with no samples but those at its corners
  explicit Face_piece(const std::array<Sample, 3>& samples) : corners(samples), m_has_midpoints(false) {}

  // the pieces at the corners, and the middle one
  template <typename TakeSample>
  std::array<Face_piece, 4> split(const TakeSample& take_sample) const
  {
    std::array<Face_piece, 4> pieces;
    for(int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      const Sample inner = halfway(midpoints[j], midpoints[k], take_sample);
      pieces[i].corners = { corners[i], midpoints[k], midpoints[j] };
      pieces[i].midpoints = { inner, halfway(midpoints[j], corners[i], take_sample),
                              halfway(midpoints[k], corners[i], take_sample) };
      pieces[3].corners[i] = midpoints[i];
      pieces[3].midpoints[i] = inner;
    }
    return pieces;
  }

  // the point with these coordinates, and a sample that is near it
  std::pair<Point, const Sample&> at(const Coordinates& x) const
  {
    const std::array<double, 3> lambda = x.barycentric();
    const auto farthest = std::min_element(lambda.begin(), lambda.end()) - lambda.begin();
    const auto nearest = std::max_element(lambda.begin(), lambda.end()) - lambda.begin();
    return { point_at(triangle(), x), m_has_midpoints ? midpoints[farthest] : corners[nearest] };
  }

  std::array<Point, 3> triangle() const { return { corners[0].point, corners[1].point, corners[2].point }; }

  // The area of the details of the distance here: that of the patches of the reference, whose effect blurs with the
  // distance.
  double area_of_detail() const
  {
    constexpr double blur = 0.25;
    double sum = 0, least = corners[0].distance;
    for_each_sample([&](const Sample& s) {
      sum += s.patch_area;
      least = (std::min)(least, s.distance);
    });
    return (std::max)(sum / (m_has_midpoints ? 6 : 3), blur * square(least));
  }

  double largest_distance() const { return farthest_sample().distance; }

  const Sample& farthest_sample() const
  {
    const Sample* farthest = &corners[0];
    for_each_sample([&](const Sample& s) { farthest = s.distance > farthest->distance ? &s : farthest; });
    return *farthest;
  }

  // of those that are exact
  double largest_exact_distance() const
  {
    double largest = 0;
    for_each_sample([&](const Sample& s) { largest = (std::max)(largest, s.is_exact ? s.distance : 0.); });
    return largest;
  }

  // How much larger the distance may be between the samples: no more than a point is away from the nearest one.
  double largest_rise() const
  {
    constexpr double farthest_from_corners = 0.5773502691896258; // in a triangle, relative to its longest side
    return farthest_from_corners * (m_has_midpoints ? 0.5 : 1) * std::sqrt(squared_longest_side(triangle()));
  }

  // Probably no larger than this: the slope of the distance is the sine of the angle between the direction to the closest
  // point and the normal of the face.
  double probable_rise(const Vector& face_normal) const
  {
    constexpr double least_slope = 0.1, margin = 2;
    const double far = 0.5 * largest_distance();
    double least_cosine2 = 1;
    for_each_sample([&](const Sample& s) {
      if(s.distance > far)
        least_cosine2 = (std::min)(least_cosine2, square((s.offset * face_normal) / s.distance));
    });
    return (std::min)(1., least_slope + margin * std::sqrt((std::max)(0., 1 - least_cosine2))) * largest_rise();
  }

  // The distance, interpolated. It has a kink where the surfaces cross, unless it has a sign: that of the side of the face
  // on which the reference is. Where there is no such side, or another sheet is closest on the other side, it has none.
  Quadratic_interpolant interpolate(const Vector& face_normal) const
  {
    constexpr double least_cosine = 0.3, negligible = 0.05; // relative to the largest distance
    const double far = negligible * largest_distance();
    double least = 0, largest = 0;
    bool is_ambiguous = false;
    const auto with_sign = [&](const Sample& s) {
      const double height = s.offset * face_normal;
      const double distance = std::copysign(s.distance, height);
      least = (std::min)(least, distance);
      largest = (std::max)(largest, distance);
      is_ambiguous = is_ambiguous || (s.distance > far && !(std::abs(height) >= least_cosine * s.distance));
      return distance;
    };
    const auto all = [](const std::array<Sample, 3>& s, const auto& value) -> std::array<double, 3> {
      return { value(s[0]), value(s[1]), value(s[2]) };
    };
    const std::array<double, 3> at_corners = all(corners, with_sign),
                                at_midpoints = m_has_midpoints ? all(midpoints, with_sign) : halfway(at_corners);
    // a distance changes no faster than the point
    if(least < 0 && largest > 0 && (is_ambiguous || square(largest - least) > squared_longest_side(triangle())))
    {
      const auto without_sign = [](const Sample& s) { return s.distance; };
      const std::array<double, 3> c = all(corners, without_sign);
      return Quadratic_interpolant(c, m_has_midpoints ? all(midpoints, without_sign) : halfway(c));
    }
    return Quadratic_interpolant(at_corners, at_midpoints);
  }

  std::array<Sample, 3> corners, midpoints;

private:
  static std::array<double, 3> halfway(const std::array<double, 3>& c)
  {
    return { (c[1] + c[2]) / 2, (c[2] + c[0]) / 2, (c[0] + c[1]) / 2 };
  }

  Face_piece() = default;
  friend std::array<Face_piece, 4>;

  bool m_has_midpoints = true;

  template <typename TakeSample>
  static Sample halfway(const Sample& a, const Sample& b, const TakeSample& take_sample)
  {
    return take_sample(midpoint(a.point, b.point), b);
  }

  template <typename F>
  void for_each_sample(const F& f) const
  {
    std::for_each(corners.begin(), corners.end(), f);
    if(m_has_midpoints)
      std::for_each(midpoints.begin(), midpoints.end(), f);
  }
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACE_PIECE_H
