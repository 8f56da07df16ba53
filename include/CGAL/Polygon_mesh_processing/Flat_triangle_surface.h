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

#ifndef CGAL_POLYGON_MESH_PROCESSING_FLAT_TRIANGLE_SURFACE_H
#define CGAL_POLYGON_MESH_PROCESSING_FLAT_TRIANGLE_SURFACE_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Patch_surface.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/named_parameters.h>

#include <CGAL/Default.h>
#include <CGAL/tags.h>

namespace CGAL {
namespace Polygon_mesh_processing {

/*!
 * \ingroup PkgVertexLocationOptimizationSurfaces
 *
 * \brief The class `Flat_triangle_surface` is the piecewise linear surface of a polygon mesh.
 *
 * It is the reference surface for dense scans, whose triangles are much smaller than those of the remesh, and for
 * parts with planar faces. Its normals are those of the faces. Faces with more than three corners are triangulated on a
 * copy, in the same way as by `triangulate_faces()`.
 *
 * The surface does not refer to the mesh after construction, and several threads can use it at the same time. The
 * construction and a projection take as long as with `PN_triangle_surface`.
 *
 * \tparam PolygonMesh a model of `VertexListGraph`, `EdgeListGraph`, and `FaceListGraph`
 * \tparam GeomTraits a model of `Kernel`, whose points the surface receives and returns. The computations are done in
 *                    double precision. The default is the kernel of the points of `PolygonMesh`.
 *
 * \cgalModels{ReferenceSurface}
 *
 * \sa `CGAL::Polygon_mesh_processing::PN_triangle_surface`
 * \sa `CGAL::Polygon_mesh_processing::optimize_vertex_locations()`
 */
template <typename PolygonMesh, typename GeomTraits = Default>
class Flat_triangle_surface
#ifndef DOXYGEN_RUNNING
  : public internal::vertex_location::Patch_surface<
      internal::vertex_location::Flat_triangle,
      PolygonMesh,
      internal::vertex_location::Geom_traits_or_kernel_of<PolygonMesh, GeomTraits>>
#endif
{
  using Base =
    internal::vertex_location::Patch_surface<internal::vertex_location::Flat_triangle,
                                             PolygonMesh,
                                             internal::vertex_location::Geom_traits_or_kernel_of<PolygonMesh, GeomTraits>>;

public:
  /*!
   * \brief constructs the surface of `pmesh`.
   *
   * The parameters are those of the constructor of `PN_triangle_surface`. Creases do not change this surface; they are what
   * `optimize_vertex_locations()` fits constrained edges to if its parameter `relax_constraints` is `true`.
   *
   * \pre No face has fewer than three corners, or more than three with a repeated vertex, and all coordinates are finite.
   *      Otherwise the surface is empty.
   */
  template <typename NamedParameters = parameters::Default_named_parameters, typename ConcurrencyTag = Sequential_tag>
  explicit Flat_triangle_surface(const PolygonMesh& pmesh,
                                 const NamedParameters& np = parameters::default_values(),
                                 const ConcurrencyTag& = ConcurrencyTag())
    : Base(pmesh, np, ConcurrencyTag())
  {}

#ifdef DOXYGEN_RUNNING
  /// \name Types
  /// @{

  /// the points of `GeomTraits`
  typedef unspecified_type Point_3;

  /// the vectors of `GeomTraits`
  typedef unspecified_type Vector_3;

  /// where a point of the surface is: a face, and coordinates in it
  typedef unspecified_type Foot;

  /// @}

  /// \name Operations
  /// The functions of `ReferenceSurface`, and two more.
  /// @{

  /*!
   * returns the foot of `query`: the point of the surface that is closest to it.
   *
   * \pre the surface is not empty
   */
  Foot project(const Point_3& query) const;

  /*!
   * returns the foot of `query` as above; the search begins at `hint`, the foot of a point nearby.
   *
   * \pre the surface is not empty
   */
  Foot project(const Point_3& query, const Foot& hint) const;

  /*!
   * returns the point of the surface that `foot` stands for.
   */
  Point_3 point(const Foot& foot) const;

  /*!
   * returns the normal of the surface there: a vector of length 1, or the null vector where the surface has no normal.
   */
  Vector_3 normal(const Foot& foot) const;

  /*!
   * returns whether the surface has no face. Nothing can then be projected to it.
   */
  bool is_empty() const;

  /*!
   * returns the location of a foot in the mesh that the surface was made from: the face, and the barycentric coordinates in
   * it, in the order of `PMP::Face_location`, which begins with the source of the halfedge of the face. The point at this
   * location is the foot.
   */
  Face_location<PolygonMesh, double> location(const Foot& foot) const;

  /// @}
#endif
};

} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_POLYGON_MESH_PROCESSING_FLAT_TRIANGLE_SURFACE_H
