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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SHAPE_CRITERION_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SHAPE_CRITERION_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Flip_criterion.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Fold_criterion.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>

#include <cstddef>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// A face violates it if it flips, collapses or gets a sharper fold. `Distances` has the normals of the reference under a
// face.
template <typename Distances>
class Shape_criterion
{
public:
  Shape_criterion(const Remesh& remesh, const Smallest_angles& smallest_angles, const Distances& distances)
    : m_flips(remesh, smallest_angles), m_folds(remesh, Reference_normals{ distances })
  {}

  bool is_violated_by(std::size_t f) const { return m_flips.is_violated_by(f) || m_folds.is_violated_by(f); }

private:
  struct Reference_normals
  {
    auto operator()(std::size_t f) const { return distances.reference_normals(f); }

    const Distances& distances;
  };

  const Flip_criterion m_flips;
  const Fold_criterion<Reference_normals> m_folds;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SHAPE_CRITERION_H
