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

#ifndef CGAL_POLYGON_MESH_PROCESSING_OPTIMIZE_GEOMETRY_IMAGE_H
#define CGAL_POLYGON_MESH_PROCESSING_OPTIMIZE_GEOMETRY_IMAGE_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Geometry_image.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>

#include <CGAL/assertions.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/tags.h>

#include <cstddef>

namespace CGAL {
namespace Polygon_mesh_processing {

/*!
 * \ingroup PkgVertexLocationOptimizationRef
 *
 * \brief moves the samples of a geometry image off the surface that it was sampled from, so that its triangles
 *        approximate that surface as well as they can.
 *
 * A down-sampled image is a remesh of the full one, with a regular connectivity. It is optimized as by
 * `optimize_vertex_locations()`, with the same guarantees, but without springs, as the triangles of an image are irregular
 * on purpose. The triangles are those that `geometry_image_to_polygon_mesh()` makes of the initial image. Samples that
 * represent the same vertex remain identical to the last bit, so that the image stays watertight; the border of an open
 * image does not move. As the shorter diagonals of the result may differ from the initial ones, use
 * `geometry_image_to_polygon_mesh(image, tmesh, diagonals)` to get the same triangles. See Section 3.5 of
 * \cgalCite{vlo2012}.
 *
 * The result does not depend on the number of threads.
 *
 * \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`,
 *                        `Parallel_tag`, and `Parallel_if_available_tag`.
 * \tparam Point_3 `%Point_3` of a model of `Kernel`
 * \tparam Reference a model of `VertexListGraph`, `EdgeListGraph`, and `FaceListGraph`, or a model of `ReferenceSurface`
 * \tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
 * \tparam NamedParameters2 a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param image the image, whose samples are moved
 * \param reference the surface that the image approximates: a polygon mesh, which is taken as a `PN_triangle_surface`,
 *                  or a reference surface, such as the `Flat_triangle_surface` of the triangulated full image
 * \param np1 an optional sequence of \ref bgl_namedparameters "Named Parameters": those of `optimize_vertex_locations()`
 *            that do not refer to the vertices and edges of a mesh, with the same defaults: `number_of_iterations`,
 *            `number_of_free_iterations`, `convergence_threshold`, `placement_method`, `regularity_weight`,
 *            `relax_constraints` (for the border of an open image), `do_self_intersection_tests`, and `visitor`
 *
 * \param np2 an optional sequence of \ref bgl_namedparameters "Named Parameters": those of the constructor of
 *            `PN_triangle_surface` if `reference` is a mesh; none if it is a reference surface
 *
 * \pre all coordinates are finite; and those of `optimize_vertex_locations()`
 *
 * \return what was done. If a precondition is violated and not checked, the image is untouched and the report says that
 *         there was no iteration.
 *
 * \sa `CGAL::Geometry_image`
 * \sa `CGAL::Polygon_mesh_processing::optimize_vertex_locations()`
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename Point_3,
          typename Reference,
          typename NamedParameters1 = parameters::Default_named_parameters,
          typename NamedParameters2 = parameters::Default_named_parameters>
Vertex_location_optimization_report optimize_geometry_image(Geometry_image<Point_3>& image,
                                                            const Reference& reference,
                                                            const NamedParameters1& np1 = parameters::default_values(),
                                                            const NamedParameters2& np2 = parameters::default_values())
{
  using namespace CGAL::internal::geometry_image;
  using Mesh = Surface_mesh<Point_3>;
  using Vertex_index = typename Mesh::Vertex_index;

  const bool is_valid = has_finite_samples(image);
  CGAL_precondition_msg(is_valid, "A coordinate of the image is not finite.");
  if(!is_valid)
    return {};

  const Triangulated_samples samples = triangulate_samples(image);
  Mesh mesh;
  add_to_mesh(samples, image, mesh, parameters::default_values());

  // copies of a vertex must not part from it
  auto is_fixed = mesh.template add_property_map<Vertex_index, bool>("v:is_fixed", false).first;
  const std::size_t number_of_vertices = samples.sample_of_vertex.size();
  for(std::size_t v = number_of_vertices - samples.number_of_copies; v < number_of_vertices; ++v)
    for(std::size_t copy : { v, samples.vertex_of_sample[samples.sample_of_vertex[v]] })
      is_fixed[Vertex_index(static_cast<typename Mesh::size_type>(copy))] = true;

  const auto report = optimize_vertex_locations<ConcurrencyTag>(
    mesh, reference, np1.number_of_relaxation_steps(0).vertex_is_constrained_map(is_fixed), np2);

  if(report.iterations > 0)
    for(std::size_t s = 0; s < samples.vertex_of_sample.size(); ++s)
      if(samples.vertex_of_sample[s] != no_vertex)
        image(s / image.width(), s % image.width()) =
          mesh.point(Vertex_index(static_cast<typename Mesh::size_type>(samples.vertex_of_sample[s])));
  return report;
}

} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_POLYGON_MESH_PROCESSING_OPTIMIZE_GEOMETRY_IMAGE_H
