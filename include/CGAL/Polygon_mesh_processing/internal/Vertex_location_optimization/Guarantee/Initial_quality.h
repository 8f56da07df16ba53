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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_INITIAL_QUALITY_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_INITIAL_QUALITY_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Face_sampling.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/largest_distance.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/Face_orientation.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Placement/Placement.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>

#include <CGAL/Polygon_mesh_processing/Vertex_location_optimization_report.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The quality of M_0, with which the guarantee compares.
struct Initial_quality
{
  Approximation_error error; // of the distance to the reference; its maximum is more likely too small than too large
  std::vector<float> means;  // of that distance, on the faces
  std::vector<float> standard_errors; // of these means
  std::vector<Face_orientation> orientations;
  Face_sampling sampling; // what the means are found with
};

// Measures M_0 in the first iteration, when it has been sampled.
template <typename ConcurrencyTag, typename Reference>
Initial_quality measure_initial_quality(const Reference& reference,
                                        const Remesh& remesh,
                                        const Remesh_samples<Reference>& samples,
                                        Initial_measure measure)
{
  constexpr bool is_exact = true; // distances that a walk makes too large would permit a worse result
  Face_sampling sampling(remesh);
  const auto feet_of = [&](std::size_t f) {
    return feet_of_face<typename Reference::Foot>(remesh, f, samples.vertices, samples.midpoints);
  };
  const auto sampled_maximum = [&](std::size_t f) { return measure.distances.maximum(remesh, f); };
  std::vector<float> means(remesh.number_of_faces()), standard_errors(means.size());
  const auto integral = sum_over_indices<ConcurrencyTag, Error_integral>(remesh.number_of_faces(), [&](std::size_t f) {
    const Face_distances d =
      sampling.measure(reference, f, remesh.triangle(f), feet_of(f), measure.distances.on_sides(remesh, f), is_exact);
    double& largest_inside = measure.distances.largest_inside[f];
    largest_inside = (std::max)(largest_inside, d.max);
    means[f] = static_cast<float>(d.mean);
    standard_errors[f] = static_cast<float>(d.standard_error);
    const double area = remesh.area(f);
    return Error_integral{ area, area * d.mean, area * d.mean_square, sampled_maximum(f) };
  });

  Initial_quality quality{ integral.error(), std::move(means), std::move(standard_errors), std::move(measure.orientations),
                           std::move(sampling) };
  quality.error.max = largest_distance(remesh, sampled_maximum, [&](std::size_t f, double bound) {
    return largest_distance_on_face(reference, quality.sampling, f, remesh.triangle(f), feet_of(f), sampled_maximum(f),
                                    bound);
  });
  return quality;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_INITIAL_QUALITY_H
