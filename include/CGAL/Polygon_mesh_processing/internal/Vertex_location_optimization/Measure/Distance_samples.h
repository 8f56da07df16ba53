// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_DISTANCE_SAMPLES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_DISTANCE_SAMPLES_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Mesh_arrays.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The quadrature that the distances over a face are integrated with, from its vertices, the midpoints of its edges, and its
// barycenter; exact for cubics. What a sample, or the sum of those of its kind, adds to the mean:
struct Cubic_quadrature
{
  static double of_vertex(double x) { return x / 20; }
  static double of_midpoint(double x) { return x * 2 / 15; }
  static double of_barycenter(double x) { return x * 9 / 20; }
};

// The distances of a mesh to the reference at the points of the quadrature.
struct Distance_samples
{
  explicit Distance_samples(const Mesh_arrays& mesh)
    : at_vertices(mesh.points.size()), at_midpoints(mesh.edges.size()), at_barycenters(mesh.number_of_faces())
  {}

  double mean(const Mesh_arrays& mesh, std::size_t f) const
  {
    double of_vertices = 0, of_midpoints = 0;
    for(int k = 0; k < 3; ++k)
    {
      of_vertices += at_vertices[mesh.face(f)[k]];
      of_midpoints += at_midpoints[mesh.face_edges[f][k]];
    }
    return Cubic_quadrature::of_vertex(of_vertices) + Cubic_quadrature::of_midpoint(of_midpoints) +
           Cubic_quadrature::of_barycenter(at_barycenters[f]);
  }

  double maximum(const Mesh_arrays& mesh, std::size_t f) const
  {
    return (std::max)(at_barycenters[f], maximum_on_sides(mesh, f));
  }

  double maximum_on_sides(const Mesh_arrays& mesh, std::size_t f) const
  {
    double result = 0;
    for(Index i : mesh.face(f))
      result = (std::max)(result, at_vertices[i]);
    for(Index e : mesh.face_edges[f])
      result = (std::max)(result, at_midpoints[e]);
    return result;
  }

  std::vector<double> at_vertices;
  std::vector<double> at_midpoints;
  std::vector<double> at_barycenters;
};

// The mean distance over a mesh with its vertices at `points`, where the samples were taken.
template <typename ConcurrencyTag>
double mean_distance(const Mesh_arrays& mesh, const std::vector<Point>& points, const Distance_samples& distances)
{
  const std::size_t n = mesh.number_of_faces();
  const double area = sum_over_indices<ConcurrencyTag, double>(n, [&](std::size_t f) { return mesh.area(f, points); });
  const double integral = sum_over_indices<ConcurrencyTag, double>(
    n, [&](std::size_t f) { return mesh.area(f, points) * distances.mean(mesh, f); });
  return area > 0 ? integral / area : 0;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_DISTANCE_SAMPLES_H
