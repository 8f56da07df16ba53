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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MEASURE_ATTRIBUTE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MEASURE_ATTRIBUTE_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/Map_signal.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/face_lattice.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/measure_error.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Polygon_centers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The difference between the values at the corners of the faces of a mesh, interpolated over them, and a signal: what
// `attribute_error()` measures. A face takes its samples on one side of the seams of the signal.
template <typename ConcurrencyTag, typename Signal>
Error_integral measure_attribute(const Mesh_arrays& mesh,
                                 const std::vector<typename Signal::Value>& corner_values,
                                 const Signal& signal,
                                 const std::size_t number_of_points)
{
  const auto& reference = signal.reference();
  const auto vertex_feet = project_vertices<ConcurrencyTag>(mesh.points, reference);
  const std::size_t pieces = number_of_pieces(static_cast<double>(number_of_points));
  const Polygon_centers center(mesh);
  std::vector<Face_error> faces(mesh.number_of_faces());
  for_each_index<ConcurrencyTag>(faces.size(), [&](std::size_t f) {
    const std::array<Point, 3> t = mesh.triangle(f);
    const auto anchor = reference.project(center(f), vertex_feet[mesh.first_vertex(f)]);
    auto sampler = signal.make_face_sampler(f, anchor, 0); // closest points, all of them
    const auto difference = [&](const Coordinates& x) {
      const auto there = signal.sample(sampler, point_at(t, x));
      return norm(interpolate(corner_values[3 * f], corner_values[3 * f + 1], corner_values[3 * f + 2], x.u, x.v) - there);
    };

    double sum = 0, sum_of_squares = 0, max = 0;
    for_each_lattice_point(pieces, [&](const Coordinates& x) {
      const double d = difference(x);
      sum += d;
      sum_of_squares += d * d;
      max = (std::max)(max, d);
    });
    for(const Coordinates& corner : { Coordinates{ 0, 0 }, Coordinates{ 1, 0 }, Coordinates{ 0, 1 } })
      max = (std::max)(max, difference(corner));
    const double count = static_cast<double>(number_of_lattice_points(pieces));
    faces[f] = { mesh.area(f), sum / count, sum_of_squares / count, max };
  });
  return integral_over_faces<ConcurrencyTag>(faces);
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MEASURE_ATTRIBUTE_H
