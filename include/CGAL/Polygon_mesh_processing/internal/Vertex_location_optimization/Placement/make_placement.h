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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MAKE_PLACEMENT_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MAKE_PLACEMENT_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Placement/Least_squares_placement.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Placement/Piecewise_linear_placement.h>

#include <memory>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The only code that depends on all placement methods.

inline Optimization_options default_options(const Placement_method method)
{
  return method == LEAST_SQUARES ? least_squares_defaults() : piecewise_linear_defaults();
}

template <typename ConcurrencyTag, typename Reference>
std::unique_ptr<Placement<Reference>>
make_placement(const Reference& reference, Remesh& remesh, const Optimization_options& options)
{
  if(options.placement_method == LEAST_SQUARES)
    return std::make_unique<Least_squares_placement<ConcurrencyTag, Reference>>(reference, remesh, options);
  return std::make_unique<Piecewise_linear_placement<ConcurrencyTag, Reference>>(reference, remesh, options);
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MAKE_PLACEMENT_H
