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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_WITH_REFERENCE_SURFACE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_WITH_REFERENCE_SURFACE_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Reference_access.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/check_arguments.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Mesh_arrays.h>
#include <CGAL/Polygon_mesh_processing/PN_triangle_surface.h>

#include <CGAL/assertions.h>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The reference surface of a mesh where the user has not chosen one: PN triangles, flat ones if the mesh is not recognizably
// smooth.
class Default_reference_surface
{
public:
  template <typename TriangleMesh, typename NamedParameters, typename ConcurrencyTag>
  Default_reference_surface(const TriangleMesh& tmesh,
                            const NamedParameters& np,
                            Patch_descriptors<TriangleMesh>* const descriptors,
                            const ConcurrencyTag&)
    : m_patches(make_reference_patches<PN_triangle, ConcurrencyTag>(tmesh, np, descriptors, true))
  {}

  const Reference_patches<PN_triangle>& patches() const { return m_patches; }

private:
  Reference_patches<PN_triangle> m_patches;
};

// Returns f(surface), where `surface` is `reference` itself if it is a model of `ReferenceSurface`, else the default
// reference surface of the mesh `reference`.
template <typename ConcurrencyTag, typename Reference, typename NamedParameters, typename F>
auto with_reference_surface(const Reference& reference, const NamedParameters& np, const F& f)
{
  if constexpr(Is_reference_surface<Reference>::value)
    return f(reference);
  else
    return f(
      Default_reference_surface(reference, np, static_cast<Patch_descriptors<Reference>*>(nullptr), ConcurrencyTag()));
}

// Returns f(access) with what `access_reference()` gives for `reference`, a mesh or a reference surface; `otherwise` if it
// is empty, but `mesh` is not.
template <typename ConcurrencyTag, typename Reference, typename NamedParameters, typename Result, typename F>
Result with_reference(
  const Mesh_arrays& mesh, const Reference& reference, const NamedParameters& np, const Result& otherwise, const F& f)
{
  return with_reference_surface<ConcurrencyTag>(reference, np, [&](const auto& surface) -> Result {
    const auto& access = access_reference(surface);
    const bool has_reference = !access.is_empty() || mesh.points.empty();
    CGAL_precondition_msg(has_reference, "The reference has no face.");
    return has_reference ? f(access) : otherwise;
  });
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_WITH_REFERENCE_SURFACE_H
