// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_GUARANTEE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_GUARANTEE_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Degradation_criterion.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/New_intersections.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/shorten_moves.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Sampling/Remesh_samples.h>

#include <boost/range/irange.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Measures what the guarantee compares with, in the first iteration, when M_0 has been sampled.
template <typename ConcurrencyTag, typename Reference>
Initial_quality measure_initial_quality(const Reference& reference,
                                        const Remesh& remesh,
                                        const Remesh_samples<Reference>& samples,
                                        Initial_measure measure)
{
  constexpr double close = 0.9; // the lattice on a face with smaller samples is thought to have no larger maximum
  constexpr int max_faces = 64;
  const auto sampled_maximum = [&](std::size_t f) { return measure.distances.maximum(remesh, f); };
  const auto all = boost::irange<std::size_t>(0, remesh.number_of_faces());
  std::array<std::size_t, max_faces> faces; // with the largest samples
  const auto end =
    std::partial_sort_copy(all.begin(), all.end(), faces.begin(), faces.end(),
                           [&](std::size_t f, std::size_t g) { return sampled_maximum(f) > sampled_maximum(g); });

  Initial_quality quality;
  quality.mean = mean_distance<ConcurrencyTag>(remesh, remesh.points, measure.distances);
  for(auto f = faces.begin(); f != end && sampled_maximum(*f) > close * quality.maximum; ++f)
  {
    const auto farthest =
      Farthest_point<Reference>(reference).of_lattice(remesh.triangle(*f), samples.vertices.hint(remesh.first_vertex(*f)));
    quality.maximum = (std::max)(quality.maximum, farthest.distance);
  }
  quality.orientations = std::move(measure.orientations);
  return quality;
}

// The end of a run: shortens the moves from the initial to the next points, so that neither the largest nor the mean error
// is above that of the initial remesh, as sampled, no face is flipped and, if that is tested, no pair of faces intersects
// that did not before.
//
// `AllowMove` is a functor (i, source, target) -> bool, `FindSelfIntersections` is a `Self_intersection_test`.
template <typename ConcurrencyTag, typename Reference, typename AllowMove, typename FindSelfIntersections>
class Guarantee
{
public:
  // `samples` are those of the points of the remesh
  Guarantee(const Reference& reference,
            const Initial_quality& initial,
            Remesh_sample_offsets<typename Reference::Hint> samples,
            const AllowMove& allow_move,
            const FindSelfIntersections& find_self_intersections,
            Remesh& remesh,
            std::vector<bool>& is_corrected)
    : m_criterion(reference, remesh, initial, std::move(samples)), m_allow_move(allow_move),
      m_new_intersections(remesh, find_self_intersections), m_remesh(remesh), m_is_corrected(is_corrected),
      m_number_of_halvings(remesh.points.size(), 0)
  {}

  void enforce()
  {
    do
      keep_each_face();
    while(!(keep_mean() && keep_apart()));
  }

private:
  // No face violates the criterion afterwards, and the user allows all moves.
  void keep_each_face()
  {
    do
    {
      m_criterion.template measure<ConcurrencyTag>();
      shorten_moves<ConcurrencyTag>(m_remesh, m_remesh.initial_points, m_criterion, m_is_corrected);
    }
    while(refuse_moves(m_remesh, m_remesh.initial_points, m_allow_move));
  }

  // Whether the mean error is lower than at first. If not, no face may have more error any more; if that was so already,
  // and it is the areas that have changed, there is no result.
  bool keep_mean()
  {
    if(m_criterion.template is_mean_lower<ConcurrencyTag>())
      return true;
    if(!m_criterion.is_strict())
    {
      m_criterion.template make_strict<ConcurrencyTag>();
      return false;
    }
    for(std::size_t i = 0; i < m_remesh.points.size(); ++i)
      if(is_moved(i))
      {
        m_remesh.next_points[i] = m_remesh.initial_points[i];
        m_is_corrected[i] = true;
      }
    return true;
  }

  // Halves the moves of the vertices of faces that intersect and did not at first; returns whether there were none.
  bool keep_apart()
  {
    bool is_apart = true;
    for(Index i : m_new_intersections.find_vertices())
      if(is_moved(i))
      {
        halve_move(m_remesh.initial_points[i], m_remesh.next_points[i], m_number_of_halvings[i]);
        m_is_corrected[i] = true;
        is_apart = false;
      }
    return is_apart;
  }

  bool is_moved(std::size_t i) const { return m_remesh.next_points[i] != m_remesh.initial_points[i]; }

  Degradation_criterion<Reference> m_criterion;
  const AllowMove& m_allow_move;
  New_intersections<FindSelfIntersections> m_new_intersections;
  Remesh& m_remesh;
  std::vector<bool>& m_is_corrected;
  std::vector<unsigned char> m_number_of_halvings; // of the moves of vertices of faces that intersect
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_GUARANTEE_H
