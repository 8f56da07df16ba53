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

#ifndef CGAL_POLYGON_MESH_PROCESSING_VERTEX_LOCATION_OPTIMIZATION_REPORT_H
#define CGAL_POLYGON_MESH_PROCESSING_VERTEX_LOCATION_OPTIMIZATION_REPORT_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <cstddef>

namespace CGAL {
namespace Polygon_mesh_processing {

/*!
 * \ingroup PkgVertexLocationOptimizationRef
 *
 * \brief The kinds of reference surfaces.
 */
enum class Reference_surface_kind
{
  /// the faces of a mesh
  FLAT,
  /// PN triangles over the faces of a mesh
  PN,
  /// another model of `ReferenceSurface`
  OTHER
};

/*!
 * \ingroup PkgVertexLocationOptimizationRef
 *
 * \brief The reference surface that a remesh was fitted to, and its deviation from the faces of the mesh it was made from.
 *
 * The deviation is measured at the midpoints of the edges and the barycenters of the faces, in the unit of the input.
 */
struct Reference_surface_summary
{
  /// the kind of the surface
  Reference_surface_kind kind = Reference_surface_kind::OTHER;

  /// the mean distance of the surface from the faces; `0` if it is flat, or of another kind
  double mean_deviation = 0;

  /// the largest distance
  double maximum_deviation = 0;
};

/*!
 * \ingroup PkgVertexLocationOptimizationRef
 *
 * \brief The distance of a polygon mesh from a reference surface, in the unit of the input.
 *
 * \sa `CGAL::Polygon_mesh_processing::approximation_error()`
 */
struct Approximation_error
{
  /// the mean of the distance over the area of the mesh
  double mean = 0;

  /// the root of the mean of the squared distance over the area of the mesh
  double rms = 0;

  /// the largest distance
  double max = 0;
};

/*!
 * \ingroup PkgVertexLocationOptimizationRef
 *
 * \brief The result of an optimization.
 *
 * \sa `CGAL::Polygon_mesh_processing::optimize_vertex_locations()`
 */
struct Vertex_location_optimization_report
{
  /// the number of iterations done; `0` if the input was unsuitable. After several attempts with decreasing weights of the
  /// regularity, this and all other values are those of the attempt whose result was chosen
  std::size_t iterations = 0;

  /// whether the run ended because no vertex moved farther than the convergence threshold
  bool converged = false;

  /// the largest displacement of a vertex in the last iteration, in the unit of the input
  double displacement = 0;

  /// the number of vertices whose positions differ from those in the input
  std::size_t moved_vertices = 0;

  /// the number of vertices whose moves were shortened, in an iteration or at the end
  std::size_t corrected_vertices = 0;

  /// the number of those shortened because a face would have been flipped, collapsed, or folded sharply
  std::size_t corrected_for_shape = 0;

  /// the number of those shortened because the distance between the surfaces would have increased
  std::size_t corrected_for_error = 0;

  /// the number of those shortened because two faces would have intersected that did not before
  std::size_t corrected_for_intersection = 0;

  /// the number of vertices whose moves `allow_move_functor` has refused
  std::size_t refused_vertices = 0;

  /// the distance from the mesh to the reference before, as measured for the guarantee
  Approximation_error initial_error;

  /// the same afterwards
  Approximation_error final_error;

  /// the distance from the reference to the mesh before; `0` unless both directions are guaranteed
  Approximation_error initial_error_from_reference;

  /// the same afterwards; the samples are not those that the mesh was fitted to
  Approximation_error final_error_from_reference;

  /// the relative change of the volume that the mesh encloses; `0` if it is not closed
  double volume_change = 0;

  /// whether the mesh encloses the volume of the reference, as requested by `preserve_volume`; `false` if this was not
  /// requested, if one of the two is not closed, or if the guarantee did not permit it
  bool is_volume_preserved = false;

  /// the surface to which the mesh was fitted
  Reference_surface_summary reference;
};

/*!
 * \ingroup PkgVertexLocationOptimizationRef
 *
 * \brief The phases of a run in their order: those of an iteration, and the final one.
 */
enum class Vertex_location_optimization_phase
{
  /// samples are taken from the reference surface
  SAMPLE_REFERENCE,
  /// the vertices are placed among the samples
  PLACE_VERTICES,
  /// the vertices are relaxed along the surface; after the free iterations, this phase does nothing
  RELAX_VERTICES,
  /// moves that flip a face are shortened
  CORRECT_FLIPS,
  /// after the iterations, the result is compared with the input, and moves that make it worse are shortened
  ENFORCE_GUARANTEE
};

/*!
 * \ingroup PkgVertexLocationOptimizationRef
 *
 * \brief The default visitor of `CGAL::Polygon_mesh_processing::optimize_vertex_locations()`: it does nothing.
 *
 * \cgalModels{VertexLocationOptimizationVisitor}
 */
struct Vertex_location_optimization_default_visitor
{
  /// is called before each phase.
  void start_phase(Vertex_location_optimization_phase) {}

  /// is called after each iteration with the report so far; a further attempt counts its iterations from the first.
  void end_iteration(const Vertex_location_optimization_report&) {}

  /// is called before each phase of an iteration; if it returns `false`, the run ends with the result of the last complete
  /// iteration.
  bool go_further() { return true; }
};

} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_POLYGON_MESH_PROCESSING_VERTEX_LOCATION_OPTIMIZATION_REPORT_H
