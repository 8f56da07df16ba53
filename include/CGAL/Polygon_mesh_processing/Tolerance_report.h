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

#ifndef CGAL_POLYGON_MESH_PROCESSING_TOLERANCE_REPORT_H
#define CGAL_POLYGON_MESH_PROCESSING_TOLERANCE_REPORT_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/approximation_error.h>
#include <CGAL/Polygon_mesh_processing/Vertex_location_optimization_report.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Polygon_mesh_processing {

/*!
 * \ingroup PkgVertexLocationOptimizationRef
 *
 * \brief The error that `CGAL::Polygon_mesh_processing::remesh_within_tolerance()` keeps within the tolerance, in both
 *        directions, from the remesh to the reference and back.
 */
enum Tolerated_error
{
  /// the largest distance: the Hausdorff distance between the two surfaces
  MAXIMUM_ERROR,
  /// the mean of the distance
  MEAN_ERROR,
  /// the root of the mean of the squared distance
  RMS_ERROR
};

/*!
 * \ingroup PkgVertexLocationOptimizationRef
 *
 * \brief The result of `CGAL::Polygon_mesh_processing::remesh_within_tolerance()`, in the unit of the input.
 */
struct Tolerance_report
{
  /// the edge length that the remesher was given
  double edge_length = 0;

  /// the distance of the points of the remesh to the reference; infinite if there is no remesh
  Approximation_error to_reference = { infinity, infinity, infinity };

  /// the distance of the points of the reference to the remesh; infinite if there is no remesh
  Approximation_error from_reference = { infinity, infinity, infinity };

  /// the number of calls of the remesher so far
  std::size_t number_of_remeshings = 0;

  /// whether the tolerated error of both directions, as measured, is not larger than the tolerance
  bool is_within_tolerance = false;

  /// the number of vertices of the remesh
  std::size_t number_of_vertices = 0;

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
};

/*!
 * \ingroup PkgVertexLocationOptimizationRef
 *
 * \brief The default visitor of `CGAL::Polygon_mesh_processing::remesh_within_tolerance()`: it does nothing.
 *
 * \cgalModels{ToleranceVisitor}
 */
struct Tolerance_default_visitor : Vertex_location_optimization_default_visitor
{
  /// is called before each remeshing with the edge length that is passed to the remesher.
  void start_remeshing(double) {}

  /// is called when a remesh has been optimized and measured, with its report.
  void end_remeshing(const Tolerance_report&) {}
};

} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_POLYGON_MESH_PROCESSING_TOLERANCE_REPORT_H
