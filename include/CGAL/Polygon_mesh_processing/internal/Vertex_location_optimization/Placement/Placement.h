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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PLACEMENT_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PLACEMENT_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Sampling/Remesh_samples.h>
#include <CGAL/Polygon_mesh_processing/Placement_method.h>

#include <cstddef>
#include <optional>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The parameters of the user.
struct Optimization_options
{
  Placement_method placement_method;
  std::optional<double> convergence_threshold; // relative to the lengths of the edges; else the placement chooses it
  bool do_self_intersection_tests;
  std::size_t number_of_iterations = 30;
  std::size_t number_of_free_iterations = 20;
  bool guarantee_both_directions = false;
  bool preserve_volume = false;

  // if the user has not chosen one, the default, reduced where the faces of M_0 are irregular
  std::optional<std::size_t> number_of_relaxation_steps = std::nullopt;
  std::optional<double> regularity_weight = std::nullopt; // of LEAST_SQUARES

  double part_of_regularity = 1; // a factor of the weight; not chosen by the user
};

// The state of a run.
struct Iteration
{
  std::size_t number;          // 0: the first one
  bool is_free;                // the vertices move freely, not only along the normals
  bool is_first_along_normals; // the first one that is not free
  bool is_last;                // its samples are exact
};

// How the vertices are placed: the actions of a placement method on the free vertices in the phases of an iteration. Each
// method has samples, tolerances and defaults of its own.
template <typename Reference>
class Placement
{
public:
  Placement(const Reference& reference, Remesh& remesh, const Sample_set set)
    : m_reference(reference), m_remesh(remesh), m_samples(remesh, set)
  {}

  virtual ~Placement() = default;
  Placement(const Placement&) = delete;
  Placement& operator=(const Placement&) = delete;

  // takes the samples of the initial points, and measures these
  virtual Initial_measure start() = 0;

  // takes the samples of the points from those of the previous points
  virtual void resample(const Iteration& iteration) = 0;

  // sets the next points, also of vertices that are not free: these stay
  virtual void place(const Iteration& iteration) = 0;

  // moves the next points of a free iteration along the surface, as far as that is not done in `place()`
  virtual void relax() = 0;

  // Whether the vertices have moved so little in this iteration that one more, with exact samples, suffices; called once in
  // each iteration.
  virtual bool has_settled() = 0;

  Remesh_samples<Reference>& samples() { return m_samples; }

protected:
  const Reference& m_reference;
  Remesh& m_remesh;
  Remesh_samples<Reference> m_samples;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PLACEMENT_H
