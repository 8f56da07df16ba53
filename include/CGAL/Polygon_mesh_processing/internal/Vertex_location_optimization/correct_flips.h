// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CORRECT_FLIPS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CORRECT_FLIPS_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/shorten_moves.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// A face is flipped if the targets of its vertices turn its normal by more than 60 degrees from that in the remesh, or
// take its area away. A face that has no area in the remesh is never flipped.
template <typename Foot>
class Flip_criterion
{
public:
  explicit Flip_criterion(const Optimization_state<Foot>& state) : m_state(state) {}

  bool is_bad(std::size_t f) const
  {
    constexpr double cosine = 0.5;
    const Vector before = normal(m_state.initial_points, f), after = normal(m_state.targets, f);
    const double before2 = before.squared_length();
    return before2 > 0 && before * after <= cosine * std::sqrt(before2 * after.squared_length());
  }

  void update(std::size_t) {}

private:
  Vector normal(const std::vector<Point>& points, std::size_t f) const
  {
    const std::array<Index, 3>& v = m_state.mesh.faces[f];
    return area_normal(points[v[0]], points[v[1]], points[v[2]]);
  }

  const Optimization_state<Foot>& m_state;
};

// Shortens moves of this iteration until no face is flipped.
template <typename ConcurrencyTag, typename Foot>
void correct_flips(Optimization_state<Foot>& state, std::vector<char>& is_shortened)
{
  Flip_criterion<Foot> criterion(state);
  shorten_moves<ConcurrencyTag>(state, state.mesh.points, criterion, is_shortened);
}

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CORRECT_FLIPS_H
