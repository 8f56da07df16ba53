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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MEASURE_NORMALS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MEASURE_NORMALS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/Face_measure.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/sample_faces.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/corner_normals.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/with_reference_surface.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_mesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_parameters.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The angle between the normals of a mesh and those of the reference, over a part of the mesh.
struct Angle_integral
{
  double area = 0;
  double angle = 0; // its integral, in radians

  Angle_integral& operator+=(const Angle_integral& other)
  {
    area += other.area;
    angle += other.angle;
    return *this;
  }
};

// The number of samples of a face: a number for each face of the reference that it covers, as estimated at its corners. The
// number is limited, as the estimate is far too large where the corners lie in faces that are much smaller than the others.
template <typename Reference>
std::size_t number_of_normal_samples(const Reference& reference,
                                     const std::array<typename Reference::Foot, 3>& corner_feet,
                                     const double area)
{
  // found by trial: the mean is mostly within 0.2%; with half of `least` the error is twice as large
  constexpr double least = 25, per_patch = 2;
  constexpr double enough = 65536, most = 1e6; // the mean over a face is within 0.5%, a quarter of `enough` leaves 2%
  double patch_area = 0;
  for(const auto& foot : corner_feet)
    patch_area += reference.area_at(foot) / 3;
  if(!(patch_area > 0))
    return default_number_of_points_per_face;
  const double of_all_patches = (std::max)(enough, per_patch * static_cast<double>(reference.number_of_patches()));
  const double number = (std::min)({ per_patch * area / patch_area, of_all_patches, most });
  return static_cast<std::size_t>(number > least ? number : least);
}

// The mean angle in degrees between the normals that `corner_normals`, three a face, interpolate and those of the
// reference. A sample where one of the two has no direction does not count.
template <typename ConcurrencyTag, typename Reference>
double measure_corner_normals(const Mesh_arrays& mesh,
                              const std::vector<Vector>& corner_normals,
                              const Reference& reference,
                              const Sampling_density& density)
{
  const auto vertex_feet = project_vertices<ConcurrencyTag>(mesh.points, reference);
  const Angle_integral sum = sum_over_indices<ConcurrencyTag, Angle_integral>(mesh.number_of_faces(), [&](std::size_t f) {
    const Vector& n = corner_normals[3 * f];
    const Vector to_n1 = corner_normals[3 * f + 1] - n, to_n2 = corner_normals[3 * f + 2] - n;

    std::size_t count = 0;
    Angle_integral face;
    const std::array<Index, 3>& v = mesh.face(f);
    const std::array<Point, 3> triangle = mesh.triangle(f);
    const Distance_sampler<Reference> take_sample(reference, mesh.area_normal(f));
    Distance_sample<Reference> sample(triangle[0], reference, vertex_feet[v[0]]);
    const auto add_sample = [&](const Coordinates& x) {
      ++count;
      sample = take_sample(point_at(triangle, x), sample);
      const Vector here = normalized(n + x.u * to_n1 + x.v * to_n2);
      const Vector there = normalized(reference.normal(sample.foot));
      if(here == NULL_VECTOR || there == NULL_VECTOR)
        return;
      face.angle += std::atan2(norm(cross_product(here, there)), here * there);
      face.area += 1;
    };
    if(density.is_given())
      for_each_sample(density.number_of_points(mesh.area(f)), add_sample);
    else
    {
      // not at centroids: where surfaces are parallel the angle has a kink, and the mean over centroids is 1 or 2% off
      const std::size_t number =
        number_of_normal_samples(reference, { vertex_feet[v[0]], vertex_feet[v[1]], vertex_feet[v[2]] }, mesh.area(f));
      for_each_stratified_sample(static_cast<std::size_t>(std::round(std::sqrt(static_cast<double>(number)))), f,
                                 add_sample);
    }

    const double area_of_sample = mesh.area(f) / static_cast<double>(count);
    return Angle_integral{ area_of_sample * face.area, area_of_sample * face.angle };
  });
  if(sum.area == 0)
    return 0;
  const double mean = sum.angle / sum.area * 180 / CGAL_PI;
  return std::isnan(mean) ? 180 : mean; // the areas overflow
}

template <typename ConcurrencyTag>
std::vector<Vector> face_normals_at_corners(const Mesh_arrays& mesh)
{
  const std::vector<Vector> face_normals = compute_polygon_normals<ConcurrencyTag>(mesh);
  std::vector<Vector> normals(3 * mesh.number_of_faces());
  for_each_index<ConcurrencyTag>(normals.size(), [&](std::size_t c) { normals[c] = face_normals[c / 3]; });
  return normals;
}

// The implementation of `normal_deviation()`, with the normals `make_corner_normals(mesh, descriptors)`.
template <typename ConcurrencyTag,
          typename TriangleMesh,
          typename Reference,
          typename NamedParameters1,
          typename NamedParameters2,
          typename MakeCornerNormals>
double measure_normals(const TriangleMesh& tmesh,
                       const Reference& reference,
                       const NamedParameters1& np1,
                       const NamedParameters2& np2,
                       const MakeCornerNormals& make_corner_normals)
{
  Mesh_arrays mesh;
  Mesh_descriptors<TriangleMesh> descriptors;
  if(!read_mesh(tmesh, read_vertex_point_map(tmesh, np1), mesh, descriptors))
    return 180;
  const std::vector<Vector> corner_normals = make_corner_normals(mesh, descriptors);
  const Sampling_density density = read_sampling_density(np1);
  return with_reference<ConcurrencyTag>(mesh, reference, np2, 180., [&](const auto& surface) {
    return measure_corner_normals<ConcurrencyTag>(mesh, corner_normals, surface, density);
  });
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MEASURE_NORMALS_H
