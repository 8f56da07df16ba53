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

#ifndef CGAL_POLYGON_MESH_PROCESSING_PLACEMENT_METHOD_H
#define CGAL_POLYGON_MESH_PROCESSING_PLACEMENT_METHOD_H

#include <CGAL/license/Vertex_location_optimization.h>

namespace CGAL {
namespace Polygon_mesh_processing {

/*!
 * \ingroup PkgVertexLocationOptimizationRef
 *
 * \brief How `CGAL::Polygon_mesh_processing::optimize_vertex_locations()` places a vertex among its samples.
 *
 * This is unrelated to the placement of the package Triangulated Surface Mesh Simplification, which positions the vertex
 * that replaces a collapsed edge.
 */
enum Placement_method
{
  /// the paper's method: the piecewise linear surface closest to samples of the reference at the vertices and at the
  /// midpoints of the edges, with springs that keep the triangles regular
  PIECEWISE_LINEAR,
  /// a point-to-plane least squares fit to samples of both surfaces, with a term for the regularity of the triangles.
  /// Samples of the reference recover thin parts and creases that the remesh misses. Only `PN_triangle_surface` and
  /// `Flat_triangle_surface` are sampled; with another model of `ReferenceSurface`, the fit uses the samples of the remesh
  /// alone.
  LEAST_SQUARES
};

} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_POLYGON_MESH_PROCESSING_PLACEMENT_METHOD_H
