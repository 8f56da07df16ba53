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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PATCH_DESCRIPTORS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PATCH_DESCRIPTORS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_mesh.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Relates the patches of a reference surface to the mesh that it was made from, for property maps of that mesh: the surface
// itself does not refer to the mesh.
template <typename TriangleMesh>
class Patch_descriptors
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;

public:
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;
  using Face_location = std::pair<face_descriptor, std::array<double, 3>>;

  Patch_descriptors() = default;

  template <typename ConcurrencyTag>
  Patch_descriptors(const TriangleMesh& tmesh,
                    const Mesh_arrays& mesh,
                    const Mesh_descriptors<TriangleMesh>& descriptors,
                    const ConcurrencyTag&)
    : m_faces(mesh.number_of_faces()), m_corners(mesh.number_of_faces()), m_vertices(mesh.number_of_faces()),
      m_first_corners(mesh.number_of_faces())
  {
    for_each_index<ConcurrencyTag>(mesh.number_of_faces(), [&](std::size_t f) {
      const std::array<halfedge_descriptor, 3> corners = corner_halfedges(tmesh, mesh, descriptors, f);
      m_faces[f] = face(corners[0], tmesh);
      m_corners[f] = corners;
      m_vertices[f] = { { target(corners[0], tmesh), target(corners[1], tmesh), target(corners[2], tmesh) } };
      // the first coordinate of a location is that of the source of the halfedge of the face
      const halfedge_descriptor to_source = prev(halfedge(m_faces[f], tmesh), tmesh);
      const auto first_corner = std::find(corners.begin(), corners.end(), to_source);
      const bool is_triangle = next(corners[2], tmesh) == corners[0];
      m_first_corners[f] = static_cast<unsigned char>(is_triangle ? first_corner - corners.begin() : in_polygon);
    });
  }

  std::size_t size() const { return m_faces.size(); }
  const face_descriptor& face_of(std::size_t patch) const { return m_faces[patch]; }

  // the vertex at corner k of a patch, and the halfedge of the patch that points to it
  const vertex_descriptor& vertex(std::size_t patch, int k) const { return m_vertices[patch][k]; }
  const halfedge_descriptor& corner(std::size_t patch, int k) const { return m_corners[patch][k]; }

  // the location in a face that is a triangle, with these barycentric coordinates with respect to the corners of the patch
  Face_location location(std::size_t patch, const std::array<double, 3>& coordinates) const
  {
    CGAL_precondition_msg(m_first_corners[patch] != in_polygon, "The face is not a triangle.");
    Face_location result;
    result.first = m_faces[patch];
    for(int k = 0; k < 3; ++k)
      result.second[k] = (std::max)(0., coordinates[(m_first_corners[patch] + k) % 3]);
    return result;
  }

private:
  static constexpr int in_polygon = 3;

  std::vector<face_descriptor> m_faces;
  std::vector<std::array<halfedge_descriptor, 3>> m_corners;
  std::vector<std::array<vertex_descriptor, 3>> m_vertices;
  std::vector<unsigned char> m_first_corners; // of the faces; `in_polygon`: it is not a triangle
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PATCH_DESCRIPTORS_H
