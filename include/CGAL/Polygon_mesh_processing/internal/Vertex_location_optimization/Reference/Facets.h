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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACETS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACETS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Mesh_arrays.h>

#include <CGAL/Union_find.h>

#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The facets of a triangle mesh: connected faces that lie in one plane. How a facet is triangulated says nothing about
// the surface.
struct Facets
{
  // whether edge e is inside a facet
  bool contain(const Mesh_arrays& mesh, std::size_t e) const
  {
    return !mesh.is_border(e) && of_face[mesh.edge_corners[e][0] / 3] == of_face[mesh.edge_corners[e][1] / 3];
  }

  std::vector<Index> of_face; // one face of the facet stands for all
  std::vector<double> area;   // of the facet of each face
  std::vector<Vector> normal; // the same: the mean of its faces
};

// Joins faces across edges that are no creases. Faces without an area are facets by themselves.
inline Facets
find_facets(const Mesh_arrays& mesh, const std::vector<Vector>& face_normals, const std::vector<char>& is_crease)
{
  // in radians; files in single precision turn the faces of a plane by about as much
  constexpr double coplanar = 1e-3;

  const Index n = static_cast<Index>(mesh.number_of_faces());
  Union_find<Index> sets;
  std::vector<Union_find<Index>::handle> handles;
  handles.reserve(n);
  for(Index f = 0; f < n; ++f)
    handles.push_back(sets.make_set(f));
  for(Index e = 0; e < mesh.edges.size(); ++e)
    if(!mesh.is_border(e) && !is_crease[e])
    {
      const Index f = mesh.edge_corners[e][0] / 3, g = mesh.edge_corners[e][1] / 3;
      if((face_normals[f] - face_normals[g]).squared_length() < square(coplanar) && face_normals[f] != NULL_VECTOR)
        sets.unify_sets(handles[f], handles[g]);
    }

  Facets facets;
  facets.of_face.resize(n);
  std::vector<Vector> sums(n, NULL_VECTOR);
  for(Index f = 0; f < n; ++f)
  {
    facets.of_face[f] = *sets.find(handles[f]);
    sums[facets.of_face[f]] = sums[facets.of_face[f]] + mesh.area_normal(f);
  }

  // a finely sampled curved surface has no sharper edge either: it is no facet
  std::vector<char> is_plane(n, 1);
  for(Index f = 0; f < n; ++f)
    if(!((face_normals[f] - normalized(sums[facets.of_face[f]])).squared_length() < square(2 * coplanar)))
      is_plane[facets.of_face[f]] = 0;

  std::vector<double> areas(n, 0);
  for(Index f = 0; f < n; ++f)
  {
    if(!is_plane[facets.of_face[f]])
    {
      facets.of_face[f] = f;
      sums[f] = mesh.area_normal(f);
    }
    areas[facets.of_face[f]] += mesh.area(f);
  }
  facets.area.resize(n);
  facets.normal.resize(n);
  for(Index f = 0; f < n; ++f)
  {
    facets.area[f] = areas[facets.of_face[f]];
    facets.normal[f] = normalized(sums[facets.of_face[f]]);
  }
  return facets;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACETS_H
