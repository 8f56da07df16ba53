// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CORRECT_FLIPS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CORRECT_FLIPS_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Optimization_state.h>

#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// Section 3.3: as long as a face is flipped, halves the update of the vertex with the largest C_i - n_i, where C_i is
// the number of flipped faces at the vertex and n_i how often it was corrected; the smallest index first where these are
// equal. A face is flipped if its normal has turned by more than 60 degrees from that in the remesh, or if its area has
// vanished. Marks the vertices that it corrects.
template <typename ConcurrencyTag, typename Foot>
void correct_flips(Optimization_state<Foot>& state, std::vector<char>& is_corrected)
{
  constexpr double cosine = 0.5;
  constexpr int max_halvings = 6; // then the vertex stays where it was

  const Mesh_arrays& mesh = state.mesh;
  auto normal = [&](const std::vector<Point>& points, std::size_t f)
  {
    const std::array<Index, 3>& v = mesh.faces[f];
    return area_normal(points[v[0]], points[v[1]], points[v[2]]);
  };
  auto compute_is_flipped = [&](std::size_t f)
  {
    const Vector before = normal(state.initial_points, f), after = normal(state.targets, f);
    const double before2 = before.squared_length();
    return before2 > 0 && before * after <= cosine * std::sqrt(before2 * after.squared_length());
  };

  std::vector<char> is_flipped(mesh.faces.size());
  for_each_index<ConcurrencyTag>(mesh.faces.size(), [&](std::size_t f) { is_flipped[f] = compute_is_flipped(f); });

  // the queue, ordered by n_i - C_i and the index
  std::vector<int> number_of_corrections(mesh.points.size(), 0);
  std::set<std::pair<int, Index>> queue;
  auto key = [&](Index i)
  {
    int number_of_flips = 0;
    state.for_each_corner(i, [&](Index c) { number_of_flips += is_flipped[c / 3]; });
    return std::make_pair(number_of_flips, std::make_pair(number_of_corrections[i] - number_of_flips, i));
  };
  auto can_be_corrected = [&](Index i) { return state.targets[i] != mesh.points[i]; };
  auto enqueue = [&](Index i)
  {
    const auto k = key(i);
    if(k.first > 0 && can_be_corrected(i))
      queue.insert(k.second);
  };

  for(std::size_t f = 0; f < mesh.faces.size(); ++f)
    if(is_flipped[f])
      for(Index i : mesh.faces[f])
        enqueue(i);

  while(!queue.empty())
  {
    const Index i = queue.begin()->second;

    // the keys of the vertices around i change with its faces
    std::set<Index> neighborhood;
    state.for_each_corner(i, [&](Index c) { neighborhood.insert(mesh.faces[c / 3].begin(), mesh.faces[c / 3].end()); });
    for(Index j : neighborhood)
      queue.erase(key(j).second);

    is_corrected[i] = 1;
    state.targets[i] = ++number_of_corrections[i] > max_halvings ? mesh.points[i]
                                                                 : midpoint(mesh.points[i], state.targets[i]);
    state.for_each_corner(i, [&](Index c) { is_flipped[c / 3] = compute_is_flipped(c / 3); });

    for(Index j : neighborhood)
      enqueue(j);
  }
}

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CORRECT_FLIPS_H
