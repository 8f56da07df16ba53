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

#ifndef CGAL_POLYGON_MESH_PROCESSING_OPTIMIZE_VERTEX_NORMALS_H
#define CGAL_POLYGON_MESH_PROCESSING_OPTIMIZE_VERTEX_NORMALS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/attribute_maps.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/fit_signal.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/Normal_signal.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/with_reference_surface.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/check_arguments.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/named_parameters.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_mesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_parameters.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {

/*!
 * \ingroup PkgVertexLocationOptimizationRef
 *
 * \brief computes the unit normals of the vertices of a polygon mesh whose interpolation over its faces is closest to
 *        the normals of a reference surface.
 *
 * A renderer interpolates the normals of the vertices. Averages of face normals are inaccurate where the mesh is coarse, and
 * the normals of the reference at the vertices vary too much on average. This function fits a piecewise linear function to
 * the normals of the reference, as `optimize_vertex_attributes()` does with any attribute, and scales its values to length 1
 * (Section 3.4 of \cgalCite{vlo2012}). Call this function after `optimize_vertex_locations()`.
 *
 * Edges marked in `edge_is_constrained_map` are creases, at which each face takes the normals of its own side. Creases and
 * borders divide the faces around a vertex into sectors, each with its own normal. A map of the corners receives all these
 * normals and renders a crease sharp; a map of the vertices receives the normal of the sector with the largest area.
 *
 * A face with more than three corners represents the mean of its fan triangulations, as in `optimize_vertex_locations()`.
 *
 * The normals are always unit vectors. Where the faces have no area, or where the fit vanishes or turns away from the
 * reference, the normal is that of the reference near the vertex, or \f$ (0,0,1) \f$ if the reference has no normal there.
 *
 * The computations are done in double precision. The result does not depend on the number of threads.
 *
 * \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`,
 *                        `Parallel_tag`, and `Parallel_if_available_tag`.
 * \tparam PolygonMesh a model of `VertexListGraph`, `EdgeListGraph`, and `FaceListGraph`
 * \tparam Reference a model of `VertexListGraph`, `EdgeListGraph`, and `FaceListGraph`, of any type, or a model of
 *                   `ReferenceSurface`
 * \tparam NormalMap a class model of `WritablePropertyMap` with `%Vector_3` as value type, and as key type
 *                   `boost::graph_traits<PolygonMesh>::%vertex_descriptor`, or
 *                   `boost::graph_traits<PolygonMesh>::%halfedge_descriptor`
 * \tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
 * \tparam NamedParameters2 a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param pmesh the polygon mesh
 * \param reference the surface that gives the normals: a polygon mesh, which is taken as a `PN_triangle_surface`, or a
 *                  reference surface
 * \param normal_map receives the normals of the vertices, or those of the corners of the faces: the normal of a halfedge
 *                   is that of its face at its target. Border halfedges receive none.
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
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{a property map containing the crease-or-not status of each edge of `pmesh`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<PolygonMesh>::%edge_descriptor` as key type and `bool` as value type}
 *     \cgalParamDefault{a default property map where no edge is a crease}
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
 * If a precondition is violated and not checked, the map is untouched.
 *
 * \sa `CGAL::Polygon_mesh_processing::optimize_vertex_locations()`
 * \sa `CGAL::Polygon_mesh_processing::optimize_vertex_attributes()`
 * \sa `CGAL::Polygon_mesh_processing::normal_deviation()`
 * \sa `CGAL::Polygon_mesh_processing::compute_vertex_normals()`
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename PolygonMesh,
          typename Reference,
          typename NormalMap,
          typename NamedParameters1 = parameters::Default_named_parameters,
          typename NamedParameters2 = parameters::Default_named_parameters>
void optimize_vertex_normals(const PolygonMesh& pmesh,
                             const Reference& reference,
                             NormalMap normal_map,
                             const NamedParameters1& np1 = parameters::default_values(),
                             const NamedParameters2& np2 = parameters::default_values())
{
  using namespace internal::vertex_location;
  static_assert(check_arguments<PolygonMesh, Reference, NamedParameters1, NamedParameters2>, "The errors above say why.");
  using Normal = typename boost::property_traits<NormalMap>::value_type;

  Mesh_arrays mesh;
  Mesh_descriptors<PolygonMesh> descriptors;
  if(!read_mesh(pmesh, read_vertex_point_map(pmesh, np1), mesh, descriptors))
    return;
  const std::vector<char> is_crease = find_constrained_edges(mesh, descriptors, np1);

  with_reference<ConcurrencyTag>(mesh, reference, np2, false, [&](const auto& surface) {
    const Normal_signal<std::decay_t<decltype(surface)>> signal(mesh, surface, is_crease);
    const auto samples = sample_signal<ConcurrencyTag>(mesh, signal, is_crease);
    Signal_fit<Signal_value<3>> fit(mesh, samples);
    fit.template solve<ConcurrencyTag>(false);

    const Corner_nodes& nodes = fit.nodes();
    const std::vector<Index> node_of_vertex = choose_vertex_nodes(mesh, nodes);
    const auto normal_at = [&](Index node) {
      return unit_normal_or(to_vector(fit.values()[node]), to_vector(fit.sample(node)));
    };
    write_values(
      pmesh, mesh, descriptors, normal_map, [&](std::size_t c) { return convert<Normal>(normal_at(nodes.of_corner(c))); },
      [&](std::size_t i) {
        const Vector sample = to_vector(samples.at_vertices[i]);
        return convert<Normal>(node_of_vertex[i] == no_index ? unit_normal_or(sample, sample)
                                                             : normal_at(node_of_vertex[i]));
      });
    return true;
  });
}

} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_POLYGON_MESH_PROCESSING_OPTIMIZE_VERTEX_NORMALS_H
