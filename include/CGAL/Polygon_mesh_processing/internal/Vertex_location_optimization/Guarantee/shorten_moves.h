// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
//
// Author(s)     : The Vertex_location_optimization authors

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SHORTEN_MOVES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SHORTEN_MOVES_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Why the move of a vertex was shortened; a bit for each reason.
enum class Correction : unsigned char
{
  SHAPE = 1, // a face would flip, collapse, or be folded sharply
  ERROR = 2, // the distance between the surfaces would be larger
  INTERSECTION = 4,
  REFUSAL = 8 // by the user
};

// The corrections of each vertex.
class Corrections
{
public:
  explicit Corrections(std::size_t number_of_vertices) : m_reasons(number_of_vertices, 0) {}

  void add(std::size_t i, Correction reason) { m_reasons[i] |= static_cast<unsigned char>(reason); }

  std::size_t count() const { return m_reasons.size() - std::count(m_reasons.begin(), m_reasons.end(), 0); }

  std::size_t count(Correction reason) const
  {
    return std::count_if(m_reasons.begin(), m_reasons.end(),
                         [&](unsigned char reasons) { return (reasons & static_cast<unsigned char>(reason)) != 0; });
  }

private:
  std::vector<unsigned char> m_reasons;
};

// Halves the move of a vertex from `origin`, to which it returns when it has been halved too often.
inline void halve_move(const Point& origin, Point& next, unsigned char& number_of_halvings)
{
  constexpr unsigned char max_halvings = 6; // the remaining 2% of the move is not worth the time
  next = ++number_of_halvings > max_halvings ? origin : midpoint(origin, next);
}

// Takes back the moves from `origins` to the next points that the user does not allow; returns whether there were any.
template <typename AllowMove>
bool refuse_moves(Remesh& remesh, const std::vector<Point>& origins, const AllowMove& allow_move, Corrections& corrections)
{
  bool is_refused = false;
  for(std::size_t i = 0; i < origins.size(); ++i)
  {
    Point& next = remesh.next_points[i];
    if(next != origins[i] && !allow_move(i, origins[i], next))
    {
      next = origins[i];
      corrections.add(i, Correction::REFUSAL);
      is_refused = true;
    }
  }
  return is_refused;
}

// The correction of section 3.3, for any criterion: as long as a face violates it, halves the move, from `origins` to the
// next points, of the vertex with the largest C_i - n_i, where C_i is the number of such faces at the vertex and n_i how
// often it was corrected; the smallest index first where these are equal. Notes the vertices whose moves it shortens.
//
// `criterion.is_violated_by(f)` says whether face f violates it. A face whose vertices are all at their origins does not.
template <typename ConcurrencyTag, typename Criterion>
void shorten_moves(Remesh& remesh, const std::vector<Point>& origins, const Criterion& criterion, Corrections& corrections)
{
  const std::vector<Index> faces =
    find_indices<ConcurrencyTag>(remesh.number_of_faces(), [&](std::size_t f) { return criterion.is_violated_by(f); });
  if(faces.empty())
    return;

  std::vector<bool> is_violator(remesh.number_of_faces());
  for(Index f : faces)
    is_violator[f] = true;
  std::vector<unsigned char> number_of_corrections(remesh.points.size(), 0);
  std::set<std::pair<int, Index>> queue; // of pairs (n_i - C_i, i)
  const auto number_of_violators = [&](Index i) {
    int number = 0;
    remesh.for_each_corner(i, [&](Index c) { number += is_violator[c / 3]; });
    return number;
  };
  const auto enqueue = [&](Index i) {
    const int number = number_of_violators(i);
    if(number > 0 && remesh.next_points[i] != origins[i])
      queue.emplace(number_of_corrections[i] - number, i);
  };
  const auto dequeue = [&](Index i) { queue.erase({ number_of_corrections[i] - number_of_violators(i), i }); };

  for(Index f : faces)
    for(Index i : remesh.face(f))
      enqueue(i);

  while(!queue.empty())
  {
    const Index i = queue.begin()->second;
    std::set<Index> neighborhood; // the vertices whose keys change
    remesh.for_each_corner(i, [&](Index c) { neighborhood.insert(remesh.face(c / 3).begin(), remesh.face(c / 3).end()); });
    for(Index j : neighborhood)
      dequeue(j);

    corrections.add(i, Correction::SHAPE);
    halve_move(origins[i], remesh.next_points[i], number_of_corrections[i]);
    remesh.for_each_corner(i, [&](Index c) { is_violator[c / 3] = criterion.is_violated_by(c / 3); });

    for(Index j : neighborhood)
      enqueue(j);
  }
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SHORTEN_MOVES_H
