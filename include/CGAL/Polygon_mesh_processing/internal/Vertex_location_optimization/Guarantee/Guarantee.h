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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_GUARANTEE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_GUARANTEE_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Distances_from_reference.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Flip_criterion.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Initial_quality.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Mean_comparison.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Moves.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/New_intersections.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Result_distances.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Shape_criterion.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/shorten_moves.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Volume_correction.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Sampling/Remesh_samples.h>

#include <CGAL/Polygon_mesh_processing/Vertex_location_optimization_report.h>

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The end of a run: shortens the moves from the initial to the next points where they do harm, so that
//   - no face is flipped, collapses, opposes the reference where it did not, or gets a sharper fold;
//   - neither the largest nor the mean distance to the reference is above that of the initial remesh and, if that is
//     asked for, neither of those from the reference;
//   - no pair of faces intersects, if that is tested, that did not before.
// Each stage halves only moves that violate its condition, for a number of rounds that bounds the time, and then takes moves
// back.
//
// `AllowMove` is a functor (i, source, target) -> bool, `FindSelfIntersections` is a `Self_intersection_test`.
template <typename ConcurrencyTag, typename Reference, typename AllowMove, typename FindSelfIntersections>
class Guarantee
{
  using Indices = std::vector<Index>;

  struct Stage
  {
    Correction reason;
    int max_halvings; // the number of rounds, which trades time for larger remaining moves
    int round = 0;

    bool takes_back() const { return round >= max_halvings; }
  };

public:
  // `samples` are those of the points of the remesh
  Guarantee(const Reference& reference,
            const Initial_quality& initial,
            const Smallest_angles& smallest_angles,
            Remesh_sample_offsets<typename Reference::Hint> samples,
            const bool guarantees_both_directions,
            const AllowMove& allow_move,
            const FindSelfIntersections& find_self_intersections,
            Remesh& remesh,
            Corrections& corrections)
    : m_initial(initial), m_distances(reference, remesh, initial, std::move(samples)),
      m_distances_from_reference(reference, remesh), m_shapes(remesh, smallest_angles, m_distances),
      m_allow_move(allow_move), m_new_intersections(remesh, find_self_intersections), m_remesh(remesh),
      m_corrections(corrections), m_moves(remesh, corrections), m_mean(remesh, initial, m_distances, m_moves),
      m_is_worse(remesh.number_of_faces(), false), m_is_judged(remesh.number_of_faces(), false)
  {
    if(guarantees_both_directions)
      m_distances_from_reference.template start<ConcurrencyTag>([&](std::size_t f) { return m_distances.hint(f); });
  }

  void enforce()
  {
    keep_shapes();
    m_distances.template measure<ConcurrencyTag>();
    m_distances_from_reference.template measure<ConcurrencyTag>();
    Stage mean{ Correction::ERROR, 2 }, faces{ Correction::ERROR, 8 }, maximum_back{ Correction::ERROR, 5 },
      mean_back{ Correction::ERROR, 2 }, intersections{ Correction::INTERSECTION, 3 };
    while(lower_mean(mean) || shorten(faces, vertices_of_worse_faces(faces.takes_back())) ||
          shorten(maximum_back, vertices_that_raise_maximum_from_reference()) || lower_mean_from_reference(mean_back) ||
          shorten(intersections, m_new_intersections.find_vertices()))
    {
      keep_shapes();
      measure_again();
    }
  }

  // Moves the vertices along the normals until the remesh encloses `volume`, except for those where this would do harm;
  // returns false, and moves none, if this is impossible.
  bool enclose(const double volume)
  {
    constexpr int max_attempts = 10;
    const std::vector<Point> points = m_remesh.next_points;
    std::vector<char> can_move(points.size());
    for(std::size_t i = 0; i < points.size(); ++i)
      can_move[i] = m_remesh.is_free(i);
    for(int attempt = 0; attempt < max_attempts; ++attempt)
    {
      if(!Volume_correction(m_remesh, points, [&](Index i) { return can_move[i]; }).enclose(volume, m_remesh.next_points))
        break;
      const std::set<Index> harmed = harmed_vertices();
      if(harmed.empty())
        return true;
      for(Index i : harmed)
        can_move[i] = false;
    }
    m_remesh.next_points = points;
    measure_again();
    return false;
  }

  Approximation_error error()
  {
    m_distances.template complete<ConcurrencyTag>();
    Approximation_error result = m_distances.template error<ConcurrencyTag>();
    result.max = m_distances.maximum();
    return result;
  }

  // these are 0 if that is not sampled

  Approximation_error initial_error_from_reference() const
  {
    return m_distances_from_reference.template initial_error<ConcurrencyTag>();
  }

  Approximation_error error_from_reference() const { return m_distances_from_reference.template error<ConcurrencyTag>(); }

private:
  void measure_again()
  {
    const Indices changed = m_distances.template update<ConcurrencyTag>();
    m_distances_from_reference.template update<ConcurrencyTag>(changed);
    for(Index f : changed)
      m_is_judged[f] = false;
  }

