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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACE_ORIENTATION_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACE_ORIENTATION_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <algorithm>
#include <cstddef>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The orientation of a face relative to the normals of the reference at a point: on an edge, the reference has several
// normals.
enum class Face_orientation : char
{
  CONSISTENT, // with all of them
  AMBIGUOUS,  // against some
  REVERSED    // against all
};

// of a face with this normal, at the point of the reference with this foot
template <typename Reference>
Face_orientation orientation_at(const Reference& reference, const typename Reference::Foot& foot, const Vector& face_normal)
{
  const auto feet = reference.feet_at(foot);
  const auto opposed = static_cast<std::size_t>(
    std::count_if(feet.begin(), feet.end(), [&](const auto& other) { return face_normal * reference.normal(other) < 0; }));
  return opposed == 0            ? Face_orientation::CONSISTENT
         : opposed < feet.size() ? Face_orientation::AMBIGUOUS
                                 : Face_orientation::REVERSED;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACE_ORIENTATION_H
