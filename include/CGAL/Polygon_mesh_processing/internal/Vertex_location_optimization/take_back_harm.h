// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_TAKE_BACK_HARM_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_TAKE_BACK_HARM_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/correct_flips.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Sampled_error.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// What a face of the remesh is compared with.
struct Face_quality
{
  double integral_of_error;
  bool opposes_reference;
};

// A face is bad if it is flipped, if it opposes the reference and did not, or if its largest error exceeds that of the
// remesh, less a margin for what lies between the samples, and its own in the remesh; if the criterion is strict, also if
// it has more error in all than in the remesh. A face whose vertices have not moved is not bad.
template <typename ReferenceSurface>
class Harm_criterion
{
  using State = Optimization_state<typename ReferenceSurface::Foot>;

public:
  // measures the remesh, which are the targets at the time of the call
  template <typename ConcurrencyTag>
  static Harm_criterion of_remesh(Sampled_error<ReferenceSurface>& error, const State& state, ConcurrencyTag)
  {
    Harm_criterion result(error, state);
    error.template sample<ConcurrencyTag>();
    result.m_of_remesh.resize(state.mesh.faces.size());
    result.m_mean_error = error.template mean<ConcurrencyTag>();
    constexpr double margin = 0.98; // for what lies between the samples
    result.m_max_error = margin * error.template maximum<ConcurrencyTag>();
    for_each_index<ConcurrencyTag>(state.mesh.faces.size(), [&](std::size_t f)
    {
      result.m_of_remesh[f] = { error.integral(f), error.opposes_reference(f) };
    });
    return result;
  }

  bool is_bad(std::size_t f) const
  {
    if(!has_moved(f))
      return false;
    return m_flips.is_bad(f) ||
           (m_error.opposes_reference(f) && !m_of_remesh[f].opposes_reference) ||
           (m_is_strict && m_error.integral(f) > m_of_remesh[f].integral_of_error) ||
           (!(m_error.maximum(f, m_max_error) <= m_max_error) && m_error.has_grown(f));
  }

  void update(std::size_t i) { m_error.update(i); }

  double mean_error() const { return m_mean_error; } // of the remesh
  void make_strict() { m_is_strict = true; }
  bool is_strict() const { return m_is_strict; }

private:
  Harm_criterion(Sampled_error<ReferenceSurface>& error, const State& state)
    : m_state(state), m_flips(state), m_error(error)
  {}

  bool has_moved(std::size_t f) const
  {
    for(Index i : m_state.mesh.faces[f])
      if(m_state.targets[i] != m_state.initial_points[i])
        return true;
    return false;
  }

  const State& m_state;
  Flip_criterion<typename ReferenceSurface::Foot> m_flips;
  Sampled_error<ReferenceSurface>& m_error;
  std::vector<Face_quality> m_of_remesh;
  double m_mean_error = 0;
  double m_max_error = 0; // what a face must not exceed
  bool m_is_strict = false;
};

// Halves the moves of the vertices of faces that intersect and did not in the remesh; returns whether there were any.
template <typename Foot, typename FacePairs>
bool separate_faces(Optimization_state<Foot>& state,
                    const FacePairs& of_remesh,
                    const FacePairs& of_targets,
                    std::vector<int>& number_of_halvings,
                    std::vector<char>& is_shortened)
{
  constexpr int max_halvings = 6;

  FacePairs pairs;
  std::set_difference(of_targets.begin(), of_targets.end(), of_remesh.begin(), of_remesh.end(), std::back_inserter(pairs));
  std::set<Index> vertices;
  for(const auto& pair : pairs)
    for(Index f : { pair.first, pair.second })
      vertices.insert(state.mesh.faces[f].begin(), state.mesh.faces[f].end());

  bool separated = false;
  for(Index i : vertices)
    if(state.targets[i] != state.initial_points[i])
    {
      state.targets[i] = ++number_of_halvings[i] > max_halvings ? state.initial_points[i]
                                                                : midpoint(state.initial_points[i], state.targets[i]);
      is_shortened[i] = 1;
      separated = true;
    }
  return separated;
}

// The last word of a run: shortens the moves from the remesh to the result where they do harm, so that neither the
// largest nor the mean error is above that of the remesh, as far as `Sampled_error` sees, no face is flipped and, if
// that is tested, no pair of faces intersects that did not before.
//
// `refuse_moves` takes back the moves that the user does not allow, and returns whether there were any;
// `find_self_intersections` is a `Self_intersection_test`.
template <typename ConcurrencyTag, typename ReferenceSurface, typename RefuseMoves, typename FindSelfIntersections>
void take_back_harm(const ReferenceSurface& reference,
                    Optimization_state<typename ReferenceSurface::Foot>& state,
                    const RefuseMoves& refuse_moves,
                    const FindSelfIntersections& find_self_intersections,
                    std::vector<char>& is_shortened)
{
  Sampled_error<ReferenceSurface> error(reference, state);
  state.targets = state.initial_points;
  auto criterion = Harm_criterion<ReferenceSurface>::of_remesh(error, state, ConcurrencyTag());
  const auto intersections_of_remesh = find_self_intersections(state.initial_points);

  state.targets = state.mesh.points;
  std::vector<int> number_of_halvings(state.targets.size(), 0);
  for(;;)
  {
    do
    {
      error.template sample<ConcurrencyTag>();
      shorten_moves<ConcurrencyTag>(state, state.initial_points, criterion, is_shortened);
    }
    while(refuse_moves());

    if(!(error.template mean<ConcurrencyTag>() <= criterion.mean_error()))
    {
      if(criterion.is_strict()) // no face has more error, but their areas have changed
      {
        for(std::size_t i = 0; i < state.targets.size(); ++i)
          if(state.targets[i] != state.initial_points[i])
          {
            state.targets[i] = state.initial_points[i];
            is_shortened[i] = 1;
          }
        break;
      }
      criterion.make_strict();
    }
    else if(!separate_faces(state, intersections_of_remesh, find_self_intersections(state.targets),
                            number_of_halvings, is_shortened))
      break;
  }
  state.mesh.points = state.targets;
}

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_TAKE_BACK_HARM_H
