// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIT_PIECEWISE_LINEAR_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIT_PIECEWISE_LINEAR_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Optimization_state.h>

#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// Equation (1) for the corner i of a face, relative to the signal there. The signal, vectors, is p(k) at corner k and m(k)
// at the midpoint of the side that is opposite to it.
template <typename CornerSignal, typename MidpointSignal>
Vector piecewise_linear_update(const Index i, const CornerSignal& p, const MidpointSignal& m)
{
  const Index j = i == 2 ? 0 : i + 1, k = i == 0 ? 2 : i - 1;
  return (11 * (m(j) + m(k) - p(i)) - 7 * m(i) - 2 * (p(j) + p(k))) / 15;
}

// Section 3.2: the piecewise linear surface closest to the samples, as far as one vertex with its faces can tell,
// weighted by the areas of the faces of M_t, equations (1) and (2). What is fitted is the way from M_t to the samples:
// what is linear in each face, as M_t is, cancels out. If `along_normal`, only the part of the update along n_i is taken,
// measured from p_i. A vertex that is not free, or whose faces have no area, stays.
template <typename ConcurrencyTag, typename Hint>
void fit_piecewise_linear(Optimization_state<Hint>& state, const bool along_normal)
{
  const Mesh_arrays& mesh = state.mesh;
  std::vector<double> areas(mesh.faces.size());
  for_each_index<ConcurrencyTag>(areas.size(), [&](std::size_t f) { areas[f] = mesh.area(f); });

  for_each_index<ConcurrencyTag>(mesh.points.size(), [&](std::size_t i)
  {
    state.targets[i] = mesh.points[i];
    if(!state.is_free(i))
      return;

    double sum_of_areas = 0;
    Vector sum = NULL_VECTOR;
    state.for_each_corner(i, [&](Index c)
    {
      const Index f = c / 3;
      const auto p = [&](Index k) -> const Vector& { return state.vertex_samples.offset(mesh.faces[f][k]); };
      const auto m = [&](Index k) -> const Vector& { return state.midpoint_samples.offset(mesh.face_edges[f][k]); };
      sum = sum + areas[f] * piecewise_linear_update(c % 3, p, m);
      sum_of_areas += areas[f];
    });
    if(!(sum_of_areas > 0))
      return;

    Vector update = sum / sum_of_areas; // (2)
    if(along_normal)
      update = (update * state.vertex_samples.normal(i)) * state.vertex_samples.normal(i);
    state.targets[i] = mesh.points[i] + (state.vertex_samples.offset(i) + update);
  });
}

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIT_PIECEWISE_LINEAR_H
