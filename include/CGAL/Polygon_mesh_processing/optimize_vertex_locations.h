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

#ifndef CGAL_POLYGON_MESH_PROCESSING_OPTIMIZE_VERTEX_LOCATIONS_H
#define CGAL_POLYGON_MESH_PROCESSING_OPTIMIZE_VERTEX_LOCATIONS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/optimize_faces.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/check_arguments.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/named_parameters.h>
#include <CGAL/Polygon_mesh_processing/Placement_method.h>
#include <CGAL/Polygon_mesh_processing/Vertex_location_optimization_report.h>

#include <CGAL/tags.h>

#include <type_traits>

namespace CGAL {
namespace Polygon_mesh_processing {

/*!
 * \ingroup PkgVertexLocationOptimizationRef
 *
 * \brief moves the vertices of a remesh off the surface that it was made from, so that its faces approximate that surface as
 *        well as its connectivity allows.
 *
 * A remesher leaves its vertices *on* a curved surface, so that the faces lie entirely on one side of the surface wherever
 * it is convex or concave. This function keeps the connectivity and balances the error between both sides: the mean distance
 * between the two surfaces falls to about half, and on a sphere to a fifth.
 *
 * Each iteration samples the reference at the vertices and at the midpoints of the edges, moves each vertex to its place in
 * the best piecewise linear fit to the samples around it, keeps the triangles regular by springs between neighbors, and
 * shortens moves that flip a face. This is Algorithm 1 of \cgalCite{vlo2012}, with equations (1) and (2) for the fit, and
 * (3) and (4) for the springs.
 *
 * As far as the samples show, the result is never worse than the input. Neither the mean nor the maximum distance from
 * `pmesh` to the reference is larger than before; with `guarantee_both_directions` the same holds for the distances from the
 * reference to `pmesh`. No face is flipped, that is, has turned by more than 60 degrees or opposes the reference where it
 * did not before. No face has collapsed, that is, has a smallest angle that is at once below 10 degrees, below half of its
 * initial value, and below the initial smallest angles of all faces around it. No edge is folded sharply, that is, at once
 * by more than a right angle, by 5 degrees more than any edge at its ends was initially, and by 10 degrees more than the
 * reference turns there. To this end, the distance is sampled at some ten thousand points, one to 576 in each face, and its
 * maximum is searched for by branch and bound, with a margin of 1%. Moves are shortened only where they do harm. If a mean
 * still has not fallen by more than its samples leave uncertain, all moves are taken back. Section \ref secVLOGuarantee
 * describes what the samples may miss.
 *
 * The faces may have any number of corners. A face with more than three corners represents the mean of its fan
 * triangulations, one from each of its corners, all with the same weight: for a quad, these are its two pairs of triangles,
 * each with weight one half. The result thus does not depend on which corner comes first. Distances, errors and the
 * guarantee above are those of these triangles; springs act along the edges of the faces. See Section \ref secVLOPolygons.
 *
 * The computations are done in double precision, whatever the kernel of the points; with an exact kernel, the points of
 * vertices that move are converted. The result does not depend on the number of threads.
 *
 * If the visitor, a functor, or a property map throws an exception, `pmesh` is unchanged.
 *
 * An iteration takes \cgalBigO{n \log m} time for \f$ n \f$ vertices and a reference of \f$ m \f$ faces.
 *
 * \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`,
 *                        `Parallel_tag`, and `Parallel_if_available_tag`.
 * \tparam PolygonMesh a model of `VertexListGraph`, `EdgeListGraph`, and `FaceListGraph`
 * \tparam Reference a model of `VertexListGraph`, `EdgeListGraph`, and `FaceListGraph`, of any type, or a model of
 *                   `ReferenceSurface`
 * \tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
 * \tparam NamedParameters2 a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param pmesh the remesh, whose vertices are moved; its faces may have more than three corners. Vertices at the same point,
 *              such as the copies of a non-manifold vertex, do not move.
 * \param reference the surface that `pmesh` approximates: the polygon mesh that was remeshed, which is taken as a
 *                  `PN_triangle_surface`, or, if creases make up more than a third of the total length of its edges, as a
 *                  `Flat_triangle_surface`; or a reference surface, which can be used for many calls. The report says which
 *                  surface was used.
 * \param np1 an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `pmesh`}
 *     \cgalParamType{a class model of `ReadWritePropertyMap` with
 *                    `boost::graph_traits<PolygonMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, pmesh)`}
 *     \cgalParamExtra{If this parameter is omitted, an internal property map for `CGAL::vertex_point_t` must be
 *                     available in `PolygonMesh`.}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{number_of_iterations}
 *     \cgalParamDescription{the maximum number of iterations}
 *     \cgalParamType{unsigned integer}
 *     \cgalParamDefault{`30`}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{number_of_free_iterations}
 *     \cgalParamDescription{the number of iterations, at the beginning, in which vertices move freely; afterwards they
 *                           move only along the normal of the reference}
 *     \cgalParamType{unsigned integer}
 *     \cgalParamDefault{`20`}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{convergence_threshold}
 *     \cgalParamDescription{The iterations end when no vertex has moved farther than this threshold, relative to the mean
 *                           length of the edges around it. If the closest points were not exact, one more iteration follows.
 *                           With `LEAST_SQUARES`, the threshold applies to the root mean square of the displacements along
 *                           the normals of the reference instead.}
 *     \cgalParamType{a number type convertible to `double`}
 *     \cgalParamDefault{`1e-6`; with `LEAST_SQUARES`, 5% of the mean distance at the barycenters of the faces, relative to
 *                       the lengths of their edges, but not less than `1e-4`}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{placement_method}
 *     \cgalParamDescription{how the position of a vertex is computed from the samples}
 *     \cgalParamType{`Placement_method`}
 *     \cgalParamDefault{`PIECEWISE_LINEAR`}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{regularity_weight}
 *     \cgalParamDescription{with `LEAST_SQUARES`, the weight of the regularity of the faces relative to their error; a
 *                           smaller weight gives a smaller error and less regular triangles. Where the current error is
 *                           below 3% of the length of the edges around, the weight is reduced in proportion to the error. If
 *                           the guarantee moves most vertices back and the mean error falls by less than 2%, further
 *                           attempts are made with a quarter and a sixteenth of the weight. The result is the one with the
 *                           smallest mean error for which the mean of the smallest angles does not fall.}
 *     \cgalParamType{a number type convertible to `double`, or `std::optional<double>`, where an empty one stands for the
 *                    default}
 *     \cgalParamDefault{`0.19` where the faces of `pmesh` are regular, with smallest angles of 46 degrees on
 *                       average; less, down to a quarter, where these angles are smaller, as after simplification}
 *     \cgalParamExtra{The springs of `PIECEWISE_LINEAR` have no weight: see `number_of_relaxation_steps`. With
 *                     `LEAST_SQUARES` only the vertices of constrained edges have springs, and free iterations apply
 *                     to these vertices only.}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{number_of_relaxation_steps}
 *     \cgalParamDescription{the number of relaxation steps with springs in each free iteration; `0` turns the springs off}
 *     \cgalParamType{unsigned integer, or `std::optional<std::size_t>`, where an empty one stands for the default}
 *     \cgalParamDefault{`1`, with springs that are weaker where the angles of `pmesh` are smaller, and absent where their
 *                       mean is below 36 degrees, as after simplification; `0` if a face has more than three corners}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{a property map containing the constrained-or-not status of each edge of `pmesh`. The
 *                           vertices of constrained edges do not move or, with `relax_constraints`, follow the creases
 *                           and borders of the reference.}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<PolygonMesh>::%edge_descriptor` as key type and `bool` as value type}
 *     \cgalParamDefault{a default property map where no edge is constrained}
 *     \cgalParamExtra{Border edges are always constrained.}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{relax_constraints}
 *     \cgalParamDescription{If `true`, a vertex with exactly two constrained edges that form an angle of more than 120
 *                           degrees moves to where these edges best approximate the crease or border of the reference
 *                           along which they run. Other vertices of constrained edges are corners and do not move.
 *                           If a corner of the reference, at which creases or borders meet, has been cut off, the nearest
 *                           vertex with the same number of constrained edges moves to it.}
 *     \cgalParamType{Boolean}
 *     \cgalParamDefault{`false`}
 *     \cgalParamExtra{The creases of the reference are those of `PN_triangle_surface` and `Flat_triangle_surface`. With
 *                     another model of `ReferenceSurface` the vertices of constrained edges do not move.}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{vertex_is_constrained_map}
 *     \cgalParamDescription{a property map containing the constrained-or-not status of each vertex of `pmesh`. A
 *                           constrained vertex does not move.}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<PolygonMesh>::%vertex_descriptor` as key type and `bool` as value type}
 *     \cgalParamDefault{a default property map where no vertex is constrained}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{allow_move_functor}
 *     \cgalParamDescription{a function object that decides whether a vertex may be moved. It is called, by one thread,
 *                           for each move of an iteration and, at the end, for the entire move from the input position; if
 *                           the entire move is refused, the vertex returns to its input position.}
 *     \cgalParamType{a functor that provides `bool operator()(vertex_descriptor v, Point_3 src, Point_3 tgt)`, returning
 *                    `true` if the vertex `v` may be moved from `src` to `tgt`; `%Point_3` being the value type of the
 *                    vertex point map}
 *     \cgalParamDefault{If not provided, all moves are allowed.}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{do_self_intersection_tests}
 *     \cgalParamDescription{If `true`, moves are shortened until no two faces intersect that did not before. The test is
 *                           done at the end of the run, by `self_intersections()`, on a triangulation of the faces;
 *                           intersections between triangles of the same face do not count.}
 *     \cgalParamType{Boolean}
 *     \cgalParamDefault{`false`; `true` with `LEAST_SQUARES`}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{guarantee_both_directions}
 *     \cgalParamDescription{If `true`, the guarantee extends to the mean and the maximum distance from the reference to
 *                           `pmesh`, which show whether a thin part has become shorter.}
 *     \cgalParamType{Boolean}
 *     \cgalParamDefault{`false`; `true` with `LEAST_SQUARES`}
 *     \cgalParamExtra{The reference must be a mesh, a `PN_triangle_surface`, or a `Flat_triangle_surface`. Another model of
 *                     `ReferenceSurface` cannot be sampled; the parameter then has no effect.}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{preserve_volume}
 *     \cgalParamDescription{If `true`, and if `pmesh` and the reference are closed, the vertices are finally moved along
 *                           their normals so that `pmesh` encloses the volume of the reference. Constrained vertices do not
 *                           move, nor do those whose move would violate the guarantee. The report says whether the volume
 *                           was reached.}
 *     \cgalParamType{Boolean}
 *     \cgalParamDefault{`false`}
 *     \cgalParamExtra{Among the models of `ReferenceSurface`, only those of this package can be recognized as closed.}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor that is notified of the progress and can stop the run}
 *     \cgalParamType{a class model of `VertexLocationOptimizationVisitor`; `std::ref()` of one, so that it is not copied}
 *     \cgalParamDefault{`Vertex_location_optimization_default_visitor`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \param np2 an optional sequence of \ref bgl_namedparameters "Named Parameters": those of the constructor of
 *            `PN_triangle_surface` if `reference` is a mesh; none if it is a reference surface
 *
 * \pre no face of `pmesh` or, if it is a mesh, of `reference` has fewer than three corners, or more than three with a
 *      repeated vertex
 * \pre all coordinates are finite
 * \pre `convergence_threshold` and `regularity_weight` are not negative
 * \pre the reference has a face, unless `pmesh` has no vertex
 *
 * \return what was done. If a precondition is violated and not checked, `pmesh` is untouched and the report says that
 *         there was no iteration.
 *
 * \sa `CGAL::Polygon_mesh_processing::isotropic_remeshing()`
 * \sa `CGAL::Polygon_mesh_processing::approximation_error()`
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
Vertex_location_optimization_report optimize_vertex_locations(PolygonMesh& pmesh,
                                                              const Reference& reference,
                                                              const NamedParameters1& np1 = parameters::default_values(),
                                                              const NamedParameters2& np2 = parameters::default_values())
{
  using namespace internal::vertex_location;
  if constexpr(check_arguments<PolygonMesh, Reference, NamedParameters1, NamedParameters2>)
    return optimize_faces<ConcurrencyTag>(pmesh, All_faces(), reference, np1, np2);
  else
    return {};
}

/*!
 * \ingroup PkgVertexLocationOptimizationRef
 *
 * \brief moves the vertices of a part of a remesh, as the function for the whole mesh does.
 *
 * Only vertices all of whose faces are in the range move. All others remain bitwise unchanged, even with
 * `relax_constraints`. The result is the same as if all other vertices were constrained, except for the choice of samples
 * with `LEAST_SQUARES`. The errors that are compared at the end, and the report, are those of the range. Self-intersections
 * with the rest of `pmesh` are tested as well. With `LEAST_SQUARES`, the parts of the reference that are closer to the rest
 * of `pmesh` are ignored.
 *
 * The time of an iteration depends on the range alone. Reading the faces takes \cgalBigO{n} time for the \f$ n \f$ faces of
 * `pmesh`, and finding the parts of the reference that are closer to the rest takes \cgalBigO{n \log n} time, once.
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
 * \param faces the faces of `pmesh` to be optimized; a face may be repeated, and the range may be empty
 * \param pmesh the remesh, some of whose vertices are moved
 * \param reference the surface that the whole of `pmesh` approximates
 * \param np1 an optional sequence of \ref bgl_namedparameters "Named Parameters", as for the whole mesh
 * \param np2 an optional sequence of \ref bgl_namedparameters "Named Parameters", as for the whole mesh
 *
 * \pre those of the function for the whole mesh
 *
 * \return what was done
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
Vertex_location_optimization_report optimize_vertex_locations(const FaceRange& faces,
                                                              PolygonMesh& pmesh,
                                                              const Reference& reference,
                                                              const NamedParameters1& np1 = parameters::default_values(),
                                                              const NamedParameters2& np2 = parameters::default_values())
{
  using namespace internal::vertex_location;
  if constexpr(check_arguments<PolygonMesh, Reference, NamedParameters1, NamedParameters2>)
    return optimize_faces<ConcurrencyTag>(pmesh, Face_selection<PolygonMesh>(faces, pmesh), reference, np1, np2);
  else
    return {};
}

} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_POLYGON_MESH_PROCESSING_OPTIMIZE_VERTEX_LOCATIONS_H
