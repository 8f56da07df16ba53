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
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Fold_criterion.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Initial_quality.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/New_intersections.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Result_distances.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/shorten_moves.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Volume_correction.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Sampling/Area_samples.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Sampling/Remesh_samples.h>

#include <CGAL/Polygon_mesh_processing/Vertex_location_optimization_report.h>

#include <algorithm>
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
// Each stage halves moves where they violate it and no others; one that was halved often is taken back.
//
// `AllowMove` is a functor (i, source, target) -> bool, `FindSelfIntersections` is a `Self_intersection_test`.
template <typename ConcurrencyTag, typename Reference, typename AllowMove, typename FindSelfIntersections>
class Guarantee
{
  using Indices = std::vector<Index>;

  struct Reference_normals
  {
    auto operator()(std::size_t f) const { return distances.reference_normals(f); }

    const Result_distances<Reference>& distances;
  };

  struct Shape_criterion
  {
    bool is_violated_by(std::size_t f) const { return flips.is_violated_by(f) || folds.is_violated_by(f); }

    Flip_criterion flips;
    Fold_criterion<Reference_normals> folds;
  };

public:
  // `samples` and `area_samples` are those of the points of the remesh
  Guarantee(const Reference& reference,
            Initial_quality& initial,
            const Smallest_angles& smallest_angles,
            Remesh_sample_offsets<typename Reference::Hint> samples,
            Points_and_faces area_samples,
            const AllowMove& allow_move,
            const FindSelfIntersections& find_self_intersections,
            Remesh& remesh,
            Corrections& corrections)
    : m_initial(initial), m_distances(reference, remesh, std::move(samples)),
      m_distances_from_reference(reference, remesh, std::move(area_samples)),
      m_shapes{ { remesh, smallest_angles }, { remesh, Reference_normals{ m_distances } } }, m_allow_move(allow_move),
      m_new_intersections(remesh, find_self_intersections), m_remesh(remesh), m_corrections(corrections),
      m_is_worse(remesh.number_of_faces(), false), m_number_of_halvings(remesh.points.size(), 0)
  {}

  void enforce()
  {
    keep_shapes();
    m_distances.template measure<ConcurrencyTag>();
    m_distances_from_reference.template measure<ConcurrencyTag>();
    for_each_index<ConcurrencyTag>(m_is_worse.size(), [&](std::size_t f) { m_is_worse[f] = is_worse(f); });
    while(shorten(vertices_with_most_worse_faces(), Correction::ERROR) ||
          shorten(vertices_that_raise_mean(), Correction::ERROR) ||
          shorten(vertices_that_raise_maximum_from_reference(), Correction::ERROR) ||
          shorten(vertices_that_raise_mean_from_reference(), Correction::ERROR) ||
          shorten(m_new_intersections.find_vertices(), Correction::INTERSECTION))
    {
      keep_shapes();
      measure_again();
    }
  }

  // Moves the vertices along the normals until the remesh encloses `volume`, but for those where that would do harm; returns
  // false, and leaves all where they are, if that is impossible.
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

  Approximation_error error() const
  {
    Approximation_error result = m_distances.template error<ConcurrencyTag>();
    result.max = m_distances.maximum();
    return result;
  }

  // 0 if that is not sampled
  Approximation_error error_from_reference() const
  {
    Approximation_error result = m_distances_from_reference.template error<ConcurrencyTag>();
    if(!m_distances_from_reference.empty())
      result.max = m_distances_from_reference.maximum();
    return result;
  }

private:
  void measure_again()
  {
    const Indices changed = m_distances.template update<ConcurrencyTag>();
    m_distances_from_reference.template update<ConcurrencyTag>(changed);
    for_each_index<ConcurrencyTag>(changed.size(), [&](std::size_t k) { m_is_worse[changed[k]] = is_worse(changed[k]); });
  }

