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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_TOLERANCE_SETTING_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_TOLERANCE_SETTING_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Mesh_arrays.h>
#include <CGAL/Polygon_mesh_processing/Tolerance_report.h>

#include <algorithm>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

inline double tolerated_value(const Approximation_error& error, Tolerated_error kind)
{
  return kind == MAXIMUM_ERROR ? error.max : kind == MEAN_ERROR ? error.mean : error.rms;
}

inline double tolerated_value(const Tolerance_report& report, Tolerated_error kind)
{
  return (std::max)(tolerated_value(report.to_reference, kind), tolerated_value(report.from_reference, kind));
}

// What the remesher has to keep, in the order in which the input, or a copy of it, has its edges and vertices: the
// constrained edges, and their corners and those of the border, where the curve does not pass straight through a vertex.
struct Kept_elements
{
  std::vector<char> edges;
  std::vector<char> vertices;
};

// What all attempts have in common: the input, the reference and what is tolerated.
template <typename TriangleMesh, typename Surface>
struct Tolerance_setting
{
  const TriangleMesh& input;
  const Flat_triangle_surface<TriangleMesh>& input_surface;
  const Mesh_arrays& input_arrays;
  const Kept_elements& kept;
  const Surface& surface;
  double tolerance;
  Tolerated_error kind;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_TOLERANCE_SETTING_H
