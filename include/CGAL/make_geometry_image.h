// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MAKE_GEOMETRY_IMAGE_H
#define CGAL_MAKE_GEOMETRY_IMAGE_H

#include <CGAL/Geometry_image/Geometry_image.h>
#include <CGAL/Geometry_image/internal/parameterize_over_square.h>
#include <CGAL/Geometry_image/internal/sample_parameterized_mesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/read_parameters.h>

#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {
namespace geometry_image {

#ifdef CGAL_EIGEN3_ENABLED
using Has_Eigen = std::true_type;
#else
using Has_Eigen = std::false_type;
#endif

// why a triangle mesh is no disk, and what helps; empty if it is one
inline std::string why_no_disk(const Double_mesh& mesh, std::size_t number_of_borders)
{
  if(num_faces(mesh) == 0)
    return "the mesh has no faces";
  if(number_of_borders == 0)
    return "the mesh is closed: cut it open first, with Polygon_mesh_processing::clip(), or along a path by removing "
           "faces with Euler::remove_face()";
  if(number_of_borders > 1)
    return "the mesh has " + std::to_string(number_of_borders) + " borders: fill all holes but one first, with "
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

  auto angle_before = [&](Double_mesh::Halfedge_index h)
  {
    return angle_at(mesh.point(mesh.source(h)), mesh.point(mesh.source(mesh.prev(h))), mesh.point(mesh.target(h)));
  };
  const auto border_halfedges = halfedges_around_face(border, mesh);
  return *std::min_element(border_halfedges.begin(), border_halfedges.end(), [&](auto g, auto h)
  {
    return angle_before(g) < angle_before(h);
  });
}

// Makes the image; returns what keeps it from being made, which is nothing if it is.
template <typename TriangleMesh, typename VertexPointMap, typename Point_3>
std::string make_image(const TriangleMesh& tmesh, const VertexPointMap& vpm, Geometry_image<Point_3>& image)
{
  namespace PMP = Polygon_mesh_processing;
  namespace SMP = Surface_mesh_parameterization;
  static_assert(Has_Eigen::value || !std::is_same<TriangleMesh, TriangleMesh>::value,
                "make_geometry_image() needs Eigen: link with CGAL::Eigen3_support.");

  if(image.width() < 2 || image.height() < 2)
    return "the image has fewer than two rows or columns";
  if(!PMP::internal::vertex_location::is_valid_input(tmesh, vpm))
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

} // namespace geometry_image
} // namespace internal

/*!
 * \ingroup PkgVertexLocationOptimizationImages
 *
 * \brief makes a geometry image of a triangle mesh that is a topological disk.
 *
 * The mesh is parameterized over a square with the package \ref PkgSurfaceMeshParameterization, its border on that of the
 * square by arc length from its sharpest corner, and sampled at a regular grid. To sample it evenly the mean value
 * coordinates are reweighted where the parameterization is stretched \cgalCite{ybs2004}. The first and the last rows and
 * columns are the border. The triangulated image is oriented as the mesh.
 *
 * A mesh that is no disk is refused; the parameter `verbose` tells why and what helps. A closed mesh must be cut open.
 *
 * This function needs \ref thirdpartyEigen "Eigen".
 *
 * \tparam TriangleMesh a model of `VertexListGraph`, `HalfedgeListGraph`, and `FaceListGraph`
 * \tparam Point_3 a point type
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tmesh the mesh
 * \param image the image; its width and height, of at least 2, are kept, and its samples overwritten
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{verbose}
 *     \cgalParamDescription{indicates whether it is told on `std::cerr` why there is no image}
 *     \cgalParamType{Boolean}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return whether there is an image; if not, `image` is untouched
 *
 * \sa `CGAL::Geometry_image`
 */
template <typename TriangleMesh, typename Point_3, typename NamedParameters = parameters::Default_named_parameters>
bool make_geometry_image(const TriangleMesh& tmesh,
                         Geometry_image<Point_3>& image,
                         const NamedParameters& np = parameters::default_values())
{
  namespace PMP = Polygon_mesh_processing;

  const bool verbose = parameters::choose_parameter(parameters::get_parameter(np, internal_np::verbose), false);
  const auto vpm = PMP::internal::vertex_location::read_vertex_point_map(tmesh, np);
  const std::string error = internal::geometry_image::make_image(tmesh, vpm, image);
  if(verbose && !error.empty())
    std::cerr << "Error: " << error << std::endl;
  return error.empty();
}

} // namespace CGAL

#endif // CGAL_MAKE_GEOMETRY_IMAGE_H
