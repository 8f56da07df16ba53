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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_WITH_DESCRIBED_REFERENCE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_WITH_DESCRIBED_REFERENCE_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Patch_descriptors.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/with_reference_surface.h>

#include <CGAL/assertions.h>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// As `with_reference()`, for maps of the mesh that `reference` is or was made from: returns f(patches, descriptors), with
// the `Reference_patches` and what they are in that mesh.
template <typename ConcurrencyTag, typename Reference, typename NamedParameters, typename Result, typename F>
Result with_described_reference(
  const Mesh_arrays& mesh, const Reference& reference, const NamedParameters& np, const Result& otherwise, const F& f)
{
  const auto unless_empty = [&](const auto& patches, const auto& descriptors) -> Result {
    const bool has_reference = !patches.is_empty() || mesh.points.empty();
    CGAL_precondition_msg(has_reference, "The reference has no face.");
    return has_reference ? f(patches, descriptors) : otherwise;
  };
  if constexpr(Is_reference_surface<Reference>::value)
  {
    static_assert(Is_patch_surface<Reference>::value, "The reference must be a mesh, or a surface that was made from one.");
    return unless_empty(reference.patches(), reference.descriptors());
  }
  else
  {
    Patch_descriptors<Reference> descriptors;
    const Default_reference_surface surface(reference, np, &descriptors, ConcurrencyTag());
    return unless_empty(surface.patches(), descriptors);
  }
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_WITH_DESCRIBED_REFERENCE_H
