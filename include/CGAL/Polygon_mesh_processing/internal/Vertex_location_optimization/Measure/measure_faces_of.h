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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MEASURE_FACES_OF_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MEASURE_FACES_OF_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/measure_error.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/with_reference_surface.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Face_selection.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/named_parameters.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_mesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_parameters.h>
#include <CGAL/Polygon_mesh_processing/Vertex_location_optimization_report.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The implementation of `approximation_error()`, for the selected faces.
template <typename ConcurrencyTag,
          typename PolygonMesh,
          typename Selection,
          typename Reference,
          typename NamedParameters1,
          typename NamedParameters2>
Approximation_error measure_faces_of(const PolygonMesh& pmesh,
                                     const Selection& selection,
                                     const Reference& reference,
                                     const NamedParameters1& np1,
                                     const NamedParameters2& np2)
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  constexpr bool has_face_map = !is_default_parameter<NamedParameters1, internal_np::face_error_map_t>::value;
  constexpr bool has_vertex_map = !is_default_parameter<NamedParameters1, internal_np::vertex_error_map_t>::value;
  constexpr double infinity = std::numeric_limits<double>::infinity();

  Mesh_arrays mesh;
  Mesh_descriptors<PolygonMesh> descriptors;
  const Approximation_error failure{ infinity, infinity, infinity };
  if(!read_faces(pmesh, read_vertex_point_map(pmesh, np1), selection, mesh, descriptors))
    return failure;
  const Sampling_density density = read_sampling_density(np1);

  return with_reference<ConcurrencyTag>(mesh, reference, np2, failure, [&](const auto& surface) -> Approximation_error {
    const auto measure = measure_error<ConcurrencyTag>(mesh, mesh.points, surface, density);

    if constexpr(has_face_map || has_vertex_map)
    {
      const std::vector<Face_error> polygon_errors = errors_of_polygons(mesh, measure.faces);
      if constexpr(has_face_map)
      {
        const auto face_error_map = get_parameter(np1, internal_np::face_error_map);
        for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
          put(face_error_map, face(descriptors.halfedges[f], pmesh), polygon_errors[mesh.polygon(f)].mean);
      }
      if constexpr(has_vertex_map)
      {
        const auto vertex_error_map = get_parameter(np1, internal_np::vertex_error_map);
        const auto means = mean_around_vertices<ConcurrencyTag>(mesh, surface, measure.vertex_feet, polygon_errors);
        for(std::size_t i = 0; i < means.size(); ++i)
          put(vertex_error_map, descriptors.vertices[i], means[i]);
      }
    }

    return measure.template error<ConcurrencyTag>();
  });
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MEASURE_FACES_OF_H
