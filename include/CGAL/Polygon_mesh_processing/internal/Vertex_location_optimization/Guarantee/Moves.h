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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MOVES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MOVES_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/shorten_moves.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <set>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Finds the edges and the faces at some vertices, each once, in increasing order.
inline void find_edges_and_faces(const Remesh& remesh,
                                 const std::vector<Index>& vertices,
                                 std::vector<Index>& edges,
                                 std::vector<Index>& faces)
{
  for(Index i : vertices)
    remesh.for_each_corner(i, [&](Index c) {
      faces.push_back(c / 3);
      edges.push_back(remesh.opposite_edge(Mesh_arrays::next(c)));
      edges.push_back(remesh.opposite_edge(Mesh_arrays::previous(c)));
    });
  for(std::vector<Index>* indices : { &edges, &faces })
  {
    std::sort(indices->begin(), indices->end());
    indices->erase(std::unique(indices->begin(), indices->end()), indices->end());
  }
}

// The moves of the vertices from the initial to the next points, and how they are taken back, by halves.
class Moves
{
  using Indices = std::vector<Index>;

public:
  Moves(Remesh& remesh, Corrections& corrections)
    : m_remesh(remesh), m_corrections(corrections), m_number_of_halvings(remesh.points.size(), 0)
  {}

  bool is_moved(std::size_t i) const { return m_remesh.next_points[i] != m_remesh.initial_points[i]; }

  // whether a vertex of face f is moved
  bool has_moved(std::size_t f) const
  {
    const auto& v = m_remesh.face(f);
    return std::any_of(v.begin(), v.end(), [&](Index i) { return is_moved(i); });
  }

  Indices moved_vertices() const
  {
    Indices result;
    for(Index i = 0; i < m_number_of_halvings.size(); ++i)
      if(is_moved(i))
        result.push_back(i);
    return result;
  }

  // Of each of the faces with `is_chosen[f]` the moved vertex with the most of them, less the number of its halvings.
  Indices vertices_with_most(const std::vector<char>& is_chosen) const
  {
    const auto key = [&](Index i) {
      int number = -m_number_of_halvings[i];
      m_remesh.for_each_corner(i, [&](Index c) { number += is_chosen[c / 3]; });
      return number;
    };
    Indices result;
    for(std::size_t f = 0; f < is_chosen.size(); ++f)
    {
      if(!is_chosen[f])
        continue;
      Index best = no_index;
      for(Index i : m_remesh.face(f))
        if(is_moved(i) && (best == no_index || key(i) > key(best) || (key(i) == key(best) && i < best)))
          best = i;
      if(best != no_index)
        result.push_back(best);
    }
    return result;
  }

  // The moved vertices at which values of the faces, shared by the moved vertices of each, have a positive sum. While the
  // sum over all faces that have moved is positive there is one.
  Indices vertices_with_positive_sum(const std::vector<double>& of_faces) const
  {
    std::vector<double> sums(m_number_of_halvings.size(), 0);
    for(std::size_t f = 0; f < of_faces.size(); ++f)
    {
      const auto& v = m_remesh.face(f);
      const auto number = std::count_if(v.begin(), v.end(), [&](Index i) { return is_moved(i); });
      for(Index i : v)
        if(is_moved(i))
          sums[i] += of_faces[f] / number;
    }
    Indices result;
    for(Index i = 0; i < sums.size(); ++i)
      if(sums[i] > 0)
        result.push_back(i);
    return result;
  }

  // Shortens the moves that have raised the mean, given by how much the integrals over the faces have changed: where these
  // have more than doubled, moves are taken back, as even a part of them would do harm; elsewhere, they are halved. If no
  // face has raised the mean, the harmful moves are unknown, and all are taken back. Returns whether there were any.
  bool shorten_raising(const std::vector<double>& initial_integrals, const std::vector<double>& changes, bool takes_back)
  {
    const Indices raising = vertices_with_positive_sum(changes);
    if(raising.empty())
      return shorten(moved_vertices(), Correction::ERROR, true);
    std::vector<double> excess(changes.size());
    std::transform(changes.begin(), changes.end(), initial_integrals.begin(), excess.begin(), std::minus<double>());
    const bool is_shortened = shorten(vertices_with_positive_sum(excess), Correction::ERROR, true);
    return shorten(raising, Correction::ERROR, takes_back) || is_shortened;
  }

  // Halves the moves of these vertices, or takes them back; returns whether there were any.
  template <typename Vertices>
  bool shorten(const Vertices& vertices, const Correction reason, const bool takes_back)
  {
    bool is_shortened = false;
    for(Index i : std::set<Index>(vertices.begin(), vertices.end()))
      if(is_moved(i))
      {
        if(takes_back)
          m_remesh.next_points[i] = m_remesh.initial_points[i];
        else
          halve_move(m_remesh.initial_points[i], m_remesh.next_points[i], m_number_of_halvings[i]);
        m_corrections.add(i, reason);
        is_shortened = true;
      }
    return is_shortened;
  }

private:
  Remesh& m_remesh;
  Corrections& m_corrections;
  std::vector<unsigned char> m_number_of_halvings; // of each vertex
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MOVES_H
