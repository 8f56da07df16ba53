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

#ifndef CGAL_GEOMETRY_IMAGE_INTERNAL_MAKE_IMAGE_OF_MESH_H
#define CGAL_GEOMETRY_IMAGE_INTERNAL_MAKE_IMAGE_OF_MESH_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Geometry_image/internal/parameterize_over_square.h>
#include <CGAL/Geometry_image/internal/sample_parameterized_mesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_mesh.h>

#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::internal::geometry_image {

// why a triangle mesh is not a disk that can be parameterized, and how to fix it; empty if it is one
inline std::string why_no_disk(const Double_mesh& mesh, std::size_t number_of_borders)
{
  if(num_faces(mesh) == 0)
    return "the mesh has no faces";
  const auto is_degenerate = [&](Double_mesh::Face_index f) {
    return Polygon_mesh_processing::is_degenerate_triangle_face(f, mesh);
  };
  if(std::any_of(mesh.faces().begin(), mesh.faces().end(), is_degenerate))
    return "the mesh has faces without an area: remove them first, with "
           "Polygon_mesh_processing::remove_degenerate_faces()";
  if(number_of_borders == 0)
    return "the mesh is closed: cut it open first, with Polygon_mesh_processing::clip(), or along a path by removing "
           "faces with Euler::remove_face()";
  if(number_of_borders > 1)
    return "the mesh has " + std::to_string(number_of_borders) +
           " borders: fill all holes but one first, with "
           "Polygon_mesh_processing::triangulate_hole(), or take one component";

  Double_mesh copy = mesh;
  auto component = copy.add_property_map<Double_mesh::Face_index, std::size_t>("f:component").first;
  if(Polygon_mesh_processing::connected_components(copy, component) > 1)
    return "the mesh has several components: take one with Polygon_mesh_processing::keep_connected_components()";
  if(num_vertices(mesh) + num_faces(mesh) != num_edges(mesh) + 1)
    return "the mesh has a handle: cut it open first";
  return "";
}

// The border halfedge after the sharpest corner of the border: its source becomes a corner of the square.
inline Double_mesh::Halfedge_index find_first_corner(const Double_mesh& mesh, Double_mesh::Halfedge_index border)
{
  using Polygon_mesh_processing::internal::vertex_location::angle_at;

  auto angle_before = [&](Double_mesh::Halfedge_index h) {
    return angle_at(mesh.point(mesh.source(h)), mesh.point(mesh.source(mesh.prev(h))), mesh.point(mesh.target(h)));
  };
  const auto border_halfedges = halfedges_around_face(border, mesh);
  return *std::min_element(border_halfedges.begin(), border_halfedges.end(),
                           [&](auto g, auto h) { return angle_before(g) < angle_before(h); });
}

// Makes the image; returns an error message, which is empty on success.
template <typename TriangleMesh, typename VertexPointMap, typename Point_3>
std::string make_image_of_mesh(const TriangleMesh& tmesh, const VertexPointMap& vpm, Geometry_image<Point_3>& image)
{
  namespace PMP = Polygon_mesh_processing;
  namespace SMP = Surface_mesh_parameterization;

  if(image.width() < 2 || image.height() < 2)
    return "the image has fewer than two rows or columns";
  if(!PMP::internal::vertex_location::is_finite_triangle_mesh(tmesh, vpm))
    return "the mesh has faces that are no triangles, or coordinates that are not finite";

  Double_mesh mesh;
  copy_face_graph(tmesh, mesh, parameters::vertex_point_map(vpm));
  for(Double_mesh::Vertex_index v : mesh.vertices())
    if(mesh.is_isolated(v))
      mesh.remove_vertex(v);
  mesh.collect_garbage();
  std::vector<Double_mesh::Halfedge_index> borders;
  PMP::extract_boundary_cycles(mesh, std::back_inserter(borders));
  const std::string objection = why_no_disk(mesh, borders.size());
  if(!objection.empty())
    return objection;

  auto uvmap = mesh.add_property_map<Double_mesh::Vertex_index, Double_kernel::Point_2>("v:uv").first;
  const SMP::Error_code error = parameterize_over_square(mesh, find_first_corner(mesh, borders.front()), uvmap);
  if(error != SMP::OK)
    return SMP::get_error_message(error);

  // the border runs around the square counterclockwise, with the mesh on its right: the rows are lines of equal u, so that
  // the triangulated image is oriented as the mesh
  Geometry_image<Point_3> result(image.width(), image.height());
  if(!sample_parameterized_mesh(mesh, uvmap, result))
    return "the parameterization does not cover the square";
  image = std::move(result);
  return "";
}

} // namespace CGAL::internal::geometry_image

#endif // CGAL_GEOMETRY_IMAGE_INTERNAL_MAKE_IMAGE_OF_MESH_H
