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

#ifndef CGAL_POLYGON_MESH_PROCESSING_REMESH_WITHIN_TOLERANCE_H
#define CGAL_POLYGON_MESH_PROCESSING_REMESH_WITHIN_TOLERANCE_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/check_arguments.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/named_parameters.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_mesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_parameters.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Tolerance/find_coarsest_remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Tolerance/read_tolerance_parameters.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/Tolerance_report.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <type_traits>

namespace CGAL {
namespace Polygon_mesh_processing {

/*!
 * \ingroup PkgVertexLocationOptimizationRef
 *
 * \brief finds the coarsest remesh of a triangle mesh whose error is within a tolerance.
 *
 * The remesher is called with several edge lengths, each time for a copy of `input`. Each remesh is optimized by
 * `optimize_vertex_locations()` and measured in both directions, from the remesh to the reference and back. The error is
 * roughly proportional to the square of the edge length. A secant method on logarithms, with an initial guess from the
 * curvature of the input, usually needs four to seven remeshings to find the edge length to 2%. The search does not rely on
 * this law: the error may be noisy or jump, and the remesher may ignore the edge length or fail at some lengths. The result
 * is the remesh with the fewest vertices among those within the tolerance. If there is none, it is the remesh with the
 * smallest error, and the report says so.
 *
 * The error is the distance to the faces of `input` as they are; the report contains the values of `approximation_error()`
 * for the result. To use the smooth surface that `input` represents instead, pass a `PN_triangle_surface` of it as
 * `reference_surface`.
 *
 * The largest distance often occurs only in some spots. With `MAXIMUM_ERROR`, if no more than a fifth of the faces of a
 * remesh exceed the tolerance after the optimization, the remesh is refined at the worst faces, and the faces around them
 * are optimized again, in up to 24 rounds: edges are flipped if this brings two faces closer to the reference, vertices that
 * exceed the tolerance are moved to the reference, and other faces are split at the midpoints of their longest edges.
 * Neither a flip nor a move may cause new intersections. The result thus has more vertices than the remesher made, but the
 * additional vertices allow longer edges elsewhere. If the refinement fails, the search still continues with longer edge
 * lengths, and returns to shorter ones at the end.
 *
 * No remesh is requested that would have more than four times as many faces as `input`, or 100000 if that is more. The
 * result is deterministic if the remesher is, and does not depend on the number of threads.
 *
 * \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`,
 *                        `Parallel_tag`, and `Parallel_if_available_tag`. The remesher is called sequentially.
 * \tparam TriangleMesh a model of `VertexListGraph`, `EdgeListGraph`, `FaceListGraph`, and `MutableFaceGraph` that has an
 *                      internal property map for `CGAL::vertex_point_t`. It is copyable, and a copy has its vertices and
 *                      edges in the same order.
 * \tparam Remesh a function object; see `remesh`
 * \tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
 * \tparam NamedParameters2 a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param input the triangle mesh to remesh
 * \param tolerance the largest error that is tolerated, in the unit of the input
 * \param result the remesh. It can be `input` itself. If the remesher leaves removed elements in a mesh, `result` contains
 *               them, too.
 * \param remesh a remesher or simplifier: `remesh(mesh, edge_length)` remeshes `mesh`, a copy of `input`, with the given
 *               edge length, or with another size derived from it. An optional third argument is a model of
 *               `ReadWritePropertyMap` with the edges of `mesh` as keys and `bool` as values, which marks the constrained
 *               edges; the remesher must preserve these edges and update the map, as `isotropic_remeshing()` does. A
 *               remesher without this argument may replace `mesh` by another mesh, and has no constrained edges. An optional
 *               fourth argument is such a map for the vertices. It marks the corners, which should not move: the vertices of
 *               constrained edges and of the border, unless there are exactly two such edges that form an angle of more than
 *               120 degrees. Exceptions thrown by `remesh` are passed on, and `result` is then untouched. A mesh without a
 *               face, with faces that are not triangles, or with a coordinate that is not finite counts as a failure at that
 *               edge length.
 * \param np1 an optional sequence of \ref bgl_namedparameters "Named Parameters": those of `optimize_vertex_locations()`,
 *            which are passed on to it, except for the maps of the remesh, `vertex_point_map` and
 *            `vertex_is_constrained_map`; and the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{tolerated_error}
 *     \cgalParamDescription{the error that is kept within the tolerance, in both directions}
 *     \cgalParamType{`Tolerated_error`}
 *     \cgalParamDefault{`MAXIMUM_ERROR`}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{edge_length_precision}
 *     \cgalParamDescription{The search ends when one edge length is within the tolerance and another one, larger by at most
 *                           this relative difference, is not. After seven remeshings, it also ends if refined remeshes with
 *                           edge lengths in between exceed the tolerance.}
 *     \cgalParamType{a number type convertible to `double`}
 *     \cgalParamDefault{`0.02`}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{maximum_number_of_remeshings}
 *     \cgalParamDescription{the maximum number of calls of the remesher}
 *     \cgalParamType{unsigned integer}
 *     \cgalParamDefault{`12`}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{reference_surface}
 *     \cgalParamDescription{the surface to which remeshes are fitted and compared, instead of the faces of `input`. In the
 *                           direction from the reference to the remesh, the surface is sampled if it is from this package;
 *                           otherwise, its samples are the points closest to those of the faces of `input`.}
 *     \cgalParamType{a model of `ReferenceSurface`, or `std::cref()` of one, so that it is not copied}
 *     \cgalParamDefault{a `Flat_triangle_surface` of `input`, made once for all remeshings}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{a property map containing the constrained-or-not status of each edge of `input`. These edges are
 *                           the creases that the remesher must preserve, and the creases of the reference unless `np2`
 *                           specifies others.}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type}
 *     \cgalParamDefault{a default property map where no edge is constrained}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{placement_method}
 *     \cgalParamDescription{as in `optimize_vertex_locations()`, with another default}
 *     \cgalParamType{`Placement_method`}
 *     \cgalParamDefault{`LEAST_SQUARES`}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{relax_constraints}
 *     \cgalParamDescription{as in `optimize_vertex_locations()`, with another default: constrained edges and the border are
 *                           fitted to those of the input, so that they need fewer vertices. If `false`, their vertices stay
 *                           where the remesher has put them.}
 *     \cgalParamType{Boolean}
 *     \cgalParamDefault{`true`}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor that is notified of each remeshing and can stop the search}
 *     \cgalParamType{a class model of `ToleranceVisitor`; `std::ref()` of one, so that it is not copied}
 *     \cgalParamDefault{`Tolerance_default_visitor`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \param np2 an optional sequence of \ref bgl_namedparameters "Named Parameters": those of the constructor of
 *            `Flat_triangle_surface` for the creases of `input`, except for `vertex_point_map`; not used if
 *            `reference_surface` is given
 *
 * \pre `CGAL::is_triangle_mesh(input)`, it has a face, all its coordinates are finite, and not all its points are the same
 * \pre `tolerance` and `edge_length_precision` are positive and finite
 *
 * \return the report of the result. If a precondition is violated and not checked, `result` is untouched and the report says
 *         that there was no remeshing.
 *
 * \sa `CGAL::Polygon_mesh_processing::optimize_vertex_locations()`
 * \sa `CGAL::Polygon_mesh_processing::approximation_error()`
 * \sa `CGAL::Polygon_mesh_processing::isotropic_remeshing()`
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename TriangleMesh,
          typename Remesh,
          typename NamedParameters1 = parameters::Default_named_parameters,
          typename NamedParameters2 = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<!internal::Is_named_parameters<Remesh>::value, int> = 0
#endif
          >
Tolerance_report remesh_within_tolerance(const TriangleMesh& input,
                                         double tolerance,
                                         TriangleMesh& result,
                                         const Remesh& remesh,
                                         const NamedParameters1& np1 = parameters::default_values(),
                                         const NamedParameters2& np2 = parameters::default_values())
{
  using namespace internal::vertex_location;
  static_assert(Mesh_check<TriangleMesh, NamedParameters1>::value && First_sequence_check<NamedParameters1>::value &&
                  Second_sequence_check<NamedParameters2>::value,
                "The errors above say why.");
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  const Search_limits limits = read_search_limits(np1);
  const bool is_valid = tolerance > 0 && std::isfinite(tolerance) && limits.edge_length_precision > 0 &&
                        std::isfinite(limits.edge_length_precision) && is_triangle_mesh(input);
  CGAL_precondition_msg(is_valid,
                        "The tolerance and edge_length_precision must be positive and finite, and the input must be "
                        "a triangle mesh.");
  Mesh_arrays arrays;
  Mesh_descriptors<TriangleMesh> descriptors;
  if(!is_valid || !read_mesh(input, get(vertex_point, input), arrays, descriptors))
    return {};
  const Mesh_extent extent(arrays);
  const bool has_extent = arrays.number_of_faces() > 0 && extent.longest_side > 0;
  CGAL_precondition_msg(has_extent, "The input has no face, or all its points are the same.");
  if(!has_extent)
    return {};

  auto visitor_or_reference = choose_parameter(get_parameter(np1, internal_np::visitor), Tolerance_default_visitor());
  auto& visitor = unwrap_reference(visitor_or_reference);
  const Kept_elements kept = find_kept_elements(input, np1);
  const Tolerated_error kind = choose_parameter(get_parameter(np1, internal_np::tolerated_error), MAXIMUM_ERROR);
  const Flat_triangle_surface<TriangleMesh> input_surface = make_input_surface<ConcurrencyTag>(input, np1, np2);
  const auto find = [&](const auto& surface) {
    const Tolerance_setting<TriangleMesh, std::decay_t<decltype(surface)>> setting{ input,   input_surface, arrays, kept,
                                                                                    surface, tolerance,     kind };
    return find_coarsest_remesh<ConcurrencyTag>(setting, extent, limits, remesh, np1, visitor, result);
  };
  if constexpr(is_default_parameter<NamedParameters1, internal_np::reference_surface_t>::value)
    return find(input_surface);
  else
  {
    auto surface_or_reference = get_parameter(np1, internal_np::reference_surface);
    return find(unwrap_reference(surface_or_reference));
  }
}

/*!
 * \ingroup PkgVertexLocationOptimizationRef
 *
 * \brief finds the coarsest remesh by `isotropic_remeshing()` whose error is within a tolerance.
 *
 * This function uses `isotropic_remeshing()` as the remesher, with 10 iterations of 3 relaxation steps. It preserves the
 * constrained edges of `input`, their corners, and those of the border.
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename TriangleMesh,
          typename NamedParameters1 = parameters::Default_named_parameters,
          typename NamedParameters2 = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<internal::Is_named_parameters<NamedParameters1>::value, int> = 0
#endif
          >
Tolerance_report remesh_within_tolerance(const TriangleMesh& input,
                                         double tolerance,
                                         TriangleMesh& result,
                                         const NamedParameters1& np1 = parameters::default_values(),
                                         const NamedParameters2& np2 = parameters::default_values())
{
  const auto remesh = [](TriangleMesh& mesh, double edge_length, const auto& is_constrained, const auto& is_corner) {
    isotropic_remeshing(faces(mesh), edge_length, mesh,
                        parameters::edge_is_constrained_map(is_constrained)
                          .vertex_is_constrained_map(is_corner)
                          .number_of_iterations(10)
                          .number_of_relaxation_steps(3));
  };
  return remesh_within_tolerance<ConcurrencyTag>(input, tolerance, result, remesh, np1, np2);
}

} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_POLYGON_MESH_PROCESSING_REMESH_WITHIN_TOLERANCE_H
