// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_FACES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_FACES_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Reference_access.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Mesh_arrays.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/triangle_coordinates.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// How many samples a face gets unless the user says otherwise: the mean of a mesh that interpolates the reference is
// within 1% of its limit from 25 on, that of an optimized mesh, whose error has a kink where the two surfaces cross,
// within 2% from 64 on.
constexpr std::size_t default_number_of_points_per_face = 64;

// The points of the reference that the vertices of `mesh` are closest to.
template <typename ConcurrencyTag, typename Reference>
std::vector<typename Reference::Foot> project_vertices(const Mesh_arrays& mesh, const Reference& reference)
{
  std::vector<typename Reference::Foot> feet(mesh.points.size());
  for_each_index<ConcurrencyTag>(feet.size(), [&](std::size_t i) { feet[i] = reference.project(mesh.points[i]); });
  return feet;
}

// Projects samples of a triangle, each of which stands for the same area: the centroids of the s * s triangles that its
// sides, cut into s pieces, make, where s is the smallest number for which they are at least `number_of_points`. Calls
// f(x, p, foot) for the sample p with the coordinates x. The search starts at the foot `hint`.
template <typename Reference, typename F>
void project_samples(const std::array<Point, 3>& triangle,
                     const Reference& reference,
                     const std::size_t number_of_points,
                     typename Reference::Foot hint,
                     const F& f)
{
  const double root = std::sqrt(static_cast<double>(number_of_points));
  const std::size_t s = (std::max)(std::size_t(1), static_cast<std::size_t>(std::ceil(root)));
  auto project_sample = [&](const Coordinates& x) {
    const Point p = point_at(triangle, x);
    hint = reference.project(p, hint);
    f(x, p, hint);
  };

  for(std::size_t i = 0; i < s; ++i)
    for(std::size_t j = 0; j < s - i; ++j)
    {
      project_sample({ (i + 1 / 3.) / s, (j + 1 / 3.) / s });
      if(i + j + 1 < s)
        project_sample({ (i + 2 / 3.) / s, (j + 2 / 3.) / s });
    }
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_FACES_H
