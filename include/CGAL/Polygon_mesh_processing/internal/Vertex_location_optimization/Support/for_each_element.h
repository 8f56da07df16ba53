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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FOR_EACH_ELEMENT_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FOR_EACH_ELEMENT_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Mesh_arrays.h>

#include <cstddef>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Calls on_vertex(i), on_edge(e) and on_face(f) for all vertices, edges and faces of `mesh`, see `for_each_index()`. Edges
// and faces follow their first vertex, while the parts of the reference that they read are still in the cache. The calls for
// edges and faces may read what those for their first vertex and for the edges there have written.
template <typename ConcurrencyTag, typename OnVertex, typename OnEdge, typename OnFace>
void for_each_element(const Mesh_arrays& mesh, const OnVertex& on_vertex, const OnEdge& on_edge, const OnFace& on_face)
{
  constexpr std::size_t block_size = 64; // of vertices
  for_each_block<ConcurrencyTag>(mesh.points.size(), block_size, [&](std::size_t begin, std::size_t end) {
    std::size_t e = mesh.first_edge_from(begin), f = mesh.first_face_from(begin);
    for(std::size_t i = begin; i < end; ++i)
    {
      on_vertex(i);
      for(; e < mesh.edges.size() && mesh.edges[e][0] == i; ++e)
        on_edge(e);
      for(; f < mesh.number_of_faces() && mesh.first_vertex(f) == i; ++f)
        on_face(f);
    }
  });
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FOR_EACH_ELEMENT_H
