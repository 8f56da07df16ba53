// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POLYGON_MESH_PROCESSING_APPROXIMATION_ERROR_H
#define CGAL_POLYGON_MESH_PROCESSING_APPROXIMATION_ERROR_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/attribute_maps.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/measure_error.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/measure_normals.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/with_reference_surface.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/named_parameters.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_mesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_parameters.h>

#include <CGAL/tags.h>

#include <limits>
#include <type_traits>

namespace CGAL {
namespace Polygon_mesh_processing {

/*!
 * \ingroup PkgVertexLocationOptimizationRef
 *
 * \brief How far a triangle mesh is from a reference surface, in the unit of the input.
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
 * \brief measures the distance of the points of a triangle mesh to a reference surface: its mean, its root mean square,
 *        and its maximum.
 *
 * The distance \f$ e(x) \f$ of a point \f$ x \f$ of `tmesh` is that to the closest point of the reference; the mean is
 * \f$ \frac{1}{A} \int e(x)\,dx \f$ over the area \f$ A \f$ of `tmesh`, equation (5) of \cgalCite{vlo2012}. The
 * integral is taken from samples. A face gets as many as there are faces of the reference below it, small faces get few,
 * and more are taken until the mean is known to about 0.2%. The maximum is searched for on whole faces, edges and vertices
 * included, from the samples where it may be; it is within 1% on nearly all meshes. Beware that the search is bounded: a
 * peak of the distance that is much narrower than the faces of both surfaces may be missed.
 *
 * The distance is one-sided: a part of the reference that `tmesh` lacks does not count. The distance of the points of
 * the reference to `tmesh` is measured with the arguments swapped. As a mesh in the place of the reference is taken as
 * smooth, `Flat_triangle_surface` keeps the faces of `tmesh` flat:
 *
 * \code{.cpp}
 * PMP::Approximation_error there = PMP::approximation_error(remesh, input);
 * PMP::Approximation_error back = PMP::approximation_error(input, PMP::Flat_triangle_surface<Mesh>(remesh));
 * \endcode
 *
 * In this direction it is the faces of `input`, not its PN triangles, that are sampled.
 *
 * The computations are done in double precision. The result does not depend on the number of threads.
 *
 * \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`,
 *                        `Parallel_tag`, and `Parallel_if_available_tag`.
 * \tparam TriangleMesh a model of `VertexListGraph`, `EdgeListGraph`, and `FaceListGraph`
 * \tparam Reference a model of `VertexListGraph`, `EdgeListGraph`, and `FaceListGraph`, of any type, or a model of
 *                   `ReferenceSurface`
 * \tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
 * \tparam NamedParameters2 a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tmesh the triangle mesh whose points are measured
 * \param reference the surface that the distance is measured to: a triangle mesh, which is taken as a
 *                  `PN_triangle_surface`, or a reference surface
 * \param np1 an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{number_of_points_per_face}
 *     \cgalParamDescription{the number of samples in each face, for the mean and the root mean square. It is rounded up to
 *                           a square number: the samples are the centroids of congruent triangles that the face is
 *                           divided into.}
 *     \cgalParamType{unsigned integer}
 *     \cgalParamDefault{follows the reference}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{number_of_points_per_area_unit}
 *     \cgalParamDescription{the number of samples for each unit of area, in the unit of the input. Each face gets so many,
 *                           or `number_of_points_per_face` if that is more.}
 *     \cgalParamType{double}
 *     \cgalParamDefault{follows the reference}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{face_error_map}
 *     \cgalParamDescription{a property map that receives the mean distance over each face}
 *     \cgalParamType{a class model of `WritablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `double` as value type}
 *     \cgalParamDefault{not written}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{vertex_error_map}
 *     \cgalParamDescription{a property map that receives for each vertex the mean distance over the faces around it,
 *                           or the distance of the vertex itself if there is none or they have no area}
 *     \cgalParamType{a class model of `WritablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `double` as value type}
 *     \cgalParamDefault{not written}
 *     \cgalParamExtra{The vertices of a remesh lie on the reference, so that their own distances say nothing. The mean
 *                     of this map, where each vertex has a third of the area around it, is the mean over `tmesh`.}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * `face_error_map` and `vertex_error_map` come before the parameters of \cgal in a sequence.
 *
 * \param np2 an optional sequence of \ref bgl_namedparameters "Named Parameters": those of the constructor of
 *            `PN_triangle_surface` if `reference` is a triangle mesh; not used if it is a reference surface
 *
 * \pre `CGAL::is_triangle_mesh(tmesh)` and, if `reference` is a mesh, `CGAL::is_triangle_mesh(reference)`
 * \pre all coordinates are finite
 * \pre the reference has a face, unless `tmesh` has no vertex
 *
 * \return the error. Where `tmesh` has no area the mean and the root mean square are `0`, and so is the maximum if it
 *         has no face. If a precondition is violated and not checked, all three are infinite and the maps are untouched.
 *         They are infinite too where coordinates are so large that areas overflow; never `NaN`.
 *
 * \sa `CGAL::Polygon_mesh_processing::optimize_vertex_locations()`
 * \sa `CGAL::Polygon_mesh_processing::normal_deviation()`
 * \sa `CGAL::Polygon_mesh_processing::approximate_Hausdorff_distance()`
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename TriangleMesh,
          typename Reference,
          typename NamedParameters1 = parameters::Default_named_parameters,
          typename NamedParameters2 = parameters::Default_named_parameters>
Approximation_error approximation_error(const TriangleMesh& tmesh,
                                        const Reference& reference,
                                        const NamedParameters1& np1 = parameters::default_values(),
                                        const NamedParameters2& np2 = parameters::default_values())
{
  using namespace internal::vertex_location;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  constexpr bool has_face_map = !is_default_parameter<NamedParameters1, internal_np::face_error_map_t>::value;
  constexpr bool has_vertex_map = !is_default_parameter<NamedParameters1, internal_np::vertex_error_map_t>::value;
  constexpr double infinity = std::numeric_limits<double>::infinity();

  Mesh_arrays mesh;
  Mesh_descriptors<TriangleMesh> descriptors;
  const Approximation_error failure{ infinity, infinity, infinity };
  if(!read_mesh(tmesh, read_vertex_point_map(tmesh, np1), mesh, descriptors))
    return failure;
  const Sampling_density density = read_sampling_density(np1);

  return with_reference<ConcurrencyTag>(mesh, reference, np2, failure, [&](const auto& surface) -> Approximation_error {
    const auto measure = measure_error<ConcurrencyTag>(mesh, mesh.points, surface, density);

    if constexpr(has_face_map)
    {
      const auto face_error_map = get_parameter(np1, internal_np::face_error_map);
      for(std::size_t f = 0; f < measure.faces.size(); ++f)
        put(face_error_map, face(descriptors.halfedges[f], tmesh), measure.faces[f].mean);
    }
    if constexpr(has_vertex_map)
    {
      const auto vertex_error_map = get_parameter(np1, internal_np::vertex_error_map);
      const auto means = mean_around_vertices<ConcurrencyTag>(mesh, surface, measure.vertex_feet, measure.faces);
      for(std::size_t i = 0; i < means.size(); ++i)
        put(vertex_error_map, descriptors.vertices[i], means[i]);
    }

    const Error_sum error = measure.template sum<ConcurrencyTag>();
    return { error.mean(), error.rms(), error.max };
  });
}

/*!
 * \ingroup PkgVertexLocationOptimizationRef
 *
 * \brief measures the angle between the normals of a triangle mesh and those of a reference surface.
 *
 * Each point of a face has a normal, interpolated linearly from those at the corners. The angle between it and the normal of
 * the reference at the closest point is averaged over the area of `tmesh`. Unless the user says how many, a face gets eight
 * samples for each face of the reference that it covers, and 16 at least.
 *
 * The computations are done in double precision. The result does not depend on the number of threads.
 *
 * \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`,
 *                        `Parallel_tag`, and `Parallel_if_available_tag`.
 * \tparam TriangleMesh a model of `VertexListGraph`, `EdgeListGraph`, and `FaceListGraph`
 * \tparam Reference a model of `VertexListGraph`, `EdgeListGraph`, and `FaceListGraph`, of any type, or a model of
 *                   `ReferenceSurface`
 * \tparam NormalMap a class model of `ReadablePropertyMap` with `%Vector_3` as value type, and as key type
 *                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor`, or
 *                   `boost::graph_traits<TriangleMesh>::%halfedge_descriptor`
 * \tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
 * \tparam NamedParameters2 a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tmesh the triangle mesh
 * \param reference the surface that gives the normals to compare with: a triangle mesh, which is taken as a
 *                  `PN_triangle_surface`, or a reference surface
 * \param normal_map the normals of the vertices of `tmesh`, or those of the corners of its faces: the normal of a
 *                   halfedge is that of its face at its target. They need not have length 1.
 * \param np1 an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`,
 *            `number_of_points_per_face`, and `number_of_points_per_area_unit`, as those of `approximation_error()`
 * \param np2 an optional sequence of \ref bgl_namedparameters "Named Parameters": those of the constructor of
 *            `PN_triangle_surface` if `reference` is a triangle mesh; not used if it is a reference surface
 *
 * \pre `CGAL::is_triangle_mesh(tmesh)` and, if `reference` is a mesh, `CGAL::is_triangle_mesh(reference)`
 * \pre all coordinates are finite
 * \pre the reference has a face, unless `tmesh` has no vertex
 *
 * \return the mean angle in degrees. Where one of the two normals has no direction nothing is counted; `0` if nothing is
 *         counted at all. `180` if a precondition is violated and not checked, and where coordinates are so large that
 *         areas overflow.
 *
 * \sa `CGAL::Polygon_mesh_processing::optimize_vertex_normals()`
 * \sa `CGAL::Polygon_mesh_processing::approximation_error()`
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename TriangleMesh,
          typename Reference,
          typename NormalMap,
          typename NamedParameters1 = parameters::Default_named_parameters,
          typename NamedParameters2 = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<!internal::Is_named_parameters<NormalMap>::value, int> = 0
#endif
          >
double normal_deviation(const TriangleMesh& tmesh,
                        const Reference& reference,
                        const NormalMap& normal_map,
                        const NamedParameters1& np1 = parameters::default_values(),
                        const NamedParameters2& np2 = parameters::default_values())
{
  using namespace internal::vertex_location;
  return measure_normals<ConcurrencyTag>(tmesh, reference, np1, np2, [&](const auto& mesh, const auto& descriptors) {
    return read_corner_values<Vector>(tmesh, mesh, descriptors, normal_map,
                                      [](const auto& normal) { return convert<Vector>(normal); });
  });
}

/*!
 * \ingroup PkgVertexLocationOptimizationRef
 *
 * \brief measures the angle between the normals of the faces of a triangle mesh and those of a reference surface.
 *
 * All points of a face have the normal of the face; all else is as in the function that takes a map of normals.
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename TriangleMesh,
          typename Reference,
          typename NamedParameters1 = parameters::Default_named_parameters,
          typename NamedParameters2 = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<internal::Is_named_parameters<NamedParameters1>::value, int> = 0
#endif
          >
double normal_deviation(const TriangleMesh& tmesh,
                        const Reference& reference,
                        const NamedParameters1& np1 = parameters::default_values(),
                        const NamedParameters2& np2 = parameters::default_values())
{
  using namespace internal::vertex_location;
  return measure_normals<ConcurrencyTag>(
    tmesh, reference, np1, np2, [](const auto& mesh, const auto&) { return face_normals_at_corners<ConcurrencyTag>(mesh); });
}

} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_POLYGON_MESH_PROCESSING_APPROXIMATION_ERROR_H
