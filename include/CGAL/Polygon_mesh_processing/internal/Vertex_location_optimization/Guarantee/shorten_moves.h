// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SHORTEN_MOVES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SHORTEN_MOVES_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>

#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// Halves the move of a vertex from `origin`, to which it returns when it has been halved too often.
inline void halve_move(const Point& origin, Point& target, unsigned char& number_of_halvings)
{
  constexpr unsigned char max_halvings = 6;
  target = ++number_of_halvings > max_halvings ? origin : midpoint(origin, target);
}

// The correction of section 3.3, for any criterion: as long as a face is bad, halves the move, from `origins` to the
// targets, of the vertex with the largest C_i - n_i, where C_i is the number of bad faces at the vertex and n_i how often
// it was corrected; the smallest index first where these are equal. Marks the vertices whose moves it shortens.
//
// `criterion.is_bad(f)` says whether face f is bad, `criterion.update(i)` tells that the target of vertex i has changed.
// A bad face whose vertices are all at their origins stays as it is.
template <typename ConcurrencyTag, typename Hint, typename Criterion>
void shorten_moves(Optimization_state<Hint>& state,
                   const std::vector<Point>& origins,
                   Criterion& criterion,
                   std::vector<bool>& is_shortened)
{
  const Mesh_arrays& mesh = state.mesh;
  const std::vector<Index> bad_faces =
    find_indices<ConcurrencyTag>(mesh.number_of_faces(), [&](std::size_t f) { return criterion.is_bad(f); });
  if(bad_faces.empty())
    return;

  std::vector<bool> is_bad(mesh.number_of_faces());
  for(Index f : bad_faces)
    is_bad[f] = true;
  std::vector<unsigned char> number_of_corrections(mesh.points.size(), 0);
  std::set<std::pair<int, Index>> queue; // of pairs (n_i - C_i, i)
  auto number_of_bad_faces = [&](Index i)
  {
    int number = 0;
    state.for_each_corner(i, [&](Index c) { number += is_bad[c / 3]; });
    return number;
  };
  auto enqueue = [&](Index i)
  {
    const int c = number_of_bad_faces(i);
    if(c > 0 && state.targets[i] != origins[i])
      queue.emplace(number_of_corrections[i] - c, i);
  };
  auto dequeue = [&](Index i) { queue.erase({ number_of_corrections[i] - number_of_bad_faces(i), i }); };

  for(Index f : bad_faces)
    for(Index i : mesh.face(f))
      enqueue(i);

  while(!queue.empty())
  {
    const Index i = queue.begin()->second;

    // the keys of the vertices around change with the faces
    std::set<Index> neighborhood;
    state.for_each_corner(i, [&](Index c)
    {
      for(Index j : mesh.face(c / 3))
        neighborhood.insert(j);
    });
    for(Index j : neighborhood)
      dequeue(j);

    is_shortened[i] = true;
    halve_move(origins[i], state.targets[i], number_of_corrections[i]);
    criterion.update(i);
    state.for_each_corner(i, [&](Index c) { is_bad[c / 3] = criterion.is_bad(c / 3); });

    for(Index j : neighborhood)
      enqueue(j);
  }
}

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SHORTEN_MOVES_H
