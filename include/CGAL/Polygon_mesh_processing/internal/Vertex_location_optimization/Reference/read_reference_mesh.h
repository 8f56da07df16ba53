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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_READ_REFERENCE_MESH_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_READ_REFERENCE_MESH_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_mesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Triangulated_copy.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <cstddef>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Relates the elements of the arrays of a triangulated copy to those of the mesh itself; marks the diagonals.
template <typename PolygonMesh>
void find_originals(const PolygonMesh& pmesh,
                    const Triangulated_copy<PolygonMesh>& copy,
                    const Mesh_descriptors<typename Triangulated_copy<PolygonMesh>::Mesh>& in_copy,
                    Mesh_arrays& mesh,
                    Mesh_descriptors<PolygonMesh>& descriptors)
{
  for(const auto v : in_copy.vertices)
    descriptors.vertices.push_back(copy.vertices[v]);

  mesh.diagonals.assign(mesh.edges.size(), 1);
  descriptors.edges.resize(mesh.edges.size());
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
  {
    auto first = halfedge(copy.faces[face(in_copy.halfedges[f], copy.mesh)], pmesh);
    while(target(first, pmesh) != descriptors.vertices[mesh.first_vertex(f)])
      first = next(first, pmesh);
    descriptors.halfedges.push_back(first);

    const auto corners = corner_halfedges(pmesh, mesh, descriptors, f);
    for(int k = 0; k < 3; ++k)
    {
      const auto to_next = corners[(k + 1) % 3];
      if(next(corners[k], pmesh) != to_next)
        continue;
      const Index e = mesh.face_edges[f][(k + 2) % 3];
      mesh.diagonals[e] = 0;
      descriptors.edges[e] = edge(to_next, pmesh);
    }
  }
}

// Reads the mesh of a reference: if it has polygons, each of them as one of its triangulations. See `read_mesh()`.
template <typename PolygonMesh, typename VertexPointMap>
bool read_reference_mesh(const PolygonMesh& pmesh,
                         const VertexPointMap& vpm,
                         Mesh_arrays& mesh,
                         Mesh_descriptors<PolygonMesh>& descriptors)
{
  if(is_triangle_mesh(pmesh))
    return read_mesh(pmesh, vpm, mesh, descriptors);
  if(!can_be_read(pmesh, vpm))
    return false;
  const Triangulated_copy<PolygonMesh> copy(pmesh, vpm);
  Mesh_descriptors<typename Triangulated_copy<PolygonMesh>::Mesh> in_copy;
  if(!read_mesh(copy.mesh, get(vertex_point, copy.mesh), mesh, in_copy))
    return false;
  find_originals(pmesh, copy, in_copy, mesh, descriptors);
  return true;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_READ_REFERENCE_MESH_H
