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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_VERTEX_LOCATION_OPTIMIZER_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_VERTEX_LOCATION_OPTIMIZER_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/Vertex_location_optimization_report.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Flip_criterion.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Guarantee.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/shorten_moves.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Placement/Feature_placement.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Placement/measure_regularity.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Placement/Placement.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Algorithm 1: moves the vertices of the remesh to where its faces approximate the reference best, and ensures that the
// result is no worse than the input. `AllowMove` is a functor (i, source, target) -> bool, `FindSelfIntersections` is a
// `Self_intersection_test`.
template <typename ConcurrencyTag, typename Reference, typename AllowMove, typename FindSelfIntersections, typename Visitor>
class Vertex_location_optimizer
{
  using Phase = Vertex_location_optimization_phase;
  using Report = Vertex_location_optimization_report;

public:
  Vertex_location_optimizer(const Reference& reference,
                            const Optimization_options& options,
                            const AllowMove& allow_move,
                            const FindSelfIntersections& find_self_intersections,
                            Visitor& visitor,
                            Remesh& remesh)
    : m_reference(reference), m_options(options), m_allow_move(allow_move),
      m_find_self_intersections(find_self_intersections), m_visitor(visitor), m_remesh(remesh), m_smallest_angles(remesh),
      m_corrections(remesh.points.size())
  {}

  Report run(std::unique_ptr<Placement<Reference>> placement)
  {
    Feature_placement features(m_reference.feature_curves(), m_remesh);
    while(m_report.iterations < m_options.number_of_iterations && !m_report.converged && iterate(*placement, features))
      m_visitor.end_iteration(m_report);
    if(m_report.iterations == 0)
      return m_report;

    enforce_guarantee(std::move(placement));
    return m_report;
  }

private:
  // One iteration, from M_t to the next points; false if the visitor ended it. Then these are the points of M_t.
  bool iterate(Placement<Reference>& placement, Feature_placement& features)
  {
    if(!start_phase(Phase::SAMPLE_REFERENCE))
      return false;
    m_remesh.advance();
    sample(placement, features);

    if(!find_next_points(placement, features))
    {
      m_remesh.next_points = m_remesh.points;
      return false;
    }
    report_iteration(placement.has_settled());
    return true;
  }

  void sample(Placement<Reference>& placement, Feature_placement& features)
  {
    if(m_report.iterations == 0)
    {
      Initial_measure measure = placement.start();
      m_initial_quality =
        measure_initial_quality<ConcurrencyTag>(m_reference, m_remesh, placement.samples(), std::move(measure));
    }
    else
      placement.resample(iteration());
    features.template resample<ConcurrencyTag>(m_remesh, placement.samples().vertices, placement.samples().midpoints);
  }

  bool find_next_points(Placement<Reference>& placement, Feature_placement& features)
  {
    if(!start_phase(Phase::PLACE_VERTICES))
      return false;
    placement.place(iteration());
    features.template place<ConcurrencyTag>(m_remesh, !iteration().is_free);

    if(!start_phase(Phase::RELAX_VERTICES))
      return false;
    if(iteration().is_free) // later, no move along the surface needs a counterforce
    {
      placement.relax();
      features.relax(m_remesh, m_options.number_of_relaxation_steps.value_or(default_number_of_relaxation_steps));
    }

    if(!start_phase(Phase::CORRECT_FLIPS))
      return false;
    correct_flips();
    return true;
  }

  void correct_flips()
  {
    keep_points_finite();
    const Flip_criterion criterion(m_remesh, m_smallest_angles);
    do
      shorten_moves<ConcurrencyTag>(m_remesh, m_remesh.points, criterion, m_corrections);
    while(refuse_moves(m_remesh, m_remesh.points, m_allow_move, m_corrections));
  }

  // where coordinates are so large that their products overflow
  void keep_points_finite()
  {
    for_each_index<ConcurrencyTag>(m_remesh.points.size(), [&](std::size_t i) {
      if(!is_finite(m_remesh.next_points[i]))
        m_remesh.next_points[i] = m_remesh.points[i];
    });
  }

  // Also if the visitor has ended the iterations, as their outcome must be checked before it is a result.
  void enforce_guarantee(std::unique_ptr<Placement<Reference>> placement)
  {
    m_visitor.start_phase(Phase::ENFORCE_GUARANTEE);
    auto samples = std::move(placement->samples()).take_offsets();
    placement.reset();
    Guarantee<ConcurrencyTag, Reference, AllowMove, FindSelfIntersections> guarantee(
      m_reference, m_initial_quality, m_smallest_angles, std::move(samples), m_options.guarantee_both_directions,
      m_allow_move, m_find_self_intersections, m_remesh, m_corrections);
    guarantee.enforce();
    if(m_options.preserve_volume && m_remesh.is_closed() && m_reference.is_closed())
      m_report.is_volume_preserved = guarantee.enclose(m_reference.template volume<ConcurrencyTag>());
    m_remesh.advance();
    report_result(guarantee);
  }

