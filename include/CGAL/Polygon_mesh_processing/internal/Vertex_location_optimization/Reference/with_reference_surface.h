// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_WITH_REFERENCE_SURFACE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_WITH_REFERENCE_SURFACE_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>
#include <CGAL/Polygon_mesh_processing/PN_triangle_surface.h>

#include <type_traits>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// A model of `ReferenceSurface` has a type `Foot`, a model of `FaceGraph` has none.
template <typename Reference, typename = void>
struct Is_reference_surface : std::false_type {};

template <typename Reference>
struct Is_reference_surface<Reference, std::void_t<typename Reference::Foot>> : std::true_type {};

// Returns f(surface), where `surface` is `reference` itself if it is a model of `ReferenceSurface`, else the PN triangle
// surface of the mesh `reference`.
template <typename ConcurrencyTag, typename Reference, typename NamedParameters, typename F>
auto with_reference_surface(const Reference& reference, const NamedParameters& np, const F& f)
{
  if constexpr(Is_reference_surface<Reference>::value)
    return f(reference);
  else
    return f(PN_triangle_surface<Reference, Kernel>(reference, np, ConcurrencyTag()));
}

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_WITH_REFERENCE_SURFACE_H
