// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_REFERENCE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_REFERENCE_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Optimization_state.h>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// Section 3.1: takes p_i and n_i from the reference at the foot of each vertex, m_ij at the foot of the midpoint of each
// edge; in the first iteration.
template <typename ConcurrencyTag, typename ReferenceSurface>
void start_samples(const ReferenceSurface& reference, Optimization_state<typename ReferenceSurface::Foot>& state)
{
  const Mesh_arrays& mesh = state.mesh;
  for_each_index<ConcurrencyTag>(mesh.points.size(), [&](std::size_t i)
  {
    state.vertex_samples.project(i, reference, mesh.points[i]);
  });
  for_each_index<ConcurrencyTag>(mesh.edges.size(), [&](std::size_t e)
  {
    state.midpoint_samples.project(e, reference, mesh.midpoint(e), state.vertex_samples.feet[mesh.edges[e][0]]);
  });
}

// The same from the samples of the iteration before, as exactly as `tolerance` says.
template <typename ConcurrencyTag, typename ReferenceSurface>
void update_samples(const ReferenceSurface& reference,
                    const Sampling_tolerance& tolerance,
                    Optimization_state<typename ReferenceSurface::Foot>& state)
{
  const Mesh_arrays& mesh = state.mesh;
  for_each_index<ConcurrencyTag>(mesh.points.size(), [&](std::size_t i)
  {
    state.vertex_samples.update(i, reference, tolerance, mesh.points[i], state.last_displacement(i));
  });
  for_each_index<ConcurrencyTag>(mesh.edges.size(), [&](std::size_t e)
  {
    const std::array<Index, 2>& v = mesh.edges[e];
    state.midpoint_samples.update(e, reference, tolerance, mesh.midpoint(e),
                                  (state.last_displacement(v[0]) + state.last_displacement(v[1])) / 2);
  });
}

// The same at the closest points.
template <typename ConcurrencyTag, typename ReferenceSurface>
void sample_closest_points(const ReferenceSurface& reference, Optimization_state<typename ReferenceSurface::Foot>& state)
{
  const Mesh_arrays& mesh = state.mesh;
  for_each_index<ConcurrencyTag>(mesh.points.size(), [&](std::size_t i)
  {
    state.vertex_samples.project(i, reference, mesh.points[i], state.vertex_samples.feet[i]);
  });
  for_each_index<ConcurrencyTag>(mesh.edges.size(), [&](std::size_t e)
  {
    state.midpoint_samples.project(e, reference, mesh.midpoint(e), state.midpoint_samples.feet[e]);
  });
}

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_REFERENCE_H
