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

#ifndef CGAL_POLYGON_MESH_PROCESSING_APPROXIMATION_ERROR_H
#define CGAL_POLYGON_MESH_PROCESSING_APPROXIMATION_ERROR_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/attribute_maps.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/measure_faces_of.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/measure_normals.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/check_arguments.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Face_selection.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/named_parameters.h>
#include <CGAL/Polygon_mesh_processing/Vertex_location_optimization_report.h>

#include <CGAL/tags.h>

#include <type_traits>

namespace CGAL {
namespace Polygon_mesh_processing {

/*!
 * \ingroup PkgVertexLocationOptimizationRef
 *
 * \brief measures the mean, the root mean square, and the maximum of the distance of the points of a polygon mesh to a
 *        reference surface.
 *
 * The distance \f$ e(x) \f$ of a point \f$ x \f$ of `pmesh` is that to the closest point of the reference; the mean is
 * \f$ \frac{1}{A} \int e(x)\,dx \f$ over the area \f$ A \f$ of `pmesh`, equation (5) of \cgalCite{vlo2012}. The integral is
 * estimated from samples. A face gets as many samples as there are faces of the reference below it, small faces get few, and
 * samples are added until the mean is likely to be accurate to a few thousandths. Its error is typically 0.1%, but may be 2%
 * on a mesh of a few large faces. The maximum is searched for on whole faces, including their edges and vertices, starting
 * from the samples near which it may be; it is within 1% on most meshes. The search is bounded, however: a peak of the
 * distance that is much narrower than the faces of both surfaces may be missed.
 *
 * A face with more than three corners represents the mean of its fan triangulations, one from each of its corners, as in
 * `optimize_vertex_locations()`. The samples are weighted and lie in all of their triangles; the maximum is that over all
 * triangles.
 *
 * The distance is one-sided: a part of the reference that `pmesh` lacks does not count. The distance of the points of
 * the reference to `pmesh` is measured with the arguments swapped. As a mesh passed as reference is taken to be smooth, use
 * `Flat_triangle_surface` to keep the faces of `pmesh` flat:
 *
 * \code{.cpp}
 * PMP::Approximation_error there = PMP::approximation_error(remesh, input);
 * PMP::Approximation_error back = PMP::approximation_error(input, PMP::Flat_triangle_surface<Mesh>(remesh));
 * \endcode
 *
 * In this direction, the faces of `input` are sampled, not its PN triangles, and faces of `remesh` with more than three
 * corners are triangulated.
 *
 * The computations are done in double precision. The result does not depend on the number of threads.
 *
 * \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`,
 *                        `Parallel_tag`, and `Parallel_if_available_tag`.
 * \tparam PolygonMesh a model of `VertexListGraph`, `EdgeListGraph`, and `FaceListGraph`
 * \tparam Reference a model of `VertexListGraph`, `EdgeListGraph`, and `FaceListGraph`, of any type, or a model of
 *                   `ReferenceSurface`
 * \tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
 * \tparam NamedParameters2 a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param pmesh the polygon mesh whose points are measured
 * \param reference the surface to which the distance is measured: a polygon mesh, which is taken as a `PN_triangle_surface`,
 *                  or a reference surface
 * \param np1 an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `pmesh`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<PolygonMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, pmesh)`}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{number_of_points_per_face}
 *     \cgalParamDescription{the number of samples in each triangle, for the mean and the root mean square. It is rounded up
 *                           to a square number: the samples are the centroids of congruent triangles that the triangle
 *                           is divided into.}
 *     \cgalParamType{unsigned integer}
 *     \cgalParamDefault{follows the reference}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{number_of_points_per_area_unit}
 *     \cgalParamDescription{the number of samples per unit of area, in the unit of the input. Each triangle gets the
 *                           resulting number of samples, or `number_of_points_per_face` if that is larger.}
 *     \cgalParamType{double}
 *     \cgalParamDefault{follows the reference}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{face_error_map}
 *     \cgalParamDescription{a property map that receives the mean distance over each face}
 *     \cgalParamType{a class model of `WritablePropertyMap` with
 *                    `boost::graph_traits<PolygonMesh>::%face_descriptor` as key type and `double` as value type}
 *     \cgalParamDefault{not written}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{vertex_error_map}
 *     \cgalParamDescription{a property map that receives for each vertex the mean distance over the faces around it,
 *                           or the distance of the vertex itself if there is none or they have no area}
 *     \cgalParamType{a class model of `WritablePropertyMap` with
 *                    `boost::graph_traits<PolygonMesh>::%vertex_descriptor` as key type and `double` as value type}
 *     \cgalParamDefault{not written}
 *     \cgalParamExtra{The vertices of a remesh lie on the reference, so that their own distances are meaningless. If the
 *                     faces are triangles, the mean of this map, with a third of the area around each vertex as its weight,
 *                     is the mean over `pmesh`.}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \param np2 an optional sequence of \ref bgl_namedparameters "Named Parameters": those of the constructor of
 *            `PN_triangle_surface` if `reference` is a mesh; none if it is a reference surface
 *
 * \pre no face of `pmesh` or, if it is a mesh, of `reference` has fewer than three corners, or more than three with a
 *      repeated vertex
 * \pre all coordinates are finite
 * \pre the reference has a face, unless `pmesh` has no vertex
 *
 * \return the error. Where `pmesh` has no area the mean and the root mean square are `0`, and so is the maximum if it
 *         has no face. If a precondition is violated and not checked, all three are infinite and the maps are untouched.
 *         They are also infinite if coordinates are so large that areas overflow. They are never `NaN`.
 *
 * \sa `CGAL::Polygon_mesh_processing::optimize_vertex_locations()`
 * \sa `CGAL::Polygon_mesh_processing::normal_deviation()`
 * \sa `CGAL::Polygon_mesh_processing::approximate_Hausdorff_distance()`
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename PolygonMesh,
          typename Reference,
          typename NamedParameters1 = parameters::Default_named_parameters,
          typename NamedParameters2 = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<internal::Is_named_parameters<NamedParameters1>::value, int> = 0
#endif
          >
Approximation_error approximation_error(const PolygonMesh& pmesh,
                                        const Reference& reference,
                                        const NamedParameters1& np1 = parameters::default_values(),
                                        const NamedParameters2& np2 = parameters::default_values())
{
  using namespace internal::vertex_location;
  if constexpr(check_arguments<PolygonMesh, Reference, NamedParameters1, NamedParameters2>)
    return measure_faces_of<ConcurrencyTag>(pmesh, All_faces(), reference, np1, np2);
  else
    return {};
}

/*!
 * \ingroup PkgVertexLocationOptimizationRef
 *
 * \brief measures the distance of a part of a polygon mesh to a reference surface, as the function for the whole mesh does.
 *
 * \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`,
 *                        `Parallel_tag`, and `Parallel_if_available_tag`.
 * \tparam FaceRange a model of `ConstRange` with `boost::graph_traits<PolygonMesh>::%face_descriptor` as value type
 * \tparam PolygonMesh a model of `VertexListGraph`, `EdgeListGraph`, and `FaceListGraph`
 * \tparam Reference a model of `VertexListGraph`, `EdgeListGraph`, and `FaceListGraph`, of any type, or a model of
 *                   `ReferenceSurface`
 * \tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
 * \tparam NamedParameters2 a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param faces the faces of `pmesh` that are measured; a repeated face counts once. The error maps receive values only for
 *              these faces and their vertices, the latter over the faces of the range alone.
 * \param pmesh the polygon mesh
 * \param reference the surface to which the distance is measured
 * \param np1 an optional sequence of \ref bgl_namedparameters "Named Parameters", as for the whole mesh
 * \param np2 an optional sequence of \ref bgl_namedparameters "Named Parameters", as for the whole mesh
 *
 * \pre those of the function for the whole mesh
 *
 * \return the error
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename FaceRange,
          typename PolygonMesh,
          typename Reference,
          typename NamedParameters1 = parameters::Default_named_parameters,
          typename NamedParameters2 = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<!internal::Is_named_parameters<Reference>::value, int> = 0
#endif
          >
Approximation_error approximation_error(const FaceRange& faces,
                                        const PolygonMesh& pmesh,
                                        const Reference& reference,
                                        const NamedParameters1& np1 = parameters::default_values(),
                                        const NamedParameters2& np2 = parameters::default_values())
{
  using namespace internal::vertex_location;
  if constexpr(check_arguments<PolygonMesh, Reference, NamedParameters1, NamedParameters2>)
    return measure_faces_of<ConcurrencyTag>(pmesh, Face_selection<PolygonMesh>(faces, pmesh), reference, np1, np2);
  else
    return {};
}

/*!
 * \ingroup PkgVertexLocationOptimizationRef
 *
 * \brief measures the angle between the normals of a polygon mesh and those of a reference surface.
 *
 * Each point of a face has a normal, interpolated linearly from those at the corners. The angle between it and the normal of
 * the reference at the closest point is averaged over the area of `pmesh`. By default, a face gets two samples for each
 * face of the reference that it covers, and at least 25, at quasi-random places.
 *
 * The computations are done in double precision. The result does not depend on the number of threads.
 *
 * \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`,
 *                        `Parallel_tag`, and `Parallel_if_available_tag`.
 * \tparam PolygonMesh a model of `VertexListGraph`, `EdgeListGraph`, and `FaceListGraph`
 * \tparam Reference a model of `VertexListGraph`, `EdgeListGraph`, and `FaceListGraph`, of any type, or a model of
 *                   `ReferenceSurface`
 * \tparam NormalMap a class model of `ReadablePropertyMap` with `%Vector_3` as value type, and as key type
 *                   `boost::graph_traits<PolygonMesh>::%vertex_descriptor`, or
 *                   `boost::graph_traits<PolygonMesh>::%halfedge_descriptor`
 * \tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
 * \tparam NamedParameters2 a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param pmesh the polygon mesh
 * \param reference the surface that gives the normals to compare with: a polygon mesh, which is taken as a
 *                  `PN_triangle_surface`, or a reference surface
 * \param normal_map the normals of the vertices of `pmesh`, or those of the corners of its faces: the normal of a
 *                   halfedge is that of its face at its target. They need not have length 1.
 * \param np1 an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`,
 *            `number_of_points_per_face`, and `number_of_points_per_area_unit`, as those of `approximation_error()`
 * \param np2 an optional sequence of \ref bgl_namedparameters "Named Parameters": those of the constructor of
 *            `PN_triangle_surface` if `reference` is a mesh; none if it is a reference surface
 *
 * \pre no face of `pmesh` or, if it is a mesh, of `reference` has fewer than three corners, or more than three with a
 *      repeated vertex
 * \pre all coordinates are finite
 * \pre the reference has a face, unless `pmesh` has no vertex
 *
 * \return the mean angle in degrees. Points where one of the two normals has no direction are not counted; the angle is `0`
 *         if there are no other points. It is `180` if a precondition is violated and not checked, or if coordinates are so
 *         large that areas overflow.
 *
 * \sa `CGAL::Polygon_mesh_processing::optimize_vertex_normals()`
 * \sa `CGAL::Polygon_mesh_processing::approximation_error()`
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename PolygonMesh,
          typename Reference,
          typename NormalMap,
          typename NamedParameters1 = parameters::Default_named_parameters,
          typename NamedParameters2 = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<!internal::Is_named_parameters<NormalMap>::value, int> = 0
#endif
          >
double normal_deviation(const PolygonMesh& pmesh,
                        const Reference& reference,
                        const NormalMap& normal_map,
                        const NamedParameters1& np1 = parameters::default_values(),
                        const NamedParameters2& np2 = parameters::default_values())
{
  using namespace internal::vertex_location;
  if constexpr(check_arguments<PolygonMesh, Reference, NamedParameters1, NamedParameters2>)
    return measure_normals<ConcurrencyTag>(pmesh, reference, np1, np2, [&](const auto& mesh, const auto& descriptors) {
      return read_corner_values<Vector>(pmesh, mesh, descriptors, normal_map,
                                        [](const auto& normal) { return convert<Vector>(normal); });
    });
  else
    return {};
}

/*!
 * \ingroup PkgVertexLocationOptimizationRef
 *
 * \brief measures the angle between the normals of the faces of a polygon mesh and those of a reference surface.
 *
 * All points of a face have the normal of the face. Otherwise, this function is the same as the one with a map of normals.
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename PolygonMesh,
          typename Reference,
          typename NamedParameters1 = parameters::Default_named_parameters,
          typename NamedParameters2 = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<internal::Is_named_parameters<NamedParameters1>::value, int> = 0
#endif
          >
double normal_deviation(const PolygonMesh& pmesh,
                        const Reference& reference,
                        const NamedParameters1& np1 = parameters::default_values(),
                        const NamedParameters2& np2 = parameters::default_values())
{
  using namespace internal::vertex_location;
  if constexpr(check_arguments<PolygonMesh, Reference, NamedParameters1, NamedParameters2>)
    return measure_normals<ConcurrencyTag>(pmesh, reference, np1, np2, [](const auto& mesh, const auto&) {
      return face_normals_at_corners<ConcurrencyTag>(mesh);
    });
  else
    return {};
}

} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_POLYGON_MESH_PROCESSING_APPROXIMATION_ERROR_H
