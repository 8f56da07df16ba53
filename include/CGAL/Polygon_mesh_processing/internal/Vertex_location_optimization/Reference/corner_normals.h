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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CORNER_NORMALS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CORNER_NORMALS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Index_groups.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Mesh_arrays.h>

#include <algorithm>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// unit normals of the faces; the null vector for a face without an area
template <typename ConcurrencyTag>
std::vector<Vector> compute_face_normals(const Mesh_arrays& mesh)
{
  std::vector<Vector> normals(mesh.number_of_faces());
  for_each_index<ConcurrencyTag>(mesh.number_of_faces(),
                                 [&](std::size_t f) { normals[f] = normalized(mesh.area_normal(f)); });
  return normals;
}

// The same, but the faces of a polygon have that of the polygon.
template <typename ConcurrencyTag>
std::vector<Vector> compute_polygon_normals(const Mesh_arrays& mesh)
{
  if(!mesh.has_polygons())
    return compute_face_normals<ConcurrencyTag>(mesh);
  std::vector<Vector> sums(mesh.number_of_polygons(), NULL_VECTOR);
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    sums[mesh.polygon(f)] = sums[mesh.polygon(f)] + mesh.weight(f) * mesh.area_normal(f);
  std::vector<Vector> normals;
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    normals.push_back(normalized(sums[mesh.polygon(f)]));
  return normals;
}

// Marks the edges where the surface turns by more than the angle with the given cosine. A face without an area has no
// normal and so no sharp edge.
template <typename ConcurrencyTag>
std::vector<char> detect_creases(const Mesh_arrays& mesh, const std::vector<Vector>& face_normals, double cosine)
{
  std::vector<char> is_crease(mesh.edges.size());
  for_each_index<ConcurrencyTag>(mesh.edges.size(), [&](std::size_t e) {
    if(mesh.is_border(e))
      return;
    const Vector& m = face_normals[mesh.edge_corners[e][0] / 3];
    const Vector& n = face_normals[mesh.edge_corners[e][1] / 3];
    is_crease[e] = m != NULL_VECTOR && n != NULL_VECTOR && m * n < cosine;
  });
  return is_crease;
}

// The corners around a vertex, in sectors that creases and borders end. All corners of a polygon at a vertex are in the
// same.
class Sectors
{
public:
  Sectors(const Mesh_arrays& mesh, const std::vector<char>& is_crease)
    : m_mesh(mesh), m_is_crease(is_crease),
      m_corners_of_ears(mesh.ears.size(), mesh.ears.size(), [&](Index corner) { return mesh.ear(corner); })
  {}

  // Calls f(c) for each corner c of the sector of `corner`, in an order that is the same for all of them: from its end
  // or, if it is a full turn, from its smallest corner.
  template <typename F>
  void for_each_corner(const Index corner, const F& f) const
  {
    const Index first = first_corner(m_mesh.ear(corner));
    Index c = first;
    do
    {
      if(m_mesh.has_polygons())
        m_corners_of_ears.for_each(c, f);
      else
        f(c);
      c = next(c);
    }
    while(c != no_index && c != first);
  }

  // the next ear around its vertex, and the previous one; no_index at the end of the sector
  Index next(Index corner) const
  {
    return m_is_crease[m_mesh.opposite_edge(Mesh_arrays::next(corner))] ? no_index : m_mesh.corner_across_next(corner);
  }

  Index previous(Index corner) const
  {
    return m_is_crease[m_mesh.opposite_edge(Mesh_arrays::previous(corner))] ? no_index
                                                                            : m_mesh.corner_across_previous(corner);
  }

private:
  Index first_corner(const Index corner) const
  {
    Index smallest = corner;
    for(Index c = previous(corner), last = corner;; last = c, c = previous(c))
    {
      if(c == no_index)
        return last;
      if(c == corner)
        return smallest;
      smallest = (std::min)(smallest, c);
    }
  }

  const Mesh_arrays& m_mesh;
  const std::vector<char>& m_is_crease;
  const Index_groups m_corners_of_ears; // if there are polygons
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CORNER_NORMALS_H
