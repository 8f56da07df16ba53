// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_VERTEX_LOCATION_OPTIMIZER_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_VERTEX_LOCATION_OPTIMIZER_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Flip_criterion.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Placement/Feature_placement.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Placement/Least_squares_placement.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Placement/Piecewise_linear_placement.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Placement/relax_springs.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Sampling/Area_samples.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Sampling/Remesh_samples.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/take_back_harm.h>
#include <CGAL/Polygon_mesh_processing/Placement_method.h>
#include <CGAL/Polygon_mesh_processing/Vertex_location_optimization_report.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

struct Allow_all_moves
{
  template <typename Vertex, typename Point>
  bool operator()(const Vertex&, const Point&, const Point&) const { return true; }
};

// The parameters of the user, first with their defaults.
struct Options
{
  explicit Options(const Placement_method method)
    : placement_method(method),
      // where LEAST_SQUARES ends with this the mean error is within 2% of that after twice as many iterations
      convergence_threshold(method == LEAST_SQUARES ? 7.5e-4 : 1e-6),
      do_self_intersection_tests(method == LEAST_SQUARES)
  {}

  Placement_method placement_method;
  double convergence_threshold; // relative to the mean edge length
  bool do_self_intersection_tests;
  std::size_t number_of_iterations = 30;
  std::size_t number_of_free_iterations = 20;
  std::size_t number_of_relaxation_steps = 1;
  double regularity_weight = 0.15; // of LEAST_SQUARES
};

// Algorithm 1: moves the vertices of the mesh in `state` to where its faces approximate `reference` best. `InitialPoints`
// are `Initial_points`, `AllowMove` is a functor (i, source, target) -> bool, `FindSelfIntersections` is a
// `Self_intersection_test`.
template <typename ConcurrencyTag,
          typename ReferenceSurface,
          typename InitialPoints,
          typename AllowMove,
          typename FindSelfIntersections,
          typename Visitor>
class Vertex_location_optimizer
{
  using State = Optimization_state<Hint_of<ReferenceSurface>>;

public:
  Vertex_location_optimizer(State& state,
                            const ReferenceSurface& reference,
                            const Options& options,
                            const InitialPoints& initial_points,
                            const AllowMove& allow_move,
                            const FindSelfIntersections& find_self_intersections,
                            Visitor& visitor)
    : m_state(state), m_reference(reference), m_options(options), m_initial_points(initial_points),
      m_allow_move(allow_move), m_find_self_intersections(find_self_intersections), m_visitor(visitor),
      m_feature_edges(Feature_curves_of<ReferenceSurface>::get(reference), state),
      m_harm_criterion(reference, state), m_is_shortened(state.mesh.points.size())
  {}

  Vertex_location_optimization_report run()
  {
    while(m_report.iterations < m_options.number_of_iterations && !m_report.converged && iterate())
      m_visitor.end_iteration(m_report);
    if(m_report.iterations > 0)
      take_back();
    return m_report;
  }

private:
  // one iteration; false if the visitor stopped it
  bool iterate()
  {
    if(!start_phase(SAMPLE_REFERENCE))
      return false;
    sample();

    if(!start_phase(FIT_VERTICES))
      return false;
    fit();

    if(!start_phase(RELAX_VERTICES))
      return false;
    relax();

    if(!start_phase(CORRECT_FLIPS))
      return false;
    correct();

    move_vertices();
    return true;
  }

  bool is_least_squares() const { return m_options.placement_method == LEAST_SQUARES; }
  bool is_first() const { return m_report.iterations == 0; }

  // The smaller the error of the remesh, the less of it is given for regularity. 6% of the edge length is a large one.
  double relative_regularity_weight() const
  {
    const double large_error = 0.06 * m_state.mean_edge_length;
    return m_options.regularity_weight * std::sqrt(m_harm_criterion.mean_of_remesh() / large_error);
  }

  bool is_last() const { return m_has_settled || m_report.iterations + 1 == m_options.number_of_iterations; }

  // vertices move freely; later only along the normal
  bool is_free() const { return m_report.iterations < m_options.number_of_free_iterations; }

  // How far off the samples may be before the last iteration. Along the normal a vertex moves over its
  // foot, and the feet stay as they are when that begins.
  Sampling_tolerance tolerance() const
  {
    const double length = m_state.mean_edge_length, distance = 0.05 * length;
    if(is_least_squares())
      return { std::clamp(10 * m_displacement_along_normals, 0.02 * length, 0.1 * length), distance, true };
    const bool is_first_along_normal = m_report.iterations == m_options.number_of_free_iterations;
    return { is_first_along_normal ? 0 : 0.04 * length, distance, is_free() };
  }

  void sample()
  {
    if(is_first())
    {
      start_samples<ConcurrencyTag>(m_reference, m_state, [&](std::size_t f, const auto& foot)
      {
        m_harm_criterion.set_barycenter_of_remesh(f, foot);
      });
      m_harm_criterion.template measure_remesh<ConcurrencyTag>();
      if(is_least_squares())
        start_samples_of_reference<ConcurrencyTag>(m_reference, m_state, m_of_reference);
    }
    else if(is_last())
    {
      sample_closest_points<ConcurrencyTag>(m_reference, m_state);
      if(is_least_squares())
        walk_to_closest_faces<ConcurrencyTag>(m_state, -1, m_of_reference); // all
    }
    else
    {
      update_samples<ConcurrencyTag>(m_reference, tolerance(), m_state);
      if(is_least_squares())
        walk_to_closest_faces<ConcurrencyTag>(m_state, tolerance().path, m_of_reference);
    }
    m_feature_edges.sample<ConcurrencyTag>(m_state);
    m_is_sampled = true;
  }

