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

#ifndef CGAL_POLYGON_MESH_PROCESSING_PN_TRIANGLE_SURFACE_H
#define CGAL_POLYGON_MESH_PROCESSING_PN_TRIANGLE_SURFACE_H

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
 * \brief The class `PN_triangle_surface` is the smooth surface that the vertices and normals of a polygon mesh suggest.
 *
 * Each face of the mesh carries a curved PN triangle \cgalCite{vpbm2001}: a cubic Bézier triangle that interpolates the
 * vertices and, as far as they agree, is orthogonal to the normals there, and a quadratic interpolation of the normals.
 * Normals are not averaged across creases. Both sides of a crease share the curve along it, so that the surface has no gaps.
 *
 * Coplanar faces form one facet. The normal at a vertex is initially the average of the normals of the facets around it,
 * weighted by their angles; facets less than half as large as the largest one count less. A few sweeps then correct the
 * normals such that each edge makes the same angle with the surface at both of its ends, as it does on every quadric
 * surface. The normals where a plane meets a fillet are thus those of the plane, and the triangulation of a facet does not
 * matter.
 *
 * Where the normals do not define a consistent curved patch, the surface follows the edges of the mesh. The curve over an
 * edge deviates from the edge only if the surface also bends beyond one of its ends. The deviation at one end is at most
 * three times that at the other, and at most that of an edge four times as long as the one that continues it. Planes,
 * chamfers, the rulings of cones, and flat sheets with a curved border therefore remain unchanged.
 *
 * No point of the surface is farther from the face it belongs to than
 * \f$ \frac{2}{3} l \sin \alpha \f$, where \f$ l \f$ is the length of the longest edge of the face and \f$ \alpha \f$ the
 * largest angle between the face and the tangent planes at its vertices.
 *
 * Faces with more than three corners are first triangulated on a copy, in the same way as by `triangulate_faces()`.
 *
 * The surface neither refers to the mesh after construction nor changes with it. Several threads can use it at the same
 * time.
 *
 * The construction takes \cgalBigO{n \log n} time for \f$ n \f$ faces, and a projection takes \cgalBigO{\log n} time if the
 * query point is near the surface.
 *
 * \tparam PolygonMesh a model of `VertexListGraph`, `EdgeListGraph`, and `FaceListGraph`
 * \tparam GeomTraits a model of `Kernel`, whose points the surface receives and returns. The computations are done in
 *                    double precision. The default is the kernel of the points of `PolygonMesh`.
 *
 * \cgalModels{ReferenceSurface}
 *
 * \sa `CGAL::Polygon_mesh_processing::Flat_triangle_surface`
 * \sa `CGAL::Polygon_mesh_processing::optimize_vertex_locations()`
 */
template <typename PolygonMesh, typename GeomTraits = Default>
class PN_triangle_surface
#ifndef DOXYGEN_RUNNING
  : public internal::vertex_location::Patch_surface<
      internal::vertex_location::PN_triangle,
      PolygonMesh,
      internal::vertex_location::Geom_traits_or_kernel_of<PolygonMesh, GeomTraits>>
#endif
{
  using Base =
    internal::vertex_location::Patch_surface<internal::vertex_location::PN_triangle,
                                             PolygonMesh,
                                             internal::vertex_location::Geom_traits_or_kernel_of<PolygonMesh, GeomTraits>>;

public:
  /*!
   * \brief constructs the surface of `pmesh`.
   *
   * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
   * \tparam ConcurrencyTag enables sequential versus parallel construction; possible values are `Sequential_tag`,
   *                        `Parallel_tag`, and `Parallel_if_available_tag`
   *
   * \param pmesh the polygon mesh
   * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{vertex_point_map}
   *     \cgalParamDescription{a property map associating points to the vertices of `pmesh`}
   *     \cgalParamType{a class model of `ReadablePropertyMap` with
   *                    `boost::graph_traits<PolygonMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
   *     \cgalParamDefault{`boost::get(CGAL::vertex_point, pmesh)`}
   *   \cgalParamNEnd
   *
   *   \cgalParamNBegin{edge_is_constrained_map}
   *     \cgalParamDescription{a property map containing the crease-or-not status of each edge of `pmesh`}
   *     \cgalParamType{a class model of `ReadablePropertyMap` with
   *                    `boost::graph_traits<PolygonMesh>::%edge_descriptor` as key type and `bool` as value type}
   *     \cgalParamDefault{the edges sharper than `sharpness_angle` are creases}
   *     \cgalParamExtra{If both this map and `sharpness_angle` are given, an edge is a crease if it meets one of the two
   *                     criteria.}
   *   \cgalParamNEnd
   *
   *   \cgalParamNBegin{sharpness_angle}
   *     \cgalParamDescription{An edge is a crease if the normals of its two faces differ by more than this angle.}
   *     \cgalParamType{a number type convertible to `double`, in degrees}
   *     \cgalParamDefault{`40`}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \pre No face has fewer than three corners, or more than three with a repeated vertex, and all coordinates are finite.
   *      Otherwise the surface is empty.
   */
  template <typename NamedParameters = parameters::Default_named_parameters, typename ConcurrencyTag = Sequential_tag>
  explicit PN_triangle_surface(const PolygonMesh& pmesh,
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
   * it, in the order of `PMP::Face_location`, which begins with the source of the halfedge of the face. The point of the
   * face with these coordinates is not on the surface, but below or above the foot.
   *
   * \pre the face is a triangle, as other faces have no barycentric coordinates
   */
  Face_location<PolygonMesh, double> location(const Foot& foot) const;

  /// @}
#endif
};

} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_POLYGON_MESH_PROCESSING_PN_TRIANGLE_SURFACE_H
