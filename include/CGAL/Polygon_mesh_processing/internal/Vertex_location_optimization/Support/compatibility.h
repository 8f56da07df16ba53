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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_COMPATIBILITY_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_COMPATIBILITY_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/version.h>

#if CGAL_VERSION_MAJOR >= 6
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif
#include <CGAL/AABB_tree.h>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

#if CGAL_VERSION_MAJOR >= 6
template <typename GeomTraits, typename Primitive>
using AABB_traits_for = AABB_traits_3<GeomTraits, Primitive>;
#else
template <typename GeomTraits, typename Primitive>
using AABB_traits_for = AABB_traits<GeomTraits, Primitive>;
#endif

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_COMPATIBILITY_H