  // The vertices with moves that violate one of the guarantees.
  std::set<Index> harmed_vertices()
  {
    measure_again();
    std::set<Index> result = m_new_intersections.find_vertices();
    for(std::size_t f = 0; f < m_remesh.number_of_faces(); ++f)
      if(m_is_worse[f] || m_shapes.is_violated_by(f))
        result.insert(m_remesh.face(f).begin(), m_remesh.face(f).end());
    for(const Indices& vertices : { vertices_that_raise_mean(), vertices_that_raise_maximum_from_reference(),
                                    vertices_that_raise_mean_from_reference() })
      result.insert(vertices.begin(), vertices.end());
    for(std::size_t i = 0; i < m_remesh.points.size(); ++i)
      if(is_moved(i) && !m_allow_move(i, m_remesh.initial_points[i], m_remesh.next_points[i]))
        result.insert(static_cast<Index>(i));
    return result;
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
  bool is_worse(std::size_t f) const
  {
    constexpr double margin = 0.99; // for what is between the samples
    return has_moved(f) &&
           (m_distances.orientation(f) > m_initial.orientations[f] || m_distances.exceeds(f, margin * m_initial.error.max));
  }

  // of each face that is worse the vertex with the most of them
  Indices vertices_with_most_worse_faces() const
  {
    const auto key = [&](Index i) {
      int number = -m_number_of_halvings[i];
      m_remesh.for_each_corner(i, [&](Index c) { number += m_is_worse[c / 3]; });
      return number;
    };
    Indices result;
    for(Index f : find_indices<ConcurrencyTag>(m_is_worse.size(), [&](std::size_t f) { return m_is_worse[f]; }))
    {
      Index best = no_index;
      for(Index i : m_remesh.face(f))
        if(is_moved(i) && (best == no_index || key(i) > key(best) || (key(i) == key(best) && i < best)))
          best = i;
      if(best != no_index)
        result.push_back(best);
    }
    return result;
  }

  bool is_lower(double mean, double initial) const
  {
    // of the difference of two means; what is gained must be more, or it may be none
    constexpr double accuracy = 0.0075;
    constexpr double rounding = 1e-12; // relative to the lengths of edges; for where there is no distance
    const auto longest = std::max_element(m_remesh.lengths.begin(), m_remesh.lengths.end());
    return longest == m_remesh.lengths.end() || mean <= (1 - accuracy) * initial + rounding * *longest;
  }

  // If the mean is not lower than at first: the vertices whose faces have contributed to that.
  Indices vertices_that_raise_mean()
  {
    if(is_lower(mean(), m_initial.error.mean))
      return {};
    if(!m_distances.is_exact())
      measure_exactly();
    if(is_lower(mean(), m_initial.error.mean))
      return {};
    // A face raises the mean by its integral less that of the mean over its area.
    std::vector<double> changes(m_remesh.number_of_faces());
    for_each_index<ConcurrencyTag>(changes.size(), [&](std::size_t f) {
      const double growth = m_remesh.area(f, m_remesh.next_points) - m_remesh.area(f, m_remesh.initial_points);
      changes[f] = m_distances.integral(f) - m_initial_integrals[f] - m_initial.error.mean * growth;
    });
    return vertices_with_positive_sum(changes);
  }

  double mean() const { return m_distances.template error<ConcurrencyTag>().mean; }

  // the distances to the reference, at first and now
  void measure_exactly()
  {
    m_distances.template measure_exactly<ConcurrencyTag>();
    m_initial_integrals.resize(m_remesh.number_of_faces());
    for_each_index<ConcurrencyTag>(m_initial_integrals.size(),
                                   [&](std::size_t f) { m_initial_integrals[f] = m_distances.initial_integral(f); });
    Error_integral sum;
    for(std::size_t f = 0; f < m_initial_integrals.size(); ++f)
      sum += { m_remesh.area(f, m_remesh.initial_points), m_initial_integrals[f], 0, 0 };
    m_initial.error.mean = sum.error().mean;
  }

  // The vertices that have moved and among which the changes of their faces, shared by those that have moved, have a
  // positive sum; all that have moved if there is none. While the sum over all faces is positive there is one.
  Indices vertices_with_positive_sum(const std::vector<double>& changes) const
  {
    std::vector<double> sums(m_remesh.points.size(), 0);
    for(std::size_t f = 0; f < changes.size(); ++f)
    {
      const auto& v = m_remesh.face(f);
      const auto number = std::count_if(v.begin(), v.end(), [&](Index i) { return is_moved(i); });
      for(Index i : v)
        if(is_moved(i))
          sums[i] += changes[f] / number;
    }
    const Indices result = find_indices<ConcurrencyTag>(sums.size(), [&](std::size_t i) { return sums[i] > 0; });
    return !result.empty() ? result : find_indices<ConcurrencyTag>(sums.size(), [&](std::size_t i) { return is_moved(i); });
  }

  Indices vertices_that_raise_maximum_from_reference() const
  {
    Indices faces;
    for(const Distant_sample& sample : m_distances_from_reference.find_distant(m_initial.error_from_reference.max))
      for(Index f : { sample.initial_face, sample.face })
        faces.push_back(f);
    return vertices_of(faces);
  }

  Indices vertices_that_raise_mean_from_reference()
  {
    const auto is_enough = [&] {
      constexpr double rounding = 1e-12; // it need not be lower: it is not what is optimized
      return m_distances_from_reference.template error<ConcurrencyTag>().mean <=
             (1 + rounding) * m_initial.error_from_reference.mean;
    };
    if(is_enough())
      return {};
    if(!m_distances_from_reference.is_exact())
    {
      m_distances_from_reference.template measure_exactly<ConcurrencyTag>();
      m_initial.error_from_reference.mean = m_distances_from_reference.initial_mean();
    }
    if(is_enough())
      return {};
    std::vector<double> changes(m_remesh.number_of_faces(), 0);
    m_distances_from_reference.for_each_change([&](Index f, double growth) { changes[f] += growth; });
    return vertices_with_positive_sum(changes);
  }

  Indices vertices_of(const Indices& faces) const
  {
    Indices result;
    for(Index f : faces)
      if(f < m_remesh.number_of_faces()) // not of the surroundings
        result.insert(result.end(), m_remesh.face(f).begin(), m_remesh.face(f).end());
    return result;
  }

  // Halves the moves of these vertices, or takes them back if that has been done often enough; returns whether there were any.
  template <typename Vertices>
  bool shorten(const Vertices& vertices, const Correction reason)
  {
    // they bound the time; afterwards moves are taken back
    const int max_rounds = m_distances.is_exact() ? 5 : 10;
    bool is_shortened = false;
    for(Index i : std::set<Index>(vertices.begin(), vertices.end()))
      if(is_moved(i))
      {
        if(m_round >= max_rounds)
          m_remesh.next_points[i] = m_remesh.initial_points[i];
        else
          halve_move(m_remesh.initial_points[i], m_remesh.next_points[i], m_number_of_halvings[i]);
        m_corrections.add(i, reason);
        is_shortened = true;
      }
    m_round += is_shortened;
    return is_shortened;
  }

  bool has_moved(std::size_t f) const
  {
    const auto& v = m_remesh.face(f);
    return std::any_of(v.begin(), v.end(), [&](Index i) { return is_moved(i); });
  }

  bool is_moved(std::size_t i) const { return m_remesh.next_points[i] != m_remesh.initial_points[i]; }

  Initial_quality& m_initial; // its means become exact if they must
  Result_distances<Reference> m_distances;
  Distances_from_reference<Reference> m_distances_from_reference;
  Shape_criterion m_shapes;
  const AllowMove& m_allow_move;
  New_intersections<FindSelfIntersections> m_new_intersections;
  Remesh& m_remesh;
  Corrections& m_corrections;
  std::vector<char> m_is_worse; // of the faces
  std::vector<unsigned char> m_number_of_halvings;
  std::vector<double> m_initial_integrals; // of the distance over each face, once they are needed
  int m_round = 0;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_GUARANTEE_H
