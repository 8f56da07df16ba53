// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_WITH_REFERENCE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_WITH_REFERENCE_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Reference_access.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/with_reference_surface.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Mesh_arrays.h>

#include <CGAL/assertions.h>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// Returns f(access) with what `access_reference()` gives for `reference`, a mesh or a reference surface; `otherwise` if it
// is empty, but `mesh` is not.
template <typename ConcurrencyTag, typename Reference, typename NamedParameters, typename Result, typename F>
Result with_reference(const Mesh_arrays& mesh,
                      const Reference& reference,
                      const NamedParameters& np,
                      const Result& otherwise,
                      const F& f)
{
  return with_reference_surface<ConcurrencyTag>(reference, np, [&](const auto& surface) -> Result
  {
    const auto& access = access_reference(surface);
    const bool has_reference = !access.is_empty() || mesh.points.empty();
    CGAL_precondition(has_reference);
    return has_reference ? f(access) : otherwise;
  });
}

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_WITH_REFERENCE_H
