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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PIECEWISE_LINEAR_UPDATE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PIECEWISE_LINEAR_UPDATE_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Equation (1) for the corner i of a face, relative to the signal there. The signal, vectors, is p(k) at corner k and m(k)
// at the midpoint of the side that is opposite to it.
template <typename CornerSignal, typename MidpointSignal>
Vector piecewise_linear_update(const Index i, const CornerSignal& p, const MidpointSignal& m)
{
  const Index j = i == 2 ? 0 : i + 1, k = i == 0 ? 2 : i - 1;
  return (11 * (m(j) + m(k) - p(i)) - 7 * m(i) - 2 * (p(j) + p(k))) / 15;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PIECEWISE_LINEAR_UPDATE_H
