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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PIECEWISE_LINEAR_PLACEMENT_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PIECEWISE_LINEAR_PLACEMENT_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Placement/for_each_sum_over_faces.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Placement/measure_regularity.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Placement/piecewise_linear_update.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Placement/Placement.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Placement/springs.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

inline Optimization_options piecewise_linear_defaults() { return { PIECEWISE_LINEAR, 1e-6, false }; }

// The sums of equation (2) over the faces of a vertex.
struct Piecewise_linear_sums
{
  Vector update = NULL_VECTOR; // weighted by the areas
  double area = 0;

  Piecewise_linear_sums& operator+=(const Piecewise_linear_sums& other)
  {
    update = update + other.update;
    area += other.area;
    return *this;
  }
};

// The paper's method, sections 3.2 and 3.3: the piecewise linear surface closest to the samples, fitted vertex by vertex
// over the faces around each, with springs between the vertices.
template <typename ConcurrencyTag, typename Reference>
class Piecewise_linear_placement : public Placement<Reference>
{
  using Base = Placement<Reference>;
  using Base::m_reference;
  using Base::m_remesh;
  using Base::m_samples;

public:
  Piecewise_linear_placement(const Reference& reference, Remesh& remesh, const Optimization_options& options)
    : Base(reference, remesh, Sample_set::MIDPOINT_LOCATIONS),
      m_convergence_threshold(options.convergence_threshold.value()),
      m_number_of_relaxation_steps(options.number_of_relaxation_steps)
  {}

  Initial_measure start() override
  {
    if(!m_number_of_relaxation_steps)
      m_regularity = measure_regularity(m_remesh);
    return m_samples.template start<ConcurrencyTag>(m_reference, m_remesh);
  }

  void resample(const Iteration& iteration) override
  {
    if(iteration.is_last)
      m_samples.template project<ConcurrencyTag>(m_reference, m_remesh);
    else
      m_samples.template update<ConcurrencyTag>(m_reference, m_remesh, tolerance(iteration));
  }

  // The fit is to the displacements from M_t to the samples, weighted by the areas of the faces of M_t: M_t itself is linear
  // in each face and cancels out. After the free iterations, only the component of the update along n_i is applied, measured
  // from p_i. A vertex whose faces have no area does not move.
  void place(const Iteration& iteration) override
  {
    const auto sums_of_face = [&](std::size_t f) {
      const std::array<Index, 3>&vertices = m_remesh.face(f), &edges = m_remesh.face_edges[f];
      const auto p = [&](Index k) -> const Vector& { return m_samples.vertices.offset(vertices[k]); };
      const auto m = [&](Index k) -> const Vector& { return m_samples.midpoints.offset(edges[k]); };
      const double area = m_remesh.area(f);
      std::array<Piecewise_linear_sums, 3> sums;
      for(Index k = 0; k < 3; ++k)
        sums[k] = { area * piecewise_linear_update(k, p, m), area };
      return sums;
    };

    for_each_sum_over_faces<ConcurrencyTag, Piecewise_linear_sums>(
      m_remesh, sums_of_face, [&](std::size_t i, const Piecewise_linear_sums& sums) {
        m_remesh.next_points[i] = m_remesh.points[i];
        if(!m_remesh.is_free(i) || !(sums.area > 0))
          return;

        Vector update = sums.update / sums.area; // (2)
        const Vector& n = m_samples.vertices.normal(i);
        if(!iteration.is_free)
          update = (update * n) * n;
        m_remesh.next_points[i] = m_remesh.points[i] + (m_samples.vertices.offset(i) + update);
      });
  }

  void relax() override
  {
    relax_springs<ConcurrencyTag>(
      m_remesh, m_number_of_relaxation_steps.value_or(default_number_of_relaxation_steps),
      [&](std::size_t i) { return m_regularity.empty() ? 1. : m_regularity[i]; },
      [&](std::size_t i) -> const Vector& { return m_samples.vertices.normal(i); });
  }

  bool has_settled() override
  {
    double largest2 = 0; // displacement, relative to the lengths
    for(std::size_t i = 0; i < m_remesh.points.size(); ++i)
      if(m_remesh.next_points[i] != m_remesh.points[i])
        largest2 =
          (std::max)(largest2, squared_distance(m_remesh.next_points[i], m_remesh.points[i]) / square(m_remesh.lengths[i]));
    return std::sqrt(largest2) <= m_convergence_threshold;
  }

private:
  // A vertex that moves along the normal keeps its foot: once all samples have been searched when these iterations begin,
  // they remain valid.
  Sampling_tolerance tolerance(const Iteration& iteration) const
  {
    constexpr double max_travel = 0.04, max_distance = 0.05; // they trade exactness for time
    return { iteration.is_first_along_normals ? 0 : max_travel, max_distance, iteration.is_free };
  }

  const double m_convergence_threshold;
  const std::optional<std::size_t> m_number_of_relaxation_steps;
  std::vector<double> m_regularity; // of M_0; empty if the user has chosen the springs
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PIECEWISE_LINEAR_PLACEMENT_H
