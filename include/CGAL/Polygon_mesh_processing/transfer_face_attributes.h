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

#ifndef CGAL_POLYGON_MESH_PROCESSING_TRANSFER_FACE_ATTRIBUTES_H
#define CGAL_POLYGON_MESH_PROCESSING_TRANSFER_FACE_ATTRIBUTES_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/attribute_maps.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/choose_labels.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/with_described_reference.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/check_arguments.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/named_parameters.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_parameters.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {

/*!
 * \ingroup PkgVertexLocationOptimizationRef
 *
 * \brief assigns to each face of a polygon mesh the value that covers the largest part of it on a reference surface, for
 *        example a material or the id of a patch.
 *
 * Ids and labels cannot be averaged. Each face is sampled, and gets the most frequent value at the closest points of
 * the reference. The boundaries between regions of equal values thus end up on the edges of `pmesh` nearest to them.
 *
 * The result does not depend on the number of threads.
 *
 * The function takes \cgalBigO{(n + m) \log m} time for \f$ n \f$ vertices and a reference of \f$ m \f$ faces.
 *
 * \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`,
 *                        `Parallel_tag`, and `Parallel_if_available_tag`.
 * \tparam PolygonMesh a model of `VertexListGraph`, `EdgeListGraph`, and `FaceListGraph`
 * \tparam Reference a model of `VertexListGraph`, `EdgeListGraph`, and `FaceListGraph`, of any type, or a
 *                   `PN_triangle_surface` or `Flat_triangle_surface`
 * \tparam ReferenceFaceMap a class model of `ReadablePropertyMap`. The key type is the face descriptor of the mesh that
 *                          `reference` is or was made from, and the value type is a model of `EqualityComparable` and
 *                          `CopyConstructible`.
 * \tparam FaceMap a class model of `WritablePropertyMap` with `boost::graph_traits<PolygonMesh>::%face_descriptor` as key
 *                 type and a value type to which that of `ReferenceFaceMap` is convertible
 * \tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
 * \tparam NamedParameters2 a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param pmesh the polygon mesh
 * \param reference the surface that the attribute belongs to: a polygon mesh, which is taken as a `PN_triangle_surface`, or
 *                  a reference surface that was made from one
 * \param reference_face_map the values of the faces of the reference
 * \param face_map receives the values of the faces of `pmesh`
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
 * \cgalNamedParamsEnd
 *
 * \param np2 an optional sequence of \ref bgl_namedparameters "Named Parameters": those of the constructor of
 *            `PN_triangle_surface` if `reference` is a mesh; none if it is a reference surface
 *
 * \pre no face of `pmesh` or, if it is a mesh, of `reference` has fewer than three corners, or more than three with a
 *      repeated vertex
 * \pre all coordinates are finite
 * \pre the reference has a face, unless `pmesh` has no face
 * \pre the maps have values for all faces
 *
 * If a precondition is violated and not checked, `face_map` is untouched.
 *
 * \sa `CGAL::Polygon_mesh_processing::optimize_vertex_attributes()`
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename PolygonMesh,
          typename Reference,
          typename ReferenceFaceMap,
          typename FaceMap,
          typename NamedParameters1 = parameters::Default_named_parameters,
          typename NamedParameters2 = parameters::Default_named_parameters>
void transfer_face_attributes(const PolygonMesh& pmesh,
                              const Reference& reference,
                              const ReferenceFaceMap& reference_face_map,
                              FaceMap face_map,
                              const NamedParameters1& np1 = parameters::default_values(),
                              const NamedParameters2& np2 = parameters::default_values())
{
  using namespace internal::vertex_location;
  static_assert(check_arguments<PolygonMesh, Reference, NamedParameters1, NamedParameters2>, "The errors above say why.");

  Mesh_arrays mesh;
  Mesh_descriptors<PolygonMesh> descriptors;
  if(!read_mesh(pmesh, read_vertex_point_map(pmesh, np1), mesh, descriptors))
    return;
  bool is_map_of_mesh = true;
  for(auto h : descriptors.halfedges)
    is_map_of_mesh = is_map_of_mesh && has_value_for(face_map, face(h, pmesh));
  CGAL_precondition_msg(is_map_of_mesh, "The map is not one of the faces of the mesh.");
  if(!is_map_of_mesh || mesh.number_of_faces() == 0)
    return;

  with_described_reference<ConcurrencyTag>(mesh, reference, np2, false, [&](const auto& patches, const auto& in_reference) {
    std::vector<Label<typename boost::property_traits<ReferenceFaceMap>::value_type>> labels;
    const bool has_labels = read_labels(in_reference, reference_face_map, labels);
    CGAL_precondition_msg(has_labels, "A face of the reference has no value.");
    if(!has_labels)
      return false;

    const std::vector<Index> chosen =
      choose_labels<ConcurrencyTag>(mesh, patches, [&](Index a, Index b) { return labels[a].value == labels[b].value; });
    for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      put(face_map, face(descriptors.halfedges[f], pmesh), labels[chosen[mesh.polygon(f)]].value);
    return true;
  });
}

} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_POLYGON_MESH_PROCESSING_TRANSFER_FACE_ATTRIBUTES_H
