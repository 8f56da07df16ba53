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
// edge, and samples at the feet of the barycenters of the faces; in the first iteration.
template <typename ConcurrencyTag, typename ReferenceSurface>
void start_samples(const ReferenceSurface& reference, Optimization_state<typename ReferenceSurface::Foot>& state)
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
      state.barycenter_samples.project(f, reference, mesh.barycenter(f),
                                       state.midpoint_samples.feet[mesh.edge_at_first_vertex(f)]);
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
      if(!state.barycenter_samples.points.empty())
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
