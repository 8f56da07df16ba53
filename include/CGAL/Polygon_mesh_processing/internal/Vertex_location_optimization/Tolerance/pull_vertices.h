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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PULL_VERTICES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PULL_VERTICES_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/New_intersections.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_mesh.h>

#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Moves vertices to the closest points of the reference; a half or a quarter of the way, or not at all, where a face would
// come to intersect another one. Returns those that have moved.
template <typename PolygonMesh, typename VertexPointMap, typename FindSelfIntersections, typename Reference>
std::vector<Index> pull_vertices(const std::vector<Index>& vertices,
                                 const Mesh_arrays& mesh,
                                 const Mesh_descriptors<PolygonMesh>& descriptors,
                                 const VertexPointMap& vpm,
                                 const FindSelfIntersections& find_self_intersections,
                                 const Reference& reference)
{
  using Point_3 = typename boost::property_traits<VertexPointMap>::value_type;
  constexpr int max_halvings = 2; // each takes one more test
  if(vertices.empty())
    return {};

  Remesh remesh(mesh, Constraints{ std::vector<Vertex_kind>(mesh.points.size(), Vertex_kind::FREE), {} });
  const auto is_moved = [&](Index i) { return remesh.next_points[i] != mesh.points[i]; };
  for(Index i : vertices)
    remesh.next_points[i] = reference.point(reference.project(mesh.points[i]));

  New_intersections<FindSelfIntersections> new_intersections(remesh, find_self_intersections);
  for(int round = 0, number_of_changes = 1; number_of_changes > 0; ++round)
  {
    number_of_changes = 0;
    for(Index i : new_intersections.find_vertices())
      if(is_moved(i))
      {
        remesh.next_points[i] = round < max_halvings ? midpoint(mesh.points[i], remesh.next_points[i]) : mesh.points[i];
        ++number_of_changes;
      }
  }

  std::vector<Index> moved;
  for(Index i : vertices)
    if(is_moved(i))
    {
      put(vpm, descriptors.vertices[i], convert<Point_3>(remesh.next_points[i]));
      moved.push_back(i);
    }
  return moved;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PULL_VERTICES_H