  void fit()
  {
    if(is_least_squares())
      fit_least_squares<ConcurrencyTag>(m_state, m_of_reference, relative_regularity_weight());
    else
      fit_piecewise_linear<ConcurrencyTag>(m_state, !is_free());
    m_feature_edges.fit<ConcurrencyTag>(m_state, !is_free());
  }

  // Once only the part along the normal is taken nothing moves a vertex along the surface.
  void relax()
  {
    if(!is_free())
      return;
    if(!is_least_squares())
      relax_springs<ConcurrencyTag>(m_state, m_options.number_of_relaxation_steps);
    m_feature_edges.relax(m_state, m_options.number_of_relaxation_steps);
  }

  void correct()
  {
    keep_non_finite_targets_away();
    m_state.initial_points = m_initial_points.all();
    do
      correct_flips<ConcurrencyTag>(m_state, m_is_shortened);
    while(refuse_moves(m_state.mesh.points));
    release(m_state.initial_points);
  }

  // Also if the visitor has stopped the iterations: what they have reached is not the result before it is checked.
  void take_back()
  {
    m_visitor.start_phase(TAKE_BACK_HARM);
    if(m_is_sampled)
      m_state.targets = m_state.mesh.points;
    else
      m_state.mesh.points.swap(m_state.targets); // back to where the samples were taken
    m_of_reference = Samples_of_reference();
    for(auto* samples : { &m_state.vertex_samples, &m_state.midpoint_samples, &m_state.barycenter_samples })
      samples->end_updates();

    m_state.initial_points = m_initial_points.all();
    take_back_harm<ConcurrencyTag>(m_harm_criterion, m_state, [&]() { return refuse_moves(m_state.initial_points); },
                                   m_find_self_intersections, m_is_shortened);
    count_corrected_vertices();
  }

  bool start_phase(Vertex_location_optimization_phase phase)
  {
    if(!m_visitor.go_further())
      return false;
    m_visitor.start_phase(phase);
    return true;
  }

  // where coordinates are so large that their products overflow
  void keep_non_finite_targets_away()
  {
    for_each_index<ConcurrencyTag>(m_state.targets.size(), [&](std::size_t i)
    {
      if(!is_finite(m_state.targets[i]))
        m_state.targets[i] = m_state.mesh.points[i];
    });
  }

  // Takes back the moves from `sources` to the targets that the user does not allow; returns whether there were any.
  bool refuse_moves(const std::vector<Point>& sources)
  {
    bool refused = false;
    for(std::size_t i = 0; i < m_state.targets.size(); ++i)
    {
      const Point& source = sources[i];
      Point& target = m_state.targets[i];
      if(target != source && !m_allow_move(i, source, target))
      {
        target = source;
        refused = true;
      }
    }
    return refused;
  }

  void move_vertices()
  {
    double largest2 = 0, along_normals2 = 0;
    for(std::size_t i = 0; i < m_state.targets.size(); ++i)
    {
      const Vector displacement = m_state.targets[i] - m_state.mesh.points[i];
      largest2 = (std::max)(largest2, displacement.squared_length());
      along_normals2 += square(displacement * m_state.vertex_samples.normal(i));
    }
    m_state.mesh.points.swap(m_state.targets);
    m_is_sampled = false;

    m_report.displacement = std::sqrt(largest2);
    const double last_along_normals = m_displacement_along_normals;
    m_displacement_along_normals = std::sqrt(along_normals2 / (std::max)(m_state.targets.size(), std::size_t(1)));
    // with LEAST_SQUARES vertices swing about the surface first, those whose moves are shortened always, and all slide on
    const double displacement = is_least_squares() ? (std::max)(last_along_normals, m_displacement_along_normals)
                                                   : m_report.displacement;
    const bool settles = displacement <= m_options.convergence_threshold * m_state.mean_edge_length;
    m_report.converged = m_has_settled || (settles && is_last());
    m_has_settled = settles;
    ++m_report.iterations;
    count_corrected_vertices();
  }

  void count_corrected_vertices()
  {
    m_report.corrected_vertices = std::count(m_is_shortened.begin(), m_is_shortened.end(), true);
  }

  State& m_state;
  const ReferenceSurface& m_reference;
  const Options m_options;
  const InitialPoints& m_initial_points;
  const AllowMove& m_allow_move;
  const FindSelfIntersections& m_find_self_intersections;
  Visitor& m_visitor;
  Feature_edges m_feature_edges;
  Samples_of_reference m_of_reference; // of LEAST_SQUARES
  Harm_criterion<ReferenceSurface> m_harm_criterion;
  std::vector<bool> m_is_shortened;
  bool m_is_sampled = false;  // the samples are those of the points, not of the targets, where the points were
  bool m_has_settled = false; // the vertices have not moved farther than the threshold
  double m_displacement_along_normals = 0; // in the last iteration, root mean square
  Vertex_location_optimization_report m_report;
};

template <typename ConcurrencyTag,
          typename ReferenceSurface,
          typename InitialPoints,
          typename AllowMove,
          typename FindSelfIntersections,
          typename Visitor>
Vertex_location_optimization_report optimize(Optimization_state<Hint_of<ReferenceSurface>>& state,
                                             const ReferenceSurface& reference,
                                             const Options& options,
                                             const InitialPoints& initial_points,
                                             const AllowMove& allow_move,
                                             const FindSelfIntersections& find_self_intersections,
                                             Visitor& visitor)
{
  return Vertex_location_optimizer<ConcurrencyTag, ReferenceSurface, InitialPoints, AllowMove, FindSelfIntersections, Visitor>(
    state, reference, options, initial_points, allow_move, find_self_intersections, visitor).run();
}

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_VERTEX_LOCATION_OPTIMIZER_H
