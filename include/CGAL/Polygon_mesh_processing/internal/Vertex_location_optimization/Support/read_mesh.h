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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_READ_MESH_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_READ_MESH_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Face_reader.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Face_selection.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Mesh_arrays.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/order_vertices.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <cstddef>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

template <typename PolygonMesh, typename VertexPointMap>
bool has_finite_points(const PolygonMesh& pmesh, const VertexPointMap& vpm)
{
  for(auto v : vertices(pmesh))
    if(!is_finite(convert<Point>(get(vpm, v))))
      return false;
  return true;
}

// Whether all faces of `tmesh` are triangles, and all its coordinates finite.
template <typename TriangleMesh, typename VertexPointMap>
bool is_finite_triangle_mesh(const TriangleMesh& tmesh, const VertexPointMap& vpm)
{
  return is_triangle_mesh(tmesh) && has_finite_points(tmesh, vpm);
}

// Whether each face of `pmesh` has three corners or more, and those with more than three have no vertex twice.
template <typename PolygonMesh>
bool has_valid_faces(const PolygonMesh& pmesh)
{
  if(is_triangle_mesh(pmesh))
    return true;
  auto last_face = get(dynamic_vertex_property_t<std::size_t>(), pmesh); // by its number, of those that have been tested
  for(auto v : vertices(pmesh))
    put(last_face, v, 0);
  std::size_t number = 0;
  for(auto f : faces(pmesh))
  {
    ++number;
    std::size_t degree = 0;
    bool is_simple = true;
    for(auto v : vertices_around_face(halfedge(f, pmesh), pmesh))
    {
      ++degree;
      is_simple = is_simple && get(last_face, v) != number;
      put(last_face, v, number);
    }
    if(degree < 3 || (degree > 3 && !is_simple))
      return false;
  }
  return true;
}

// Whether all coordinates are finite and all faces valid.
template <typename PolygonMesh, typename VertexPointMap>
bool can_be_read(const PolygonMesh& pmesh, const VertexPointMap& vpm)
{
  const bool is_finite = has_finite_points(pmesh, vpm);
  CGAL_precondition_msg(is_finite, "A coordinate of the mesh is not finite.");
  const bool has_only_valid_faces = has_valid_faces(pmesh);
  CGAL_precondition_msg(has_only_valid_faces,
                        "A face of the mesh has less than three corners, or more than three and a vertex twice.");
  return is_finite && has_only_valid_faces;
}

// Copies the vertices, in an order in which neighbors are close to each other, and numbers them.
template <typename PolygonMesh, typename VertexPointMap, typename Selection, typename VertexIndexMap>
void copy_vertices(const PolygonMesh& pmesh,
                   const VertexPointMap& vpm,
                   const Selection& selection,
                   VertexIndexMap& vertex_index,
                   Mesh_arrays& mesh,
                   Mesh_descriptors<PolygonMesh>& descriptors)
{
  for(auto v : vertices(pmesh))
    if(selection.has_vertex(v))
      descriptors.vertices.push_back(v);
    else
      put(vertex_index, v, no_index);
  order_vertices(pmesh, vertex_index, descriptors.vertices);

  mesh.points.reserve(descriptors.vertices.size());
  for(auto v : descriptors.vertices)
    mesh.points.push_back(convert<Point>(get(vpm, v)));
}

// Reads the selected faces of `pmesh`. Returns whether that is possible: all coordinates are finite, the faces are valid,
// and the indices suffice.
template <typename PolygonMesh, typename VertexPointMap, typename Selection>
bool read_faces(const PolygonMesh& pmesh,
                const VertexPointMap& vpm,
                const Selection& selection,
                Mesh_arrays& mesh,
                Mesh_descriptors<PolygonMesh>& descriptors)
{
  if(!can_be_read(pmesh, vpm))
    return false;
  auto vertex_index = get(dynamic_vertex_property_t<Index>(), pmesh);
  copy_vertices(pmesh, vpm, selection, vertex_index, mesh, descriptors);
  const bool is_read = Face_reader(pmesh, selection, vertex_index, mesh, descriptors).read();
  CGAL_precondition_msg(is_read, "The mesh has more edges or triangles than indices of 32 bits tell apart.");
  return is_read;
}

// Reads `pmesh`, all of it.
template <typename PolygonMesh, typename VertexPointMap>
bool read_mesh(const PolygonMesh& pmesh,
               const VertexPointMap& vpm,
               Mesh_arrays& mesh,
               Mesh_descriptors<PolygonMesh>& descriptors)
{
  return read_faces(pmesh, vpm, All_faces(), mesh, descriptors);
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_READ_MESH_H
