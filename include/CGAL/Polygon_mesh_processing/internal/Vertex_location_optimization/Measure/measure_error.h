// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MEASURE_ERROR_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MEASURE_ERROR_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/sample_faces.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// A sum over a weight: 0 where there is no weight, infinite rather than not a number where the numbers overflow.
inline double mean_of(double sum, double weight)
{
  const double mean = weight == 0 ? 0 : sum / weight;
  return std::isnan(mean) ? std::numeric_limits<double>::infinity() : mean;
}

// the distance of a face to the reference
struct Face_error
{
  double area = 0;
  double mean = 0;
  double mean_square = 0;
  double max = 0;
};

// the distance of some faces to the reference
struct Error_sum
{
  double area = 0;
  double distance = 0;         // its integral
  double squared_distance = 0; // the integral of its square
  double max = 0;

  Error_sum() = default;
  Error_sum(const Face_error& face)
    : area(face.area), distance(face.area * face.mean), squared_distance(face.area * face.mean_square), max(face.max)
  {}

  Error_sum& operator+=(const Error_sum& other)
  {
    area += other.area;
    distance += other.distance;
    squared_distance += other.squared_distance;
    max = (std::max)(max, other.max);
    return *this;
  }

  double mean() const { return mean_of(distance, area); }
  double rms() const { return std::sqrt(mean_of(squared_distance, area)); }
};

template <typename ConcurrencyTag, typename Reference>
std::vector<Face_error> measure_faces(const Mesh_arrays& mesh,
                                      const Reference& reference,
                                      const std::vector<typename Reference::Foot>& vertex_feet,
                                      const std::size_t number_of_points)
{
  std::vector<Face_error> faces(mesh.number_of_faces());
  for_each_index<ConcurrencyTag>(faces.size(), [&](std::size_t f) {
    std::size_t count = 0;
    double sum = 0, sum_of_squares = 0, max = 0;
    const auto& hint = vertex_feet[mesh.first_vertex(f)];
    project_samples(mesh.triangle(f), reference, number_of_points, hint, [&](const auto&, const Point& p, const auto& foot) {
      const double distance = distance_to_foot(p, reference, foot);
      sum += distance;
      sum_of_squares += distance * distance;
      max = (std::max)(max, distance);
      ++count;
    });
    for(Index i : mesh.face(f))
      max = (std::max)(max, distance_to_foot(mesh.points[i], reference, vertex_feet[i]));

    faces[f] = { mesh.area(f), mean_of(sum, count), mean_of(sum_of_squares, count), max };
  });
  return faces;
}

// the distance of each polygon to the reference
inline std::vector<Face_error> errors_of_polygons(const Mesh_arrays& mesh, const std::vector<Face_error>& faces)
{
  if(!mesh.has_polygons())
    return faces;
  std::vector<Error_sum> sums(mesh.number_of_polygons());
  for(std::size_t f = 0; f < faces.size(); ++f)
    sums[mesh.polygon(f)] += faces[f];
  std::vector<Face_error> errors;
  errors.reserve(sums.size());
  for(const Error_sum& sum : sums)
    errors.push_back({ sum.area, sum.mean(), mean_of(sum.squared_distance, sum.area), sum.max });
  return errors;
}

// The mean distance over the polygons around each vertex; the distance of the vertex itself if they have no area.
template <typename ConcurrencyTag, typename Reference>
std::vector<double> mean_around_vertices(const Mesh_arrays& mesh,
                                         const Reference& reference,
                                         const std::vector<typename Reference::Foot>& vertex_feet,
                                         const std::vector<Face_error>& polygons)
{
  std::vector<Error_sum> sums(mesh.points.size());
  for(Index c = 0; c < 3 * mesh.number_of_faces(); ++c)
    if(mesh.ear(c) == c)
      sums[mesh.vertex(c)] += polygons[mesh.polygon(c / 3)];

  std::vector<double> means(mesh.points.size());
  for_each_index<ConcurrencyTag>(means.size(), [&](std::size_t i) {
    means[i] = sums[i].area > 0 ? sums[i].mean() : distance_to_foot(mesh.points[i], reference, vertex_feet[i]);
  });
  return means;
}

// the distance over the whole mesh
template <typename ConcurrencyTag>
Error_sum sum_of_faces(const std::vector<Face_error>& faces)
{
  return sum_over_indices<ConcurrencyTag, Error_sum>(faces.size(), [&](std::size_t f) { return Error_sum(faces[f]); });
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MEASURE_ERROR_H