  template <typename Guarantee>
  void report_result(Guarantee& guarantee)
  {
    count_corrected_vertices();
    m_report.moved_vertices = m_remesh.number_of_moved_vertices();
    m_report.volume_change = m_remesh.is_closed() ? volume_change(m_remesh) : 0;
    m_report.initial_error = m_report.final_error = m_initial_quality.error;
    if(m_report.moved_vertices > 0)
      m_report.final_error = guarantee.error();
    if(!m_options.guarantee_both_directions)
      return;
    m_report.initial_error_from_reference = m_report.final_error_from_reference = guarantee.initial_error_from_reference();
    if(m_report.moved_vertices > 0)
      m_report.final_error_from_reference = guarantee.error_from_reference();
  }

  // Once the vertices have settled, one more iteration with exact samples follows.
  void report_iteration(const bool settles)
  {
    m_report.converged = m_has_settled || (settles && iteration().is_last);
    m_has_settled = settles;
    m_report.displacement = m_remesh.largest_displacement();
    ++m_report.iterations;
    count_corrected_vertices();
  }

  Iteration iteration() const
  {
    const std::size_t number = m_report.iterations;
    return { number, number < m_options.number_of_free_iterations, number == m_options.number_of_free_iterations,
             m_has_settled || number + 1 == m_options.number_of_iterations };
  }

  bool start_phase(const Phase phase)
  {
    if(!m_visitor.go_further())
      return false;
    m_visitor.start_phase(phase);
    return true;
  }

  void count_corrected_vertices()
  {
    m_report.corrected_vertices = m_corrections.count();
    m_report.corrected_for_shape = m_corrections.count(Correction::SHAPE);
    m_report.corrected_for_error = m_corrections.count(Correction::ERROR);
    m_report.corrected_for_intersection = m_corrections.count(Correction::INTERSECTION);
    m_report.refused_vertices = m_corrections.count(Correction::REFUSAL);
  }

  const Reference& m_reference;
  const Optimization_options& m_options;
  const AllowMove& m_allow_move;
  const FindSelfIntersections& m_find_self_intersections;
  Visitor& m_visitor;
  Remesh& m_remesh;
  Initial_quality m_initial_quality;
  const Smallest_angles m_smallest_angles;
  Corrections m_corrections;
  bool m_has_settled = false; // the vertices have not moved farther than the threshold
  Report m_report;
};

// Whether the guarantee has moved most of the mesh back, with little gain: with the present weight, regularity and a smaller
// error exclude each other.
inline bool is_in_vain(const Vertex_location_optimization_report& report, const Remesh& remesh)
{
  constexpr double small_gain = 0.02;
  return 2 * report.corrected_for_error > remesh.points.size() &&
         report.final_error.mean > (1 - small_gain) * report.initial_error.mean;
}

// `remesh.points` are the result. If the weight of the regularity turns out to be too large for any gain, smaller ones are
// tried. The best result is chosen among those whose mean angle is not smaller than that of M_0, so that an optimized mesh
// does not keep trading angles for the error. `make_placement(options)` makes a placement.
template <typename ConcurrencyTag,
          typename Reference,
          typename AllowMove,
          typename FindSelfIntersections,
          typename Visitor,
          typename MakePlacement>
Vertex_location_optimization_report optimize(const Reference& reference,
                                             const Optimization_options& options,
                                             const AllowMove& allow_move,
                                             const FindSelfIntersections& find_self_intersections,
                                             Visitor& visitor,
                                             const MakePlacement& make_placement,
                                             Remesh& remesh)
{
  using Optimizer = Vertex_location_optimizer<ConcurrencyTag, Reference, AllowMove, FindSelfIntersections, Visitor>;
  constexpr int max_attempts = 3; // they bound the time
  constexpr double factor = 0.25; // from attempt to attempt
  const auto run = [&](const Optimization_options& of_attempt) {
    return Optimizer(reference, of_attempt, allow_move, find_self_intersections, visitor, remesh)
      .run(make_placement(of_attempt));
  };

  Vertex_location_optimization_report best = run(options);
  if(options.placement_method != LEAST_SQUARES || options.regularity_weight == 0.)
    return best;
  Optimization_options of_attempt = options;
  for(int attempt = 1; attempt < max_attempts && is_in_vain(best, remesh) && visitor.go_further(); ++attempt)
  {
    const std::vector<Point> best_points = remesh.points;
    remesh.restart();
    of_attempt.part_of_regularity *= factor;
    const Vertex_location_optimization_report report = run(of_attempt);
    if(report.final_error.mean < best.final_error.mean &&
       mean_smallest_angle(remesh, remesh.points) >= mean_smallest_angle(remesh, remesh.initial_points))
      best = report;
    else
      remesh.points = best_points;
  }
  return best;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_VERTEX_LOCATION_OPTIMIZER_H
