// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIT_PIECEWISE_LINEAR_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIT_PIECEWISE_LINEAR_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Optimization_state.h>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// Section 3.2: the piecewise linear surface closest to the samples, as far as one vertex with its faces can tell,
// weighted by the areas of the faces of M_t, equations (1) and (2). If `along_normal`, only the part of the update along
// n_i is taken, measured from p_i. A vertex that is not free, or whose faces have no area, stays.
template <typename ConcurrencyTag, typename Foot>
void fit_piecewise_linear(Optimization_state<Foot>& state, const bool along_normal)
{
  const Mesh_arrays& mesh = state.mesh;
  const std::vector<Point>& p = state.vertex_samples;
  const std::vector<Point>& m = state.midpoint_samples;

  for_each_index<ConcurrencyTag>(mesh.points.size(), [&](std::size_t i)
  {
    state.targets[i] = mesh.points[i];
    if(!state.is_free(i))
      return;

    // (1) relative to p_i, where it loses no digits
    double sum_of_areas = 0;
    Vector sum = NULL_VECTOR;
    state.for_each_corner(i, [&](Index c)
    {
      const Index at_j = Mesh_arrays::next(c), at_k = Mesh_arrays::previous(c);
      const double area = norm(mesh.area_normal(c / 3));
      const Vector to_j = p[mesh.vertex(at_j)] - p[i], to_k = p[mesh.vertex(at_k)] - p[i];
      const Vector to_m_ij = m[mesh.opposite_edge(at_k)] - p[i], to_m_ik = m[mesh.opposite_edge(at_j)] - p[i],
                   to_m_jk = m[mesh.opposite_edge(c)] - p[i];
      sum = sum + area * (11 * (to_m_ij + to_m_ik) - 7 * to_m_jk - 2 * (to_j + to_k)) / 15;
      sum_of_areas += area;
    });
    if(!(sum_of_areas > 0))
      return;

    Vector update = sum / sum_of_areas; // (2)
    if(along_normal)
      update = (update * state.vertex_normals[i]) * state.vertex_normals[i];
    state.targets[i] = p[i] + update;
  });
}

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIT_PIECEWISE_LINEAR_H
