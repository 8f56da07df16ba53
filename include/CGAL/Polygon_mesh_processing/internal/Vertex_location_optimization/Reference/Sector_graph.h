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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SECTOR_GRAPH_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SECTOR_GRAPH_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/corner_normals.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Facets.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The sectors of a triangle mesh, numbered, and what is around them. On both sides of a crease there are sectors of their
// own.
class Sector_graph
{
public:
  // An edge of a sector. One at an end of the sector counts on this side only.
  struct Edge
  {
    Index other;           // the sector at its other end
    Index number_of_sides; // 0 inside a facet
  };

  Sector_graph() = default;

  // still without edges
  Sector_graph(const Mesh_arrays& mesh, const std::vector<char>& is_crease)
  {
    number_sectors(mesh, Sectors(mesh, is_crease));
  }

  template <typename ConcurrencyTag>
  void find_edges(const Mesh_arrays& mesh, const Facets& facets)
  {
    m_edges.resize(m_first_edge.back());
    for_each_index<ConcurrencyTag>(number_of_sectors(), [&](std::size_t s) { set_edges(mesh, facets, s); });
  }

  std::size_t number_of_sectors() const { return m_points.size(); }
  Index sector(Index corner) const { return m_sector_of_corner[corner]; }
  const Point& point(std::size_t sector) const { return m_points[sector]; } // of its vertex

  // in the order of `Sectors`
  Iterator_range<const Index*> corners(std::size_t sector) const { return range(m_corners, m_first_corner, sector); }
  Iterator_range<const Edge*> edges(std::size_t sector) const { return range(m_edges, m_first_edge, sector); }

  // The sectors on both sides of edge e at one of its ends, the same one twice unless it is a crease.
  std::array<Index, 2> sectors_at_end(const Mesh_arrays& mesh, const std::size_t e, const int end) const
  {
    std::array<Index, 2> sectors;
    for(int side = 0; side < 2; ++side)
    {
      Index corner = mesh.edge_corners[e][side];
      if(corner == no_index)
        corner = mesh.edge_corners[e][1 - side];
      const Index next = Mesh_arrays::next(corner);
      sectors[side] = sector(mesh.vertex(next) == mesh.edges[e][end] ? next : Mesh_arrays::previous(corner));
    }
    return sectors;
  }

private:
  template <typename T>
  static Iterator_range<const T*>
  range(const std::vector<T>& elements, const std::vector<Index>& first, const std::size_t group)
  {
    return CGAL::make_range(elements.data() + first[group], elements.data() + first[group + 1]);
  }

  void number_sectors(const Mesh_arrays& mesh, const Sectors& sectors)
  {
    m_sector_of_corner.assign(3 * mesh.number_of_faces(), no_index);
    m_corners.reserve(m_sector_of_corner.size());
    for(Index c = 0; c < m_sector_of_corner.size(); ++c)
      if(m_sector_of_corner[c] == no_index)
      {
        const bool is_full_turn = add_corners(sectors, c);
        m_points.push_back(mesh.points[mesh.vertex(c)]);
        const Index number_of_corners = static_cast<Index>(m_corners.size()) - m_first_corner.back();
        m_first_corner.push_back(static_cast<Index>(m_corners.size()));
        m_first_edge.push_back(m_first_edge.back() + number_of_corners + (is_full_turn ? 0 : 1));
      }
  }

  // Adds a sector by its smallest corner; returns whether it is a full turn.
  bool add_corners(const Sectors& sectors, const Index smallest)
  {
    const auto add = [&](Index corner) {
      m_sector_of_corner[corner] = static_cast<Index>(number_of_sectors());
      m_corners.push_back(corner);
    };
    const std::size_t first = m_corners.size();
    Index c = smallest;
    do
    {
      add(c);
      c = sectors.next(c);
    }
    while(c != no_index && c != smallest);
    if(c == smallest)
      return true;

    const std::size_t end = m_corners.size();
    for(c = sectors.previous(smallest); c != no_index; c = sectors.previous(c))
      add(c);
    std::reverse(m_corners.begin() + end, m_corners.end());
    std::rotate(m_corners.begin() + first, m_corners.begin() + end, m_corners.end());
    return false;
  }

  void set_edges(const Mesh_arrays& mesh, const Facets& facets, const std::size_t s)
  {
    const auto around = corners(s);
    const bool is_full_turn = edges(s).size() == around.size();
    Edge* edge = m_edges.data() + m_first_edge[s];
    const auto set_edge = [&](Index far_corner, Index opposite, Index number_of_sides) {
      const bool is_in_facet = facets.contain(mesh.opposite_edge(opposite));
      *edge++ = { sector(far_corner), is_in_facet ? 0 : number_of_sides };
    };
    if(!is_full_turn)
      set_edge(Mesh_arrays::next(*around.begin()), Mesh_arrays::previous(*around.begin()), 1);
    for(const Index& c : around)
    {
      const bool is_at_end = !is_full_turn && &c + 1 == around.end();
      set_edge(Mesh_arrays::previous(c), Mesh_arrays::next(c), is_at_end ? 1 : 2);
    }
  }

  std::vector<Index> m_sector_of_corner;
  std::vector<Point> m_points;
  std::vector<Index> m_first_corner{ 0 }, m_first_edge{ 0 }; // of each sector, in the vectors below
  std::vector<Index> m_corners;                              // sector by sector
  std::vector<Edge> m_edges;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SECTOR_GRAPH_H
