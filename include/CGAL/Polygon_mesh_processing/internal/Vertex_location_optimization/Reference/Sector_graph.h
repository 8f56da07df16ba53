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
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Index_groups.h>

#include <array>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The sectors of a mesh, numbered, and the edges that connect them. On both sides of a crease there are sectors of their
// own, and so edges.
class Sector_graph
{
public:
  struct Edge
  {
    std::array<Index, 2> sectors;
    Vector direction; // from the first to the second one, a unit vector
    double length;
    double weight; // the number of sides; 0 inside a facet
  };

  Sector_graph(const Mesh_arrays& mesh, const std::vector<char>& is_crease, const Facets& facets)
  {
    number_sectors(mesh, Sectors(mesh, is_crease));
    for(Index e = 0; e < mesh.edges.size(); ++e)
      add_edges(mesh, facets, e);
    m_ends = Index_groups(number_of_sectors(), 2 * m_edges.size(), [&](Index i) { return m_edges[i / 2].sectors[i % 2]; });
  }

  std::size_t number_of_sectors() const { return m_first_corner.size() - 1; }
  Index sector(Index corner) const { return m_sector_of_corner[corner]; }

  // Calls f(c) for each corner c of a sector, in the order of `Sectors`.
  template <typename F>
  void for_each_corner(std::size_t sector, const F& f) const
  {
    for(Index k = m_first_corner[sector]; k < m_first_corner[sector + 1]; ++k)
      f(m_corners[k]);
  }

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

  // Calls f(other, direction, edge) for each edge of a sector: to the other one, away from this one.
  template <typename F>
  void for_each_edge(Index sector, const F& f) const
  {
    m_ends.for_each(sector, [&](Index i) {
      const Edge& edge = m_edges[i / 2];
      f(edge.sectors[1 - i % 2], i % 2 == 0 ? edge.direction : -edge.direction, edge);
    });
  }

private:
  void number_sectors(const Mesh_arrays& mesh, const Sectors& sectors)
  {
    m_sector_of_corner.assign(3 * mesh.number_of_faces(), no_index);
    m_corners.reserve(m_sector_of_corner.size());
    for(Index c = 0; c < m_sector_of_corner.size(); ++c)
      if(m_sector_of_corner[c] == no_index)
      {
        const Index sector = static_cast<Index>(number_of_sectors());
        sectors.for_each_corner(c, [&](Index other) {
          m_sector_of_corner[other] = sector;
          m_corners.push_back(other);
        });
        m_first_corner.push_back(static_cast<Index>(m_corners.size()));
      }
  }

  void add_edges(const Mesh_arrays& mesh, const Facets& facets, const Index e)
  {
    const auto& [p, q] = mesh.edges[e];
    const Vector d = mesh.points[q] - mesh.points[p];
    const double length = norm(d);
    if(!(length > 0))
      return;

    const auto [c, other] = mesh.edge_corners[e];
    const bool is_in_facet = facets.contain(mesh, e);
    for(Index corner : { c, other })
    {
      if(corner == no_index)
        continue;
      std::array<Index, 2> ends{ sector(Mesh_arrays::next(corner)), sector(Mesh_arrays::previous(corner)) };
      if(mesh.vertex(Mesh_arrays::next(corner)) != p)
        std::swap(ends[0], ends[1]);
      if(corner == other && c != no_index && m_edges.back().sectors == ends)
        m_edges.back().weight *= 2;
      else
        m_edges.push_back({ ends, d / length, length, is_in_facet ? 0. : 1. });
    }
  }

  std::vector<Index> m_sector_of_corner;
  std::vector<Index> m_first_corner{ 0 }; // of each sector, in m_corners
  std::vector<Index> m_corners;           // sector by sector
  std::vector<Edge> m_edges;
  Index_groups m_ends; // of the edges, by their sectors: 2 k + i is the end i of edge k
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SECTOR_GRAPH_H
