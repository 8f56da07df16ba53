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

#ifndef CGAL_POLYGON_MESH_PROCESSING_OPTIMIZE_VERTEX_ATTRIBUTES_H
#define CGAL_POLYGON_MESH_PROCESSING_OPTIMIZE_VERTEX_ATTRIBUTES_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/attribute_maps.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/Attribute_value.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/Corner_nodes.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/fit_signal.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/Map_signal.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/read_signal.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/with_described_reference.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/check_arguments.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/named_parameters.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_parameters.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {

/*!
 * \ingroup PkgVertexLocationOptimizationRef
 *
 * \brief computes the values of an attribute, such as colors or texture coordinates, of the vertices of a polygon mesh
 *        whose interpolation over its faces is closest to the attribute of a reference surface.
 *
 * A remesher drops the attributes of its input. Copying them from the closest points of the vertices ignores the values
 * between the vertices, and aliases details that are finer than the faces. This
 * function treats the attribute of the reference as a signal \f$ s \f$, as \cgalCite{vlo2012} treats points and normals
 * (Sections 3.1 and 3.4), and finds the values \f$ a_k \f$ that minimize
 * \f[ \int \Big\| \sum_k \lambda_k(x)\,a_k - s(\pi(x)) \Big\|^2 dx \f]
 * over the surface of `pmesh`, where \f$ \lambda_k \f$ are the barycentric coordinates in the triangle of \f$ x \f$ and
 * \f$ \pi(x) \f$ is the point of the reference that is closest to \f$ x \f$. Call this function after
 * `optimize_vertex_locations()`.
 *
 * The integral is a sum over samples, at least six in each face of `pmesh`, and in total about as many as the reference has
 * faces: details finer than the faces of `pmesh` are averaged. A signal that is linear over the surface is reproduced up to
 * rounding. The mean difference at the samples is never larger than with the values at the closest points of the vertices.
 *
 * A face with more than three corners represents the mean of its fan triangulations, as in `optimize_vertex_locations()`:
 * each of their triangles contributes to the sum with its weight.
 *
 * <b>Seams.</b> Attributes of the reference such as texture coordinates may have seams: edges with different values on their
 * two sides. Such an attribute must be given by a map of halfedges, which holds the values at the corners of the faces. A
 * face of `pmesh` is sampled only on the side of its center; no sample crosses a seam. `pmesh` has seams at the edges marked
 * in `edge_is_constrained_map`, and between faces that are on different sides of a seam of the reference. A map of halfedges
 * receives the values of both sides. A map of vertices receives those of the side with the largest area around the vertex.
 * Values are thus never mixed across a seam. Seams look best if the remesher keeps them as edges.
 *
 * Unit vectors do not keep length 1; for normals, use `optimize_vertex_normals()`. Numbers of an integral type, and the
 * channels of a color, are rounded to the nearest integer and clamped to the range of their type.
 *
 * The result does not depend on the number of threads.
 *
 * The function takes \cgalBigO{(n + m) \log m} time and \cgalBigO{n + m} memory for \f$ n \f$ vertices and a reference of
 * \f$ m \f$ faces: the linear system with the mass matrix of `pmesh` is solved by a fixed number of Chebyshev iterations.
 *
 * \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`,
 *                        `Parallel_tag`, and `Parallel_if_available_tag`.
 * \tparam PolygonMesh a model of `VertexListGraph`, `EdgeListGraph`, and `FaceListGraph`
 * \tparam Reference a model of `VertexListGraph`, `EdgeListGraph`, and `FaceListGraph`, of any type, or a
 *                   `PN_triangle_surface` or `Flat_triangle_surface`
 * \tparam ReferenceAttributeMap a class model of `ReadablePropertyMap`. The key type is the vertex or the halfedge
 *                               descriptor of the mesh that `reference` is or was made from. The value type is a number
 *                               type, such as `double` or `unsigned char`; `%Point_2`, `%Point_3`, `%Vector_2` or
 *                               `%Vector_3` of a \cgal kernel; `CGAL::IO::Color`; or a `std::array` of numbers.
 * \tparam AttributeMap a class model of `WritablePropertyMap` with
 *                      `boost::graph_traits<PolygonMesh>::%vertex_descriptor` or
 *                      `boost::graph_traits<PolygonMesh>::%halfedge_descriptor` as key type, and a value type as above with
 *                      as many numbers
 * \tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
 * \tparam NamedParameters2 a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param pmesh the polygon mesh
 * \param reference the surface that the attribute belongs to: a polygon mesh, which is taken as a `PN_triangle_surface`, or
 *                  a reference surface that was made from one
 * \param reference_attribute_map the attribute of the reference, at its vertices or at the corners of its faces: the value
 *                                of a halfedge is that of its face at its target. It is interpolated linearly over each
 *                                face.
 * \param attribute_map receives the values at the vertices of `pmesh` or at the corners of its faces. Border halfedges
 *                      receive none.
 * \param np1 an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{clamp_to_samples}
 *     \cgalParamDescription{If `true`, each component of a value is clamped to the range of the samples at the vertex and in
 *                           the faces around it on the same side of a seam. If `false`, values may overshoot, for example
 *                           near an edge in a picture.}
 *     \cgalParamType{Boolean}
 *     \cgalParamDefault{`true`}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `pmesh`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<PolygonMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, pmesh)`}
 *   \cgalParamNEnd
 *
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{a property map containing the seam-or-not status of each edge of `pmesh`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<PolygonMesh>::%edge_descriptor` as key type and `bool` as value type}
 *     \cgalParamDefault{a default property map where no edge is a seam, except for those that separate the sides of a seam
 *                       of the reference}
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
 * \pre the maps have values for all vertices, or for the halfedges of all faces; those of `reference_attribute_map` are
 * finite
 *
 * If a precondition is violated and not checked, `attribute_map` is untouched.
 *
 * \sa `CGAL::Polygon_mesh_processing::attribute_error()`
 * \sa `CGAL::Polygon_mesh_processing::transfer_face_attributes()`
 * \sa `CGAL::Polygon_mesh_processing::optimize_vertex_normals()`
 * \sa `CGAL::Polygon_mesh_processing::optimize_vertex_locations()`
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename PolygonMesh,
          typename Reference,
          typename ReferenceAttributeMap,
          typename AttributeMap,
          typename NamedParameters1 = parameters::Default_named_parameters,
          typename NamedParameters2 = parameters::Default_named_parameters>
void optimize_vertex_attributes(const PolygonMesh& pmesh,
                                const Reference& reference,
                                const ReferenceAttributeMap& reference_attribute_map,
                                AttributeMap attribute_map,
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

  const bool clamp_to_samples = choose_parameter(get_parameter(np1, internal_np::clamp_to_samples), true);
  Mesh_arrays mesh;
  Mesh_descriptors<PolygonMesh> descriptors;
  if(!read_mesh(pmesh, read_vertex_point_map(pmesh, np1), mesh, descriptors))
    return;
  const std::vector<char> is_seam = find_constrained_edges(mesh, descriptors, np1);
  const bool is_map_of_mesh = has_all_values(pmesh, mesh, descriptors, attribute_map);
  CGAL_precondition_msg(is_map_of_mesh, "The attribute map is not one of the mesh.");
  if(!is_map_of_mesh)
    return;

  with_described_reference<ConcurrencyTag>(mesh, reference, np2, false, [&](const auto& patches, const auto& in_reference) {
    using Patches = std::decay_t<decltype(patches)>;
    std::vector<std::array<Signal_value<dimension>, 3>> patch_values;
    const bool has_values = read_patch_values(in_reference, reference_attribute_map, patch_values);
    CGAL_precondition_msg(has_values, "An attribute of the reference is missing or not finite.");
    if(!has_values || mesh.points.empty())
      return false;

    const Map_signal<Patches, dimension> signal(patches, std::move(patch_values));
    const auto samples = sample_signal<ConcurrencyTag>(mesh, signal, is_seam);
    Signal_fit<Signal_value<dimension>> fit(mesh, samples);
    fit.template solve<ConcurrencyTag>(clamp_to_samples);

    const Corner_nodes& nodes = fit.nodes();
    const std::vector<Index> node_of_vertex = choose_vertex_nodes(mesh, nodes);
    write_values(
      pmesh, mesh, descriptors, attribute_map,
      [&](std::size_t c) { return Attribute::from_signal(fit.values()[nodes.of_corner(c)]); },
      [&](std::size_t i) {
        return Attribute::from_signal(node_of_vertex[i] == no_index ? samples.at_vertices[i]
                                                                    : fit.values()[node_of_vertex[i]]);
      });
    return true;
  });
}

} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_POLYGON_MESH_PROCESSING_OPTIMIZE_VERTEX_ATTRIBUTES_H
