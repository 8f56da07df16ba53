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
// edge. The feet of the last iteration are where the search starts; in the first iteration that of a midpoint starts at
// the foot of one of its ends.
template <typename ConcurrencyTag, typename ReferenceSurface>
void sample_reference(const ReferenceSurface& reference,
                      Optimization_state<typename ReferenceSurface::Foot>& state,
                      const bool has_feet)
{
  using Reference_point = typename ReferenceSurface::Point_3;

  const Mesh_arrays& mesh = state.mesh;
  for_each_index<ConcurrencyTag>(mesh.points.size(), [&](std::size_t i)
  {
    auto& foot = state.vertex_feet[i];
    const Reference_point query = convert<Reference_point>(mesh.points[i]);
    foot = has_feet ? reference.project(query, foot) : reference.project(query);
    state.vertex_samples[i] = convert<Point>(reference.point(foot));
    state.vertex_normals[i] = convert<Vector>(reference.normal(foot));
  });

  for_each_index<ConcurrencyTag>(mesh.edges.size(), [&](std::size_t e)
  {
    auto& foot = state.midpoint_feet[e];
    const std::array<Index, 2>& edge = mesh.edges[e];
    const Point query = midpoint(mesh.points[edge[0]], mesh.points[edge[1]]);
    foot = reference.project(convert<Reference_point>(query), has_feet ? foot : state.vertex_feet[edge[0]]);
    state.midpoint_samples[e] = convert<Point>(reference.point(foot));
  });
}

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_REFERENCE_H
