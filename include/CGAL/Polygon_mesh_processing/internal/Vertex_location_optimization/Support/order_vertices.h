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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_ORDER_VERTICES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_ORDER_VERTICES_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Orders vertices such that neighbors on the mesh are close in memory: block by block, with the blocks, and the vertices in
// each block, in breadth-first order. A space-filling curve would do as well, but the order, and thus the samples, would
// depend on the position of the mesh.
template <typename PolygonMesh, typename VertexIndexMap>
class Vertex_order
{
  using vertex_descriptor = typename boost::graph_traits<PolygonMesh>::vertex_descriptor;

public:
  // `vertex_index` has the place of each of `vertices` in these, and no_index for vertices that are not among them.
  Vertex_order(const PolygonMesh& pmesh, const VertexIndexMap& vertex_index, const std::vector<vertex_descriptor>& vertices)
    : m_pmesh(pmesh), m_vertex_index(vertex_index), m_vertices(vertices), m_is_reached(vertices.size(), 0)
  {
    m_order.reserve(vertices.size());
    std::size_t next_beyond = 0;
    for(Index first = 0; first < vertices.size(); ++first)
    {
      reach_block(first);
      for(; next_beyond < m_beyond.size(); ++next_beyond)
        reach_block(m_beyond[next_beyond]);
    }
  }

  // places in `vertices`
  const std::vector<Index>& order() const { return m_order; }

private:
  // Reaches the vertices around `first` that are not yet reached, up to a number.
  void reach_block(const Index first)
  {
    constexpr std::size_t block_size = 1024; // small enough for a cache
    if(m_is_reached[first])
      return;
    const std::size_t end = m_order.size() + block_size;
    std::size_t next = m_order.size();
    for(reach(first); next < m_order.size(); ++next)
    {
      find_neighbors(m_vertices[m_order[next]]);
      for(Index i : m_neighbors)
        if(m_order.size() == end)
          m_beyond.push_back(i);
        else if(!m_is_reached[i])
          reach(i);
    }
  }

  void reach(const Index i)
  {
    m_is_reached[i] = 1;
    m_order.push_back(i);
  }

  // The neighbors that are not yet reached, in the order of `vertices`, so that the first halfedge of a vertex does not
  // matter.
  void find_neighbors(const vertex_descriptor& vertex)
  {
    m_neighbors.clear();
    if(halfedge(vertex, m_pmesh) == boost::graph_traits<PolygonMesh>::null_halfedge()) // isolated
      return;
    for(vertex_descriptor v : vertices_around_target(vertex, m_pmesh))
    {
      const Index i = get(m_vertex_index, v);
      if(i != no_index && !m_is_reached[i])
        m_neighbors.push_back(i);
    }
    std::sort(m_neighbors.begin(), m_neighbors.end());
  }

  const PolygonMesh& m_pmesh;
  const VertexIndexMap& m_vertex_index;
  const std::vector<vertex_descriptor>& m_vertices;
  std::vector<Index> m_order;
  std::vector<Index> m_beyond;    // the neighbors of blocks, where others begin
  std::vector<Index> m_neighbors; // of the current vertex
  std::vector<char> m_is_reached;
};

// Replaces the order of `vertices` by that of `Vertex_order`. `vertex_index` gets the index of each.
template <typename PolygonMesh, typename VertexIndexMap, typename VertexDescriptor>
void order_vertices(const PolygonMesh& pmesh, VertexIndexMap& vertex_index, std::vector<VertexDescriptor>& vertices)
{
  const auto number_them = [&] {
    for(std::size_t i = 0; i < vertices.size(); ++i)
      put(vertex_index, vertices[i], static_cast<Index>(i));
  };
  number_them();
  const Vertex_order<PolygonMesh, VertexIndexMap> vertex_order(pmesh, vertex_index, vertices);
  std::vector<VertexDescriptor> ordered;
  ordered.reserve(vertices.size());
  for(Index i : vertex_order.order())
    ordered.push_back(vertices[i]);
  vertices = std::move(ordered);
  number_them();
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_ORDER_VERTICES_H
