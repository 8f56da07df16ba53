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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MEASURE_ERROR_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MEASURE_ERROR_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/Adaptive_sampling.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/Maximum_search.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/sample_faces.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The distance of a mesh with its vertices at some points to the reference.
template <typename Reference>
class Error_measure
{
  using Foot = typename Reference::Foot;
  using Sample = Distance_sample<Reference>;

public:
  Error_measure(const Mesh_arrays& mesh, const std::vector<Point>& points, const Reference& reference)
    : m_mesh(mesh), m_points(points), m_reference(reference)
  {}

  // Samples as densely as the user says, or else as finely as it takes.
  template <typename ConcurrencyTag>
  void measure(const Sampling_density& density)
  {
    vertex_feet = project_vertices<ConcurrencyTag>(m_points, m_reference);
    faces.resize(m_mesh.number_of_faces());
    if(density.is_given())
      sample_evenly<ConcurrencyTag>(density);
    else
      sample_adaptively<ConcurrencyTag>();
    search_maximum<ConcurrencyTag>();
    for(Face_measurement& face : faces)
      face.mean = mean_of(face.mean, 1); // never not a number
  }

  template <typename ConcurrencyTag>
  Approximation_error error() const
  {
    return integral_over_faces<ConcurrencyTag>(faces).error();
  }

  std::vector<Foot> vertex_feet;
  std::vector<Face_measurement> faces;

private:
  template <typename ConcurrencyTag>
  void sample_adaptively()
  {
    const auto measure_face = [&](const std::size_t f, const Fineness& fineness) {
      const Distance_sampler<Reference> sampler(m_reference, m_mesh.area_normal(f, m_points));
      Face_measurement face = Face_measure<Reference>(sampler, fineness, f)(samples_at_corners(f));
      face.area = m_mesh.area(f, m_points);
      return face;
    };
    Adaptive_sampling<ConcurrencyTag, decltype(measure_face)>(measure_face, faces).run();
  }

  template <typename ConcurrencyTag>
  void sample_evenly(const Sampling_density& density)
  {
    for_each_index<ConcurrencyTag>(faces.size(), [&](std::size_t f) {
      Face_measurement face;
      face.area = m_mesh.area(f, m_points);
      const std::array<Sample, 3> corners = samples_at_corners(f);
      for(const Sample& corner : corners)
        face.max = (std::max)(face.max, corner.distance);
      double sum = 0, sum_of_squares = 0;
      std::size_t count = 0;
      const auto triangle = m_mesh.triangle(f, m_points);
      Foot foot = vertex_feet[m_mesh.first_vertex(f)];
      for_each_sample(density.number_of_points(face.area), [&](const Coordinates& x) {
        const Point p = point_at(triangle, x);
        foot = m_reference.project(p, foot);
        const double distance = distance_to_foot(p, m_reference, foot);
        sum += distance;
        sum_of_squares += distance * distance;
        face.max = (std::max)(face.max, distance);
        ++count;
      });
      face.mean = sum / count;
      face.mean_square = sum_of_squares / count;
      face.sampled_maximum = face.max;
      face.probable_maximum = face.max + std::sqrt(squared_longest_side(triangle) / count);
      face.number_of_pieces = count / 4;
      faces[f] = face;
    });
  }

  template <typename ConcurrencyTag>
  void search_maximum()
  {
    const auto corners_of = [&](std::size_t f) { return samples_at_corners(f); };
    const auto normal_of = [&](std::size_t f) { return normalized(m_mesh.area_normal(f, m_points)); };
    Maximum_search<ConcurrencyTag, Reference, decltype(corners_of), decltype(normal_of)>(m_reference, corners_of, normal_of,
                                                                                         faces)
      .run();
  }

  std::array<Sample, 3> samples_at_corners(std::size_t f) const
  {
    const auto sample = [&](Index i) { return Sample(m_points[i], m_reference, vertex_feet[i]); };
    const std::array<Index, 3>& v = m_mesh.face(f);
    return { sample(v[0]), sample(v[1]), sample(v[2]) };
  }

  const Mesh_arrays& m_mesh;
  const std::vector<Point>& m_points;
  const Reference& m_reference;
};

// Measures how far `mesh`, with its vertices at `points`, is from the reference.
template <typename ConcurrencyTag, typename Reference>
Error_measure<Reference> measure_error(const Mesh_arrays& mesh,
                                       const std::vector<Point>& points,
                                       const Reference& reference,
                                       const Sampling_density& density = Sampling_density())
{
  Error_measure<Reference> measure(mesh, points, reference);
  measure.template measure<ConcurrencyTag>(density);
  return measure;
}

// the distance of each polygon to the reference
inline std::vector<Face_error> errors_of_polygons(const Mesh_arrays& mesh, const std::vector<Face_measurement>& faces)
{
  if(!mesh.has_polygons())
    return { faces.begin(), faces.end() };
  std::vector<Error_integral> integrals(mesh.number_of_polygons());
  for(std::size_t f = 0; f < faces.size(); ++f)
    integrals[mesh.polygon(f)] += integral_over(faces[f]);
  std::vector<Face_error> errors;
  errors.reserve(integrals.size());
  for(const Error_integral& integral : integrals)
    errors.push_back({ integral.area, integral.mean(), integral.mean_square(), integral.max });
  return errors;
}

// The mean distance over the polygons around each vertex; the distance of the vertex itself if they have no area.
template <typename ConcurrencyTag, typename Reference>
std::vector<double> mean_around_vertices(const Mesh_arrays& mesh,
                                         const Reference& reference,
                                         const std::vector<typename Reference::Foot>& vertex_feet,
                                         const std::vector<Face_error>& polygons)
{
  std::vector<Error_integral> integrals(mesh.points.size());
  for(Index c = 0; c < 3 * mesh.number_of_faces(); ++c)
    if(mesh.ear(c) == c)
      integrals[mesh.vertex(c)] += integral_over(polygons[mesh.polygon(c / 3)]);

  std::vector<double> means(mesh.points.size());
  for_each_index<ConcurrencyTag>(means.size(), [&](std::size_t i) {
    means[i] = integrals[i].area > 0 ? integrals[i].mean() : distance_to_foot(mesh.points[i], reference, vertex_feet[i]);
  });
  return means;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MEASURE_ERROR_H
