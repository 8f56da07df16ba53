// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_DEGRADATION_CRITERION_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_DEGRADATION_CRITERION_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Flip_criterion.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Result_distances.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// What the guarantee compares with: M_0 as sampled.
struct Initial_quality
{
  double mean = 0;    // of the distance
  double maximum = 0; // rather less than more
  std::vector<Face_orientation> orientations;
};

// A face violates it if it is flipped, if it opposes more normals of the reference than at first, or if its largest error
// exceeds that of the initial remesh, less a margin for what lies between the samples, and its own at first; once the
// criterion is strict, also if the integral of its error is larger than at first. A face whose vertices have not moved does
// not. A model of the criteria of `shorten_moves()`.
template <typename Reference>
class Degradation_criterion
{
public:
  Degradation_criterion(const Reference& reference,
                        const Remesh& remesh,
                        const Initial_quality& initial,
                        Remesh_sample_offsets<typename Reference::Hint> samples)
    : m_remesh(remesh), m_initial(initial), m_flips(remesh), m_distances(reference, remesh, std::move(samples))
  {}

  // measures the next points
  template <typename ConcurrencyTag>
  void measure()
  {
    m_distances.template measure<ConcurrencyTag>();
  }

  // measures again what has changed with the next point of vertex i
  void update(Index i) { m_distances.update(i); }

  bool is_violated_by(std::size_t f) const
  {
    constexpr double margin = 0.98; // for what lies between the samples
    const double limit = margin * m_initial.maximum;
    return has_moved(f) && (m_flips.is_violated_by(f) || m_distances.orientation(f) > m_initial.orientations[f] ||
                            (is_strict() && m_distances.integral(f) > m_initial_integrals[f]) ||
                            (!(m_distances.maximum(f, limit) <= limit) && m_distances.exceeds_initial_maximum(f)));
  }

  // whether the mean error is clearly below that of the initial remesh
  template <typename ConcurrencyTag>
  bool is_mean_lower() const
  {
    constexpr double margin = 0.9999; // for what lies between the samples
    return m_distances.template mean<ConcurrencyTag>() <= margin * m_initial.mean;
  }

  template <typename ConcurrencyTag>
  void make_strict()
  {
    m_initial_integrals.resize(m_remesh.number_of_faces());
    for_each_index<ConcurrencyTag>(m_initial_integrals.size(),
                                   [&](std::size_t f) { m_initial_integrals[f] = m_distances.initial_integral(f); });
    m_is_strict = true;
  }

  bool is_strict() const { return m_is_strict; }

private:
  bool has_moved(std::size_t f) const
  {
    const auto& v = m_remesh.face(f);
    return std::any_of(v.begin(), v.end(), [&](Index i) { return m_remesh.next_points[i] != m_remesh.initial_points[i]; });
  }

  const Remesh& m_remesh;
  const Initial_quality& m_initial;
  const Flip_criterion m_flips;
  Result_distances<Reference> m_distances;
  std::vector<double> m_initial_integrals; // of the distance over each face, if the criterion is strict
  bool m_is_strict = false;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_DEGRADATION_CRITERION_H
