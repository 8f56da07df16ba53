// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_TAKE_BACK_HARM_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_TAKE_BACK_HARM_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Flip_criterion.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Sampled_error.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// A face is bad if it is flipped, if it opposes more normals of the reference than in the remesh, or if its largest error
// exceeds that of the remesh, less a margin for what lies between the samples, and its own in the remesh; if the criterion
// is strict, also if it has more error in all than in the remesh. A face whose vertices have not moved is not bad.
template <typename ReferenceSurface>
class Harm_criterion
{
  using Foot = typename ReferenceSurface::Foot;
  using Hint = Hint_of<ReferenceSurface>;
  using State = Optimization_state<Hint>;

public:
  Harm_criterion(const ReferenceSurface& reference, State& state)
    : m_state(state), m_flips(state), m_error(reference, state)
  {}

  // takes the foot of the barycenter of face f of the remesh
  void set_barycenter_of_remesh(std::size_t f, const Foot& foot) { m_error.set_barycenter(f, foot); }

  // takes the remesh, in the first iteration when it has been sampled, to compare with
  template <typename ConcurrencyTag>
  void measure_remesh()
  {
    constexpr double margin = 0.98; // for what lies between the samples
    m_mean_of_remesh = m_error.template mean<ConcurrencyTag>();
    m_max_error = margin * m_error.maximum();
    const std::size_t n = m_state.mesh.number_of_faces();
    m_is_some_opposed_in_remesh.resize(n);
    m_is_all_opposed_in_remesh.resize(n);
    for(std::size_t f = 0; f < n; ++f)
    {
      m_is_some_opposed_in_remesh[f] = m_error.opposition(f) != Opposition::NONE;
      m_is_all_opposed_in_remesh[f] = m_error.opposition(f) == Opposition::ALL;
    }
    m_error.free_memory();
  }

  double mean_of_remesh() const { return m_mean_of_remesh; }

  // measures the targets
  template <typename ConcurrencyTag>
  void measure_targets()
  {
    m_error.template sample<ConcurrencyTag>();
  }

  // whether the targets' mean error is not clearly below that of the remesh
  template <typename ConcurrencyTag>
  bool is_mean_bad() const
  {
    constexpr double margin = 0.9999; // for what lies between the samples
    return !(m_error.template mean<ConcurrencyTag>() <= margin * m_mean_of_remesh);
  }

  bool is_bad(std::size_t f) const
  {
    if(!has_moved(f))
      return false;
    return m_flips.is_bad(f) ||
           m_error.opposition(f) > opposition_in_remesh(f) ||
           (is_strict() && m_error.integral(f) > m_integrals_of_remesh[f]) ||
           (!(m_error.maximum(f, m_max_error) <= m_max_error) && m_error.has_grown(f));
  }

  void update(Index i) { m_error.update(i); }

  template <typename ConcurrencyTag>
  void make_strict()
  {
    m_integrals_of_remesh.resize(m_state.mesh.number_of_faces());
    for_each_index<ConcurrencyTag>(m_integrals_of_remesh.size(), [&](std::size_t f)
    {
      m_integrals_of_remesh[f] = m_error.integral_in_remesh(f);
    });
    m_is_strict = true;
  }

  bool is_strict() const { return m_is_strict; }

private:
  bool has_moved(std::size_t f) const
  {
    for(Index i : m_state.mesh.face(f))
      if(m_state.targets[i] != m_state.initial_points[i])
        return true;
    return false;
  }

  Opposition opposition_in_remesh(std::size_t f) const
  {
    return m_is_all_opposed_in_remesh[f] ? Opposition::ALL
                                         : m_is_some_opposed_in_remesh[f] ? Opposition::SOME : Opposition::NONE;
  }

  const State& m_state;
  Flip_criterion<Hint> m_flips;
  Sampled_error<ReferenceSurface> m_error;
  std::vector<double> m_integrals_of_remesh; // of the error over each face, if the criterion is strict
  std::vector<bool> m_is_some_opposed_in_remesh, m_is_all_opposed_in_remesh; // normals, by each face
  double m_mean_of_remesh = 0;
  double m_max_error = 0; // what a face must not exceed
  bool m_is_strict = false;
};

