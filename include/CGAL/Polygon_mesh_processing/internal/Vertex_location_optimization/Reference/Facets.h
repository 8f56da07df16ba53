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

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Mesh_arrays.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The facets of a triangle mesh: connected faces that lie in one plane. The triangulation of a facet contains no information
// about the surface.
struct Facets
{
  bool contain(std::size_t e) const { return is_inside[e] != 0; } // whether edge e is inside a facet

  std::vector<double> area;    // of the facet of each face
  std::vector<Vector> normal;  // the same: the mean of its faces
  std::vector<char> is_inside; // of the edges
};

// Joins faces across the edges e for which is_joined(e) holds: sets for each face the one that stands for all that it has
// been joined with, and returns the faces that have been joined, in increasing order.
template <typename IsJoined>
std::vector<Index> join_faces(const Mesh_arrays& mesh, const IsJoined& is_joined, std::vector<Index>& representatives)
{
  const std::size_t n = mesh.number_of_faces();
  representatives.resize(n);
  std::iota(representatives.begin(), representatives.end(), Index(0));
  const auto find = [&](Index f) {
    while(representatives[f] != f)
      f = representatives[f] = representatives[representatives[f]];
    return f;
  };
  std::vector<char> has_joined(n, 0);
  for(Index e = 0; e < mesh.edges.size(); ++e)
    if(is_joined(e))
    {
      const Index f = mesh.edge_corners[e][0] / 3, g = mesh.edge_corners[e][1] / 3;
      const auto [smaller, larger] = std::minmax({ find(f), find(g) });
      representatives[larger] = smaller;
      has_joined[f] = has_joined[g] = 1;
    }

  std::vector<Index> joined;
  for(Index f = 0; f < n; ++f)
    if(has_joined[f])
    {
      representatives[f] = find(f);
      joined.push_back(f);
    }
  return joined;
}

// Joins faces across edges that are no creases. Faces without an area are facets by themselves.
template <typename ConcurrencyTag>
Facets find_facets(const Mesh_arrays& mesh, const std::vector<Vector>& face_normals, const std::vector<char>& is_crease)
{
  // in radians; files in single precision turn the faces of a plane by about as much
  constexpr double coplanar = 1e-3;

  Facets facets{ std::vector<double>(mesh.number_of_faces()), face_normals, std::vector<char>(mesh.edges.size()) };
  for_each_index<ConcurrencyTag>(mesh.edges.size(), [&](std::size_t e) {
    if(mesh.is_border(e) || is_crease[e])
      return;
    const Vector &m = face_normals[mesh.edge_corners[e][0] / 3], &n = face_normals[mesh.edge_corners[e][1] / 3];
    facets.is_inside[e] = (m - n).squared_length() < square(coplanar) && m != NULL_VECTOR;
  });
  std::vector<Index> of_face; // one of the facet stands for all
  const std::vector<Index> joined = join_faces(
    mesh, [&](Index e) { return facets.is_inside[e] != 0; }, of_face);

  std::vector<Vector> sums(joined.empty() ? 0 : of_face.size(), NULL_VECTOR);
  for(Index f : joined)
    sums[of_face[f]] = sums[of_face[f]] + mesh.area_normal(f);

  // a finely sampled curved surface has no sharper edge either: it is no facet
  std::vector<char> is_plane(sums.size(), 1);
  for(Index f : joined)
    if(!((face_normals[f] - normalized(sums[of_face[f]])).squared_length() < square(2 * coplanar)))
      is_plane[of_face[f]] = 0;

  for_each_index<ConcurrencyTag>(facets.area.size(), [&](std::size_t f) { facets.area[f] = mesh.area(f); });
  std::vector<double> areas(sums.size(), 0);
  for(Index f : joined)
    areas[of_face[f]] += facets.area[f];
  for(Index f : joined)
    if(is_plane[of_face[f]])
    {
      facets.area[f] = areas[of_face[f]];
      facets.normal[f] = normalized(sums[of_face[f]]);
    }
    else
      of_face[f] = f;

  for_each_index<ConcurrencyTag>(mesh.edges.size(), [&](std::size_t e) {
    facets.is_inside[e] = !mesh.is_border(e) && of_face[mesh.edge_corners[e][0] / 3] == of_face[mesh.edge_corners[e][1] / 3];
  });
  return facets;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACETS_H
