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

#ifndef CGAL_POLYGON_MESH_PROCESSING_ATTRIBUTE_ERROR_H
#define CGAL_POLYGON_MESH_PROCESSING_ATTRIBUTE_ERROR_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/approximation_error.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/measure_attribute.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/read_signal.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/with_described_reference.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/check_arguments.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/named_parameters.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_parameters.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {

/*!
 * \ingroup PkgVertexLocationOptimizationRef
 *
 * \brief measures the mean, the root mean square, and the maximum of the difference between an attribute of a polygon mesh
 *        and that of a reference surface.
 *
 * At a point of `pmesh` the values of the map, interpolated linearly over the face, are compared with the attribute of the
 * reference at the closest point. The difference between two values is their Euclidean distance, also for colors, whose
 * channels range from 0 to 255. The means are taken over the area of `pmesh`, as in `approximation_error()`.
 *
 * At a seam of the reference (see `optimize_vertex_attributes()`), a face is compared with the side on which its center
 * lies.
 *
 * The result does not depend on the number of threads.
 *
 * \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`,
 *                        `Parallel_tag`, and `Parallel_if_available_tag`.
 * \tparam PolygonMesh a model of `VertexListGraph`, `EdgeListGraph`, and `FaceListGraph`
 * \tparam Reference a model of `VertexListGraph`, `EdgeListGraph`, and `FaceListGraph`, of any type, or a
 *                   `PN_triangle_surface` or `Flat_triangle_surface`
 * \tparam ReferenceAttributeMap a class model of `ReadablePropertyMap`, with keys and values as for
 *                               `optimize_vertex_attributes()`
 * \tparam AttributeMap a class model of `ReadablePropertyMap` with
 *                      `boost::graph_traits<PolygonMesh>::%vertex_descriptor` or
 *                      `boost::graph_traits<PolygonMesh>::%halfedge_descriptor` as key type, and a value type with as many
 *                      numbers
 * \tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
 * \tparam NamedParameters2 a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param pmesh the polygon mesh
 * \param reference the surface that the attribute belongs to: a polygon mesh, which is taken as a `PN_triangle_surface`, or
 *                  a reference surface that was made from one
 * \param reference_attribute_map the attribute of the reference, at its vertices or at the corners of its faces: the value
 *                                of a halfedge is that of its face at its target
 * \param attribute_map the attribute of `pmesh`, at its vertices or at the corners of its faces
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
 *     \cgalParamDescription{the number of samples in each triangle. It is rounded up to six times a square number: the
 *                           triangle is divided into congruent triangles, with six samples in each of them.}
 *     \cgalParamType{unsigned integer}
 *     \cgalParamDefault{`64`}
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
 * \pre the maps have finite values for all vertices, or for the halfedges of all faces
 *
 * \return the error, in the unit of the attribute. Where `pmesh` has no area the mean and the root mean square are `0`, and
 *         so is the maximum if it has no face. If a precondition is violated and not checked, all three are infinite. They
 *         are also infinite if numbers are so large that they overflow. They are never `NaN`.
 *
 * \sa `CGAL::Polygon_mesh_processing::optimize_vertex_attributes()`
 * \sa `CGAL::Polygon_mesh_processing::approximation_error()`
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename PolygonMesh,
          typename Reference,
          typename ReferenceAttributeMap,
          typename AttributeMap,
          typename NamedParameters1 = parameters::Default_named_parameters,
          typename NamedParameters2 = parameters::Default_named_parameters>
Approximation_error attribute_error(const PolygonMesh& pmesh,
                                    const Reference& reference,
                                    const ReferenceAttributeMap& reference_attribute_map,
                                    const AttributeMap& attribute_map,
                                    const NamedParameters1& np1 = parameters::default_values(),
                                    const NamedParameters2& np2 = parameters::default_values())
{
  using namespace internal::vertex_location;
  static_assert(check_arguments<PolygonMesh, Reference, NamedParameters1, NamedParameters2>, "The errors above say why.");
  using parameters::choose_parameter;
  using parameters::get_parameter;

  using Attribute = Attribute_value<typename boost::property_traits<AttributeMap>::value_type>;
  using Reference_attribute = Attribute_value<typename boost::property_traits<ReferenceAttributeMap>::value_type>;
  constexpr std::size_t dimension = Attribute::dimension;
  static_assert(dimension > 0 && Reference_attribute::dimension == dimension,
                "The values of both maps must be numbers, points, vectors, colors or arrays, with as many numbers each.");
  using Value = Signal_value<dimension>;
  constexpr double infinity = std::numeric_limits<double>::infinity();

  const Approximation_error failure{ infinity, infinity, infinity };
  Mesh_arrays mesh;
  Mesh_descriptors<PolygonMesh> descriptors;
  if(!read_mesh(pmesh, read_vertex_point_map(pmesh, np1), mesh, descriptors))
    return failure;
  const std::size_t number_of_points =
    choose_parameter(get_parameter(np1, internal_np::number_of_points_per_face), default_number_of_points_per_face);
  bool has_mesh_values = has_all_values(pmesh, mesh, descriptors, attribute_map);
  std::vector<Value> corner_values;
  if(has_mesh_values)
    corner_values = read_corner_values<Value>(pmesh, mesh, descriptors, attribute_map,
                                              [](const auto& x) { return Attribute::to_signal(x); });
  for(const Value& value : corner_values)
    has_mesh_values = has_mesh_values && is_finite(value);
  CGAL_precondition_msg(has_mesh_values, "An attribute of the mesh is missing or not finite.");
  if(!has_mesh_values)
    return failure;

  const auto measure = [&](const auto& patches, const auto& in_reference) -> Approximation_error {
    using Patches = std::decay_t<decltype(patches)>;
    std::vector<std::array<Value, 3>> patch_values;
    const bool has_values = read_patch_values(in_reference, reference_attribute_map, patch_values);
    CGAL_precondition_msg(has_values, "An attribute of the reference is missing or not finite.");
    if(!has_values)
      return failure;
    if(mesh.points.empty())
      return {};

    const Map_signal<Patches, dimension> signal(patches, std::move(patch_values));
    return measure_attribute<ConcurrencyTag>(mesh, corner_values, signal, number_of_points).error();
  };
  return with_described_reference<ConcurrencyTag>(mesh, reference, np2, failure, measure);
}

} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_POLYGON_MESH_PROCESSING_ATTRIBUTE_ERROR_H
