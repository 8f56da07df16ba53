// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIT_PIECEWISE_LINEAR_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIT_PIECEWISE_LINEAR_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_sum_over_faces.h>

#include <array>

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

// The sums of equation (2) over the faces of a vertex.
struct Piecewise_linear_sums
{
  Vector update = NULL_VECTOR; // weighted by the areas
  double area = 0;

  Piecewise_linear_sums& operator+=(const Piecewise_linear_sums& other)
  {
    update = update + other.update;
    area += other.area;
    return *this;
  }
};

// Section 3.2: the piecewise linear surface closest to the samples, as far as one vertex with its faces can tell,
// weighted by the areas of the faces of M_t, equations (1) and (2). What is fitted is the way from M_t to the samples:
// what is linear in each face, as M_t is, cancels out. If `along_normal`, only the part of the update along n_i is taken,
// measured from p_i. A vertex that is not free, or whose faces have no area, stays.
template <typename ConcurrencyTag, typename Hint>
void fit_piecewise_linear(Optimization_state<Hint>& state, const bool along_normal)
{
  const Mesh_arrays& mesh = state.mesh;
  const auto sums_of_face = [&](std::size_t f)
  {
    const std::array<Index, 3> vertices = mesh.face(f), &edges = mesh.face_edges[f];
    const auto p = [&](Index k) -> const Vector& { return state.vertex_samples.offset(vertices[k]); };
    const auto m = [&](Index k) -> const Vector& { return state.midpoint_samples.offset(edges[k]); };
    const double area = mesh.area(f);
    std::array<Piecewise_linear_sums, 3> sums;
    for(Index k = 0; k < 3; ++k)
      sums[k] = { area * piecewise_linear_update(k, p, m), area };
    return sums;
  };

  for_each_sum_over_faces<ConcurrencyTag, Piecewise_linear_sums>(state, sums_of_face,
                                                                 [&](std::size_t i, const Piecewise_linear_sums& sums)
  {
    state.targets[i] = mesh.points[i];
    if(!state.is_free(i) || !(sums.area > 0))
      return;

    Vector update = sums.update / sums.area; // (2)
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
