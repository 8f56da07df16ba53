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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PROJECT_NEAR_OR_FAR_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PROJECT_NEAR_OR_FAR_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Reference_access.h>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The foot of p: where walking from `hint` leads; if that is farther away than `far`, the
// closest point.
template <typename Reference>
typename Reference::Foot
project_near_or_far(const Reference& reference, const Point& p, const typename Reference::Foot& hint, const double far)
{
  const auto foot = reference.project_locally(p, hint);
  if(Reference::walks && !(squared_distance(reference.point(foot), p) <= far * far))
    return reference.project(p, foot);
  return foot;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PROJECT_NEAR_OR_FAR_H
