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

#ifndef CGAL_GEOMETRY_IMAGE_GEOMETRY_IMAGE_TO_POLYGON_MESH_H
#define CGAL_GEOMETRY_IMAGE_GEOMETRY_IMAGE_TO_POLYGON_MESH_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Geometry_image/Geometry_image.h>
#include <CGAL/Geometry_image/internal/triangulate_samples.h>

#include <CGAL/assertions.h>
#include <CGAL/Named_function_parameters.h>

namespace CGAL {

/*!
 * \ingroup PkgVertexLocationOptimizationImages
 *
 * \brief triangulates a geometry image with the diagonals of another one.
 *
 * This is `geometry_image_to_polygon_mesh(image, tmesh, np)`, except that the triangles are those of `diagonals`: two images
 * that differ only in the locations of their samples, such as those before and after
 * `CGAL::Polygon_mesh_processing::optimize_geometry_image()`, get the same connectivity.
 *
 * \param image the image that provides the points
 * \param tmesh the mesh that the vertices and faces are added to
 * \param diagonals the image that provides the connectivity, by its shorter diagonals and coinciding samples
 * \param np an optional sequence of named parameters, those of `geometry_image_to_polygon_mesh(image, tmesh, np)`
 *
 * \pre the two images have the same size, and all their coordinates are finite. Otherwise nothing is added.
 */
template <typename Point_3, typename TriangleMesh, typename NamedParameters = parameters::Default_named_parameters>
void geometry_image_to_polygon_mesh(const Geometry_image<Point_3>& image,
                                    TriangleMesh& tmesh,
                                    const Geometry_image<Point_3>& diagonals,
                                    const NamedParameters& np = parameters::default_values())
{
  const bool is_valid = image.width() == diagonals.width() && image.height() == diagonals.height() &&
                        internal::geometry_image::has_finite_samples(image) &&
                        internal::geometry_image::has_finite_samples(diagonals);
  CGAL_precondition_msg(is_valid, "The two images must have the same size and finite coordinates.");
  if(!is_valid)
    return;

  internal::geometry_image::add_to_mesh(internal::geometry_image::triangulate_samples(diagonals), image, tmesh, np);
}

/*!
 * \ingroup PkgVertexLocationOptimizationImages
 *
 * \brief triangulates a geometry image.
 *
 * The border samples that coincide exactly are one vertex. Each quad of neighboring samples is split along its shorter
 * diagonal, from sample `(i, j)` to `(i + 1, j + 1)` if both are equally long. The normals of the faces are those of the
 * derivatives of the surface along a row and along a column, in this order. The vertices are added in the order of the
 * samples, row by row, and the faces in that of the quads.
 *
 * The result is a polygon mesh for any image:
 * - Triangles with two corners at the same vertex are omitted, and so are samples without a triangle. Thus a side of the
 *   image can be a single point, such as a pole, and two sides with a common corner can be joined.
 * - Where the border is folded, the shorter diagonals of the two quads beside the fold may cut off the same triangle,
 *   once from each side. One of the two is then split along its longer diagonal.
 * - Where the border touches itself other than along a seam, or is joined to a one-sided surface such as a Möbius strip,
 *   vertices are duplicated: the surface is cut open there.
 *
 * \tparam Point_3 a point type
 * \tparam TriangleMesh a model of `MutableFaceGraph`
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param image the image
 * \param tmesh the mesh that the vertices and faces are added to
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
 *     \cgalParamType{a class model of `ReadWritePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
 *     \cgalParamExtra{If this parameter is omitted, an internal property map for `CGAL::vertex_point_t` must be
 *                     available in `TriangleMesh`. Points of another kernel are converted, in double precision.}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \pre all coordinates are finite. Otherwise nothing is added.
 */
template <typename Point_3, typename TriangleMesh, typename NamedParameters = parameters::Default_named_parameters>
void geometry_image_to_polygon_mesh(const Geometry_image<Point_3>& image,
                                    TriangleMesh& tmesh,
                                    const NamedParameters& np = parameters::default_values())
{
  geometry_image_to_polygon_mesh(image, tmesh, image, np);
}

} // namespace CGAL

#endif // CGAL_GEOMETRY_IMAGE_GEOMETRY_IMAGE_TO_POLYGON_MESH_H
