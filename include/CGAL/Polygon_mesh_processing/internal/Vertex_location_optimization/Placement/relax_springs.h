// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_RELAX_SPRINGS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_RELAX_SPRINGS_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// Section 3.3: springs between neighbors, equations (3) and (4), keep the vertices apart. Their force is taken in the
// tangent plane: along the normal it would only push the surface outwards. A vertex that the fit leaves where it is
// needs no spring: planar parts stay as they are.
template <typename ConcurrencyTag, typename Hint>
void relax_springs(Optimization_state<Hint>& state, const std::size_t number_of_steps)
{
  const Mesh_arrays& mesh = state.mesh;
  const double two_sigma2 = 2 * state.spring_length * state.spring_length;
  if(!(two_sigma2 > 0))
    return;

  std::vector<Point> relaxed(number_of_steps > 0 ? state.targets.size() : 0);
  for(std::size_t step = 0; step < number_of_steps; ++step)
  {
    for_each_index<ConcurrencyTag>(state.targets.size(), [&](std::size_t i)
    {
      relaxed[i] = state.targets[i];
      if(!state.is_free(i) || state.is_at_rest(i))
        return;

      Vector force = NULL_VECTOR;
      state.for_each_corner(i, [&](Index c)
      {
        // around an inner vertex each neighbor follows it in one face
        const Vector from_j = state.targets[i] - state.targets[mesh.vertex(Mesh_arrays::next(c))];
        force = force + std::exp(-from_j.squared_length() / two_sigma2) * from_j;
      });
      const Vector& n = state.vertex_samples.normal(i);
      relaxed[i] = state.targets[i] + (force - (force * n) * n);
    });
    state.targets.swap(relaxed);
  }
}

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_RELAX_SPRINGS_H
