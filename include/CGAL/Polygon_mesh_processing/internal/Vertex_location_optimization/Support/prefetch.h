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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PREFETCH_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PREFETCH_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <cstddef>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// prefetches `object` to the cache, if the compiler supports it
template <typename T>
void prefetch(const T& object)
{
#ifdef __GNUC__
  constexpr std::size_t line_size = 64;
  const char* const begin = reinterpret_cast<const char*>(&object);
  for(std::size_t i = 0; i < sizeof(T); i += line_size)
    __builtin_prefetch(begin + i);
#else
  (void)object;
#endif
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PREFETCH_H