  // The vertices with moves that violate one of the guarantees.
  std::set<Index> harmed_vertices()
  {
    measure_again();
    judge_faces();
    std::set<Index> result = m_new_intersections.find_vertices();
    for(std::size_t f = 0; f < m_remesh.number_of_faces(); ++f)
      if(m_is_worse[f] || m_shapes.is_violated_by(f))
        result.insert(m_remesh.face(f).begin(), m_remesh.face(f).end());
    const auto add = [&](const Indices& vertices) { result.insert(vertices.begin(), vertices.end()); };
    add(vertices_that_raise_maximum_from_reference());
    if(!m_mean.template is_lower<ConcurrencyTag>())
      add(vertices_that_raise(m_mean.template initial_integrals_and_changes<ConcurrencyTag>().second));
    m_distances_from_reference.template measure_exactly<ConcurrencyTag>();
    if(!is_mean_from_reference_kept())
      add(vertices_that_raise(m_distances_from_reference.initial_integrals_and_changes().second));
    for(std::size_t i = 0; i < m_remesh.points.size(); ++i)
      if(m_moves.is_moved(i) && !m_allow_move(i, m_remesh.initial_points[i], m_remesh.next_points[i]))
        result.insert(static_cast<Index>(i));
    return result;
  }

  // The vertices whose moves have raised a mean, from the changes of the integrals over the faces; all moved vertices if there
  // are none, as the mean may then have risen between the samples.
  Indices vertices_that_raise(const std::vector<double>& changes) const
  {
    const Indices raising = m_moves.vertices_with_positive_sum(changes);
    return raising.empty() ? m_moves.moved_vertices() : raising;
  }

  // No face is flipped, collapses or gets a sharper fold afterwards, and the user allows all moves.
  void keep_shapes()
  {
    do
    {
      shorten_moves<ConcurrencyTag>(m_remesh, m_remesh.initial_points, m_shapes, m_corrections);
    }
    while(refuse_moves(m_remesh, m_remesh.initial_points, m_allow_move, m_corrections));
  }

  // Whether face f has moved and its largest distance exceeds that of the initial remesh and its own at first, or it opposes
  // more normals of the reference than at first.
  bool is_worse(std::size_t f)
  {
    constexpr double margin = 0.99; // for what is between the samples
    return m_moves.has_moved(f) &&
           (m_distances.orientation(f) > m_initial.orientations[f] || m_distances.exceeds(f, margin * m_initial.error.max));
  }

  void judge_faces()
  {
    for_each_index<ConcurrencyTag>(m_is_worse.size(), [&](std::size_t f) {
      if(!m_is_judged[f])
        m_is_worse[f] = is_worse(f);
      m_is_judged[f] = true;
    });
  }

  // all of them, or of each such face the vertex with the most of them
  Indices vertices_of_worse_faces(const bool all)
  {
    judge_faces();
    return all ? vertices_of(find_indices<ConcurrencyTag>(m_is_worse.size(), [&](std::size_t f) { return m_is_worse[f]; }))
               : m_moves.vertices_with_most(m_is_worse);
  }

  // Shortens the moves that have raised the mean, unless it is lower than at first; returns whether there were any.
  bool lower_mean(Stage& stage)
  {
    if(m_mean.template is_lower<ConcurrencyTag>())
      return false;
    const auto [initial, changes] = m_mean.template initial_integrals_and_changes<ConcurrencyTag>();
    return shorten_raising(stage, initial, changes);
  }

  Indices vertices_that_raise_maximum_from_reference()
  {
    Indices faces;
    for(const Distant_point& point : m_distances_from_reference.template find_distant<ConcurrencyTag>())
      for(Index f : { point.initial_face, point.face })
        faces.push_back(f);
    return vertices_of(faces);
  }

  bool lower_mean_from_reference(Stage& stage)
  {
    if(is_mean_from_reference_kept())
      return false;
    m_distances_from_reference.template measure_exactly<ConcurrencyTag>();
    if(is_mean_from_reference_kept())
      return false;
    const auto [initial, changes] = m_distances_from_reference.initial_integrals_and_changes();
    return shorten_raising(stage, initial, changes);
  }

  bool is_mean_from_reference_kept() const
  {
    return m_distances_from_reference.template is_mean_kept<ConcurrencyTag>(m_mean.negligible_distance());
  }

  Indices vertices_of(const Indices& faces) const
  {
    Indices result;
    for(Index f : faces)
      if(f < m_remesh.number_of_faces()) // not of the surroundings
        result.insert(result.end(), m_remesh.face(f).begin(), m_remesh.face(f).end());
    return result;
  }

  template <typename Vertices>
  bool shorten(Stage& stage, const Vertices& vertices)
  {
    const bool is_shortened = m_moves.shorten(vertices, stage.reason, stage.takes_back());
    stage.round += is_shortened;
    return is_shortened;
  }

  bool shorten_raising(Stage& stage, const std::vector<double>& initial, const std::vector<double>& changes)
  {
    constexpr int max_rounds = 8; // they bound the time; afterwards all moves are taken back
    const bool is_shortened = stage.round < max_rounds ? m_moves.shorten_raising(initial, changes, stage.takes_back())
                                                       : m_moves.shorten(m_moves.moved_vertices(), stage.reason, true);
    stage.round += is_shortened;
    return is_shortened;
  }

  const Initial_quality& m_initial;
  Result_distances<Reference> m_distances;
  Distances_from_reference<Reference> m_distances_from_reference;
  Shape_criterion<Result_distances<Reference>> m_shapes;
  const AllowMove& m_allow_move;
  New_intersections<FindSelfIntersections> m_new_intersections;
  Remesh& m_remesh;
  Corrections& m_corrections;
  Moves m_moves;
  const Mean_comparison<Reference> m_mean;
  std::vector<char> m_is_worse, m_is_judged; // of the faces: whether it violates the guarantee, and whether that is known
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_GUARANTEE_H
