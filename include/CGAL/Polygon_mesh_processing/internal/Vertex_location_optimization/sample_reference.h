// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_REFERENCE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_REFERENCE_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/for_each_element.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Optimization_state.h>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// Section 3.1: takes p_i and n_i from the reference at the foot of each vertex, m_ij at the foot of the midpoint of each
// edge; in the first iteration. Calls on_barycenter(f, foot) with the foot of the barycenter of each face f, at which
// samples are taken, too, if the state has them.
template <typename ConcurrencyTag, typename ReferenceSurface, typename OnBarycenter>
void start_samples(const ReferenceSurface& reference,
                   Optimization_state<typename ReferenceSurface::Foot>& state,
                   const OnBarycenter& on_barycenter)
{
  const Mesh_arrays& mesh = state.mesh;
  for_each_element<ConcurrencyTag>(mesh,
    [&](std::size_t i)
    {
      state.vertex_samples.project(i, reference, mesh.points[i]);
    },
    [&](std::size_t e)
    {
      state.midpoint_samples.project(e, reference, mesh.midpoint(e), state.vertex_samples.feet[mesh.edges[e][0]]);
    },
    [&](std::size_t f)
    {
      const Point query = mesh.barycenter(f);
      const auto foot = reference.project(convert<typename ReferenceSurface::Point_3>(query),
                                          state.midpoint_samples.feet[mesh.edge_at_first_vertex(f)]);
      if(!state.barycenter_samples.feet.empty())
        state.barycenter_samples.set_closest(f, reference, query, foot);
      on_barycenter(f, foot);
    });
}

// Calls f(samples, i, query, displacement) for each sample i with its query and how that moved in the last iteration.
template <typename ConcurrencyTag, typename Foot, typename F>
void for_each_sample(Optimization_state<Foot>& state, const F& f)
{
  const Mesh_arrays& mesh = state.mesh;
  const auto displacement_of = [&](const auto& element)
  {
    Vector sum = NULL_VECTOR;
    for(Index i : element)
      sum = sum + state.last_displacement(i);
    return sum / element.size();
  };

  for_each_element<ConcurrencyTag>(mesh,
    [&](std::size_t i) { f(state.vertex_samples, i, mesh.points[i], state.last_displacement(i)); },
    [&](std::size_t e) { f(state.midpoint_samples, e, mesh.midpoint(e), displacement_of(mesh.edges[e])); },
    [&](std::size_t k)
    {
      if(!state.barycenter_samples.feet.empty())
        f(state.barycenter_samples, k, mesh.barycenter(k), displacement_of(mesh.faces[k]));
    });
}

// Takes the samples from those of the iteration before, as exactly as `tolerance` says.
template <typename ConcurrencyTag, typename ReferenceSurface>
void update_samples(const ReferenceSurface& reference,
                    const Sampling_tolerance& tolerance,
                    Optimization_state<typename ReferenceSurface::Foot>& state)
{
  for_each_sample<ConcurrencyTag>(state, [&](auto& samples, std::size_t i, const Point& query, const Vector& displacement)
  {
    samples.update(i, reference, tolerance, query, displacement);
  });
}

// Takes the samples at the closest points.
template <typename ConcurrencyTag, typename ReferenceSurface>
void sample_closest_points(const ReferenceSurface& reference, Optimization_state<typename ReferenceSurface::Foot>& state)
{
  for_each_sample<ConcurrencyTag>(state, [&](auto& samples, std::size_t i, const Point& query, const Vector&)
  {
    samples.project(i, reference, query, samples.feet[i]);
  });
}

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_REFERENCE_H
