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

#ifndef CGAL_MAKE_GEOMETRY_IMAGE_H
#define CGAL_MAKE_GEOMETRY_IMAGE_H

#include <CGAL/license/Vertex_location_optimization.h>

#ifndef CGAL_EIGEN3_ENABLED
#error "make_geometry_image() needs Eigen: link with CGAL::Eigen3_support"
#endif

#include <CGAL/Geometry_image/Geometry_image.h>
#include <CGAL/Geometry_image/internal/make_image_of_mesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <iostream>
#include <string>

namespace CGAL {

/*!
 * \ingroup PkgVertexLocationOptimizationImages
 *
 * \brief makes a geometry image of a triangle mesh that is a topological disk.
 *
 * The mesh is parameterized over a square with the package \ref PkgSurfaceMeshParameterization, and sampled at a regular
 * grid. The border of the mesh is mapped to that of the square by arc length, starting at its sharpest corner. For even
 * sampling, the mean value coordinates are reweighted where the parameterization is stretched \cgalCite{ybs2004}. The first
 * and the last rows and columns are the border. The triangulated image has the orientation of the mesh.
 *
 * A mesh that is not a disk is rejected; with the parameter `verbose`, a message says why, and how to fix it. A closed mesh
 * must be cut open.
 *
 * This function requires \ref thirdpartyEigen "Eigen".
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
 *     \cgalParamDescription{indicates whether error messages are printed to `std::cerr`}
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
  const std::string error = internal::geometry_image::make_image_of_mesh(tmesh, vpm, image);
  if(verbose && !error.empty())
    std::cerr << "Error: " << error << std::endl;
  return error.empty();
}

} // namespace CGAL

#endif // CGAL_MAKE_GEOMETRY_IMAGE_H
