// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FLIP_CRITERION_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FLIP_CRITERION_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// A face violates it if it is flipped: the next points turn its normal by more than 60 degrees from that of the initial
// ones; or if it collapses: its smallest angle falls below 10 degrees and below half of the initial one. A face without an
// area at first never does. A model of the criteria of `shorten_moves()`.
class Flip_criterion
{
public:
  explicit Flip_criterion(const Remesh& remesh) : m_remesh(remesh) {}

  bool is_violated_by(std::size_t f) const
  {
    constexpr double cosine_of_flip = 0.5;
    constexpr double sine_of_collapse = 0.17364817766693036; // of 10 degrees

    const std::array<Point, 3> before = m_remesh.triangle(f, m_remesh.initial_points),
                               after = m_remesh.triangle(f, m_remesh.next_points);
    const Vector m = area_normal(before[0], before[1], before[2]), n = area_normal(after[0], after[1], after[2]);
    const double area_before = norm(m), area_after = norm(n);
    if(!(area_before > 0))
      return false;
    if(!(m * n > cosine_of_flip * area_before * area_after))
      return true;

    const double squared_sine = squared_sine_of_smallest_angle(after, area_after);
    if(squared_sine >= square(sine_of_collapse))
      return false;
    const double squared_sine_before = squared_sine_of_smallest_angle(before, area_before);
    const double cosine_before = std::sqrt((std::max)(0., 1 - squared_sine_before));
    return squared_sine < squared_sine_before / (2 * (1 + cosine_before)); // of half the angle
  }

  void update(std::size_t) {}

private:
  // the smallest angle is between the two longest sides
  static double squared_sine_of_smallest_angle(const std::array<Point, 3>& t, const double twice_area)
  {
    const double a = squared_distance(t[0], t[1]), b = squared_distance(t[1], t[2]), c = squared_distance(t[2], t[0]);
    return square(twice_area) / (std::max)({ a * b, b * c, c * a });
  }

  const Remesh& m_remesh;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FLIP_CRITERION_H
