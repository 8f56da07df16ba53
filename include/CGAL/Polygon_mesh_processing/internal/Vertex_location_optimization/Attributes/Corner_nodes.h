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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CORNER_NODES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CORNER_NODES_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/corner_normals.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Where the fit has a value: at each sector of the corners around a vertex, which seams and borders end.
class Corner_nodes
{
public:
  Corner_nodes(const Mesh_arrays& mesh, const std::vector<char>& is_seam)
    : m_node_of_corner(3 * mesh.number_of_faces(), no_index)
  {
    const Sectors sectors(mesh, is_seam);
    m_first_of_node.push_back(0);
    for(Index c = 0; c < m_node_of_corner.size(); ++c)
    {
      if(m_node_of_corner[c] != no_index)
        continue;
      const Index node = static_cast<Index>(size());
      sectors.for_each_corner(c, [&](Index other) {
        m_node_of_corner[other] = node;
        m_corners.push_back(other);
      });
      m_first_of_node.push_back(static_cast<Index>(m_corners.size()));
    }
  }

  std::size_t size() const { return m_first_of_node.size() - 1; }
  Index of_corner(std::size_t corner) const { return m_node_of_corner[corner]; }
  Index first_corner(std::size_t node) const { return m_corners[m_first_of_node[node]]; }

  std::array<Index, 3> of_face(std::size_t f) const
  {
    return { m_node_of_corner[3 * f], m_node_of_corner[3 * f + 1], m_node_of_corner[3 * f + 2] };
  }

  template <typename F>
  void for_each_corner(const std::size_t node, const F& f) const
  {
    for(Index k = m_first_of_node[node]; k < m_first_of_node[node + 1]; ++k)
      f(m_corners[k]);
  }

private:
  std::vector<Index> m_node_of_corner;
  std::vector<Index> m_first_of_node; // its corners are m_corners[m_first_of_node[node]], ...
  std::vector<Index> m_corners;
};

// The node of each vertex: that of the sector with the largest area; `no_index` for a vertex without faces.
inline std::vector<Index> choose_vertex_nodes(const Mesh_arrays& mesh, const Corner_nodes& nodes)
{
  std::vector<double> largest(mesh.points.size(), -1);
  std::vector<Index> chosen(mesh.points.size(), no_index);
  for(Index node = 0; node < nodes.size(); ++node)
  {
    double area = 0;
    nodes.for_each_corner(node, [&](Index c) { area += mesh.area(c / 3); });
    const Index vertex = mesh.vertex(nodes.first_corner(node));
    if(area > largest[vertex] || chosen[vertex] == no_index)
    {
      largest[vertex] = area;
      chosen[vertex] = node;
    }
  }
  return chosen;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CORNER_NODES_H
