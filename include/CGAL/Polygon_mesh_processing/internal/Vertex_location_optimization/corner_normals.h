// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CORNER_NORMALS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CORNER_NORMALS_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/for_each_index.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Mesh_arrays.h>

#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// unit normals of the faces; the null vector for a face without an area
template <typename ConcurrencyTag>
std::vector<Vector> compute_face_normals(const Mesh_arrays& mesh)
{
  std::vector<Vector> normals(mesh.faces.size());
  for_each_index<ConcurrencyTag>(mesh.faces.size(), [&](std::size_t f)
  {
    normals[f] = normalized(mesh.area_normal(f));
  });
  return normals;
}

// Marks the edges where the surface turns by more than the angle with the given cosine. A face without an area has no
// normal and so no sharp edge.
template <typename ConcurrencyTag>
std::vector<char> detect_creases(const Mesh_arrays& mesh, const std::vector<Vector>& face_normals, double cosine)
{
  std::vector<char> is_crease(mesh.edges.size());
  for_each_index<ConcurrencyTag>(mesh.edges.size(), [&](std::size_t e)
  {
    if(mesh.is_border(e))
      return;
    const Vector& m = face_normals[mesh.edge_corners[e][0] / 3];
    const Vector& n = face_normals[mesh.edge_corners[e][1] / 3];
    is_crease[e] = m != NULL_VECTOR && n != NULL_VECTOR && m * n < cosine;
  });
  return is_crease;
}

// The normals at the corners of the faces: the average, weighted by the angles, over the sector of faces around the
// vertex that creases and borders leave. All corners of a sector have the same normal, to the last bit.
template <typename ConcurrencyTag>
std::vector<Vector> compute_corner_normals(const Mesh_arrays& mesh,
                                           const std::vector<Vector>& face_normals,
                                           const std::vector<char>& is_crease)
{
  auto next_in_sector = [&](Index corner)
  {
    return is_crease[mesh.opposite_edge(Mesh_arrays::next(corner))] ? no_index : mesh.corner_across_next(corner);
  };
  auto previous_in_sector = [&](Index corner)
  {
    return is_crease[mesh.opposite_edge(Mesh_arrays::previous(corner))] ? no_index
                                                                        : mesh.corner_across_previous(corner);
  };
  // where the sum of a sector starts: at its end or, if it is a full turn, at its smallest corner
  auto first_in_sector = [&](Index corner)
  {
    Index smallest = corner;
    for(Index c = previous_in_sector(corner), last = corner; ; last = c, c = previous_in_sector(c))
    {
      if(c == no_index)
        return last;
      if(c == corner)
        return smallest;
      smallest = (std::min)(smallest, c);
    }
  };

  std::vector<Vector> normals(3 * mesh.faces.size());
  for_each_index<ConcurrencyTag>(normals.size(), [&](std::size_t i)
  {
    const Index first = first_in_sector(static_cast<Index>(i));
    Vector sum = NULL_VECTOR;
    Index corner = first;
    do
    {
      const Point& p = mesh.points[mesh.vertex(corner)];
      const Point& q = mesh.points[mesh.vertex(Mesh_arrays::next(corner))];
      const Point& r = mesh.points[mesh.vertex(Mesh_arrays::previous(corner))];
      sum = sum + angle_at(p, q, r) * face_normals[corner / 3];
      corner = next_in_sector(corner);
    }
    while(corner != no_index && corner != first);
    normals[i] = normalized(sum);
  });
  return normals;
}

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CORNER_NORMALS_H
