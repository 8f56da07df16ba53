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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MEAN_COMPARISON_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MEAN_COMPARISON_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Initial_quality.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Moves.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Result_distances.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Uncertain_sum.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Compares the mean distance to the reference with that of the initial points, face by face: only faces that have moved can
// differ, whatever the samples of the others say.
template <typename Reference>
class Mean_comparison
{
public:
  Mean_comparison(const Remesh& remesh,
                  const Initial_quality& initial,
                  const Result_distances<Reference>& distances,
                  const Moves& moves)
    : m_remesh(remesh), m_initial(initial), m_distances(distances), m_moves(moves)
  {}

  // Whether the mean has fallen by more than the uncertainty of the samples; otherwise, it may have risen.
  template <typename ConcurrencyTag>
  bool is_lower() const
  {
    const auto total = sum_over_faces<ConcurrencyTag, Uncertain_sum>([&](std::size_t f) {
      return Uncertain_sum{ change(f), variance(f) };
    });
    const double area =
      sum_over_faces<ConcurrencyTag, double>([&](std::size_t f) { return m_remesh.area(f, m_remesh.initial_points); });
    return total.upper_bound() <= negligible_distance() * area;
  }

  // The integrals of the distance over the faces: at first, and by how much they have grown.
  template <typename ConcurrencyTag>
  std::pair<std::vector<double>, std::vector<double>> initial_integrals_and_changes() const
  {
    std::vector<double> initial(m_remesh.number_of_faces()), changes(initial.size());
    for_each_index<ConcurrencyTag>(changes.size(), [&](std::size_t f) {
      initial[f] = m_remesh.area(f, m_remesh.initial_points) * (std::max)(0.f, m_initial.means[f]);
      changes[f] = change(f);
    });
    return { std::move(initial), std::move(changes) };
  }

  // what is less is rounding
  double negligible_distance() const
  {
    constexpr double rounding = 1e-12; // relative to the lengths of the edges
    const auto longest = std::max_element(m_remesh.lengths.begin(), m_remesh.lengths.end());
    return longest == m_remesh.lengths.end() ? 0 : rounding * *longest;
  }

private:
  template <typename ConcurrencyTag, typename T, typename F>
  T sum_over_faces(const F& f) const
  {
    return sum_over_indices<ConcurrencyTag, T>(m_remesh.number_of_faces(), f);
  }

  // How the integral over face f has grown, less that of the mean over what its area has grown by: the mean has fallen if
  // the sum of these is negative.
  double change(std::size_t f) const
  {
    if(!m_moves.has_moved(f))
      return 0;
    const double area = m_remesh.area(f, m_remesh.initial_points);
    const double growth = m_remesh.area(f, m_remesh.next_points) - area;
    return m_distances.integral(f) - area * m_initial.means[f] - m_initial.error.mean * growth;
  }

  // of that
  double variance(std::size_t f) const
  {
    const auto of_integral = [&](const std::vector<Point>& points, double standard_error) {
      return square(m_remesh.area(f, points) * standard_error);
    };
    return m_moves.has_moved(f) ? of_integral(m_remesh.initial_points, m_initial.standard_errors[f]) +
                                    of_integral(m_remesh.next_points, m_distances.standard_error(f))
                                : 0;
  }

  const Remesh& m_remesh;
  const Initial_quality& m_initial;
  const Result_distances<Reference>& m_distances;
  const Moves& m_moves;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MEAN_COMPARISON_H