// Finds the pairs of faces that intersect with the targets and do not in the remesh.
template <typename FindSelfIntersections>
class Find_new_intersections
{
  using Face_pairs = std::vector<typename FindSelfIntersections::Face_pair>;

public:
  explicit Find_new_intersections(const FindSelfIntersections& find) : m_find(find) {}

  template <typename Hint>
  Face_pairs operator()(const Optimization_state<Hint>& state)
  {
    const Face_pairs of_targets = m_find(state.targets);
    if(of_targets.empty())
      return {};
    if(!m_knows_remesh)
      m_of_remesh = m_find(state.initial_points);
    m_knows_remesh = true;
    Face_pairs result;
    std::set_difference(of_targets.begin(), of_targets.end(), m_of_remesh.begin(), m_of_remesh.end(),
                        std::back_inserter(result));
    return result;
  }

private:
  const FindSelfIntersections& m_find;
  bool m_knows_remesh = false; // it is tested only where the targets have any
  Face_pairs m_of_remesh;
};

// Halves the moves of the vertices of these pairs of faces; returns whether there were any.
template <typename Hint, typename FacePairs>
bool separate_faces(Optimization_state<Hint>& state,
                    const FacePairs& pairs,
                    std::vector<unsigned char>& number_of_halvings,
                    std::vector<bool>& is_shortened)
{
  std::set<Index> vertices;
  for(const auto& pair : pairs)
    for(Index f : { pair.first, pair.second })
      for(Index i : state.mesh.face(f))
        vertices.insert(i);

  bool separated = false;
  for(Index i : vertices)
    if(state.targets[i] != state.initial_points[i])
    {
      halve_move(state.initial_points[i], state.targets[i], number_of_halvings[i]);
      is_shortened[i] = true;
      separated = true;
    }
  return separated;
}

// The last word of a run: shortens the moves from the remesh to the targets where they do harm, so that neither the
// largest nor the mean error is above that of the remesh, as far as `Sampled_error` sees, no face is flipped and, if
// that is tested, no pair of faces intersects that did not before.
//
// The points of the mesh in `state` must be those for which the samples were taken; then they are the result. Its initial
// points are needed.
//
// `refuse_moves` takes back the moves that the user does not allow, and returns whether there were any;
// `find_self_intersections` is a `Self_intersection_test`.
template <typename ConcurrencyTag, typename ReferenceSurface, typename RefuseMoves, typename FindSelfIntersections>
void take_back_harm(Harm_criterion<ReferenceSurface>& criterion,
                    Optimization_state<Hint_of<ReferenceSurface>>& state,
                    const RefuseMoves& refuse_moves,
                    const FindSelfIntersections& find_self_intersections,
                    std::vector<bool>& is_shortened)
{
  Find_new_intersections<FindSelfIntersections> find_new_intersections(find_self_intersections);

  std::vector<unsigned char> number_of_halvings(state.targets.size(), 0);
  for(;;)
  {
    do
    {
      criterion.template measure_targets<ConcurrencyTag>();
      shorten_moves<ConcurrencyTag>(state, state.initial_points, criterion, is_shortened);
    }
    while(refuse_moves());

    if(criterion.template is_mean_bad<ConcurrencyTag>())
    {
      if(criterion.is_strict()) // no face has more error, but their areas have changed
      {
        for(std::size_t i = 0; i < state.targets.size(); ++i)
          if(state.targets[i] != state.initial_points[i])
          {
            state.targets[i] = state.initial_points[i];
            is_shortened[i] = true;
          }
        break;
      }
      criterion.template make_strict<ConcurrencyTag>();
    }
    else if(!separate_faces(state, find_new_intersections(state), number_of_halvings, is_shortened))
      break;
  }
  state.mesh.points = state.targets;
}

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_TAKE_BACK_HARM_H
