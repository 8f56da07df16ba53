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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_COMPUTE_EDGE_LENGTHS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_COMPUTE_EDGE_LENGTHS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Sizing/face_curvatures.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Mesh_arrays.h>
#include <CGAL/Polygon_mesh_processing/Tolerance_report.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The best edge length is proportional to this power of the curvature.
inline double edge_length_exponent(Tolerated_error kind)
{
  return kind == MAXIMUM_ERROR ? -1. / 2 : kind == MEAN_ERROR ? -1. / 4 : -1. / 3;
}

// The mean error of the best equilateral triangles, relative to that where both curvatures are the larger one: a function
// of their ratio from -1 to 1, in steps of a quarter.
inline double relative_mean_error(double ratio)
{
  constexpr std::array<double, 9> table{ 1.502, 1.324, 1.174, 1.048, 0.956, 0.897, 0.879, 0.910, 1 };
  const double position = (std::clamp(ratio, -1., 1.) + 1) * 4;
  const std::size_t i = (std::min)(static_cast<std::size_t>(position), table.size() - 2);
  return table[i] + (position - i) * (table[i + 1] - table[i]);
}

// Averages a value of the faces at the vertices: the mean over the faces around each, and their area.
struct Vertex_means
{
  Vertex_means(const Mesh_arrays& mesh, const std::vector<double>& of_faces)
    : values(mesh.points.size()), areas(mesh.points.size())
  {
    for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      for(Index i : mesh.face(f))
      {
        areas[i] += mesh.area(f) / 3;
        values[i] += mesh.area(f) / 3 * of_faces[f];
      }
    for(std::size_t i = 0; i < values.size(); ++i)
      values[i] = areas[i] > 0 ? values[i] / areas[i] : 0;
  }

  std::vector<double> values;
  std::vector<double> areas;
};

// The larger curvature at the vertices; with `MEAN_ERROR`, times a factor that depends on the smaller one. It is smoothed
// over about the size of the triangles of a remesh with this number of vertices, as smaller details are noise to them.
template <typename ConcurrencyTag>
Vertex_means compute_vertex_curvatures(const Mesh_arrays& mesh,
                                       const std::vector<Vector>& face_normals,
                                       const std::vector<char>& is_crease,
                                       Tolerated_error kind,
                                       double number_of_vertices)
{
  // on a scan more gains nothing, and on a part less does
  constexpr double steps_per_area = 2.5;
  constexpr double largest_number_of_steps = 100;
  const int steps =
    static_cast<int>(std::clamp(steps_per_area * mesh.points.size() / number_of_vertices, 1., largest_number_of_steps));

  std::vector<double> of_faces;
  for(const Curvatures& c : compute_face_curvatures<ConcurrencyTag>(mesh, face_normals, is_crease))
    of_faces.push_back(std::abs(c.k1) * (kind == MEAN_ERROR && c.k1 != 0 ? relative_mean_error(c.k2 / c.k1) : 1));
  Vertex_means means(mesh, of_faces);
  for(int step = 0; step < steps; ++step)
  {
    for(std::size_t f = 0; f < of_faces.size(); ++f)
    {
      const auto& v = mesh.face(f);
      of_faces[f] = (means.values[v[0]] + means.values[v[1]] + means.values[v[2]]) / 3;
    }
    means = Vertex_means(mesh, of_faces);
  }
  return means;
}

// Shortens lengths until they grow by no more than the part `gradation` of an edge along it.
inline void limit_gradation(const Mesh_arrays& mesh,
                            const std::vector<std::vector<Index>>& edges_of_vertex,
                            double gradation,
                            std::vector<double>& lengths)
{
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for(Index i = 0; i < lengths.size(); ++i)
    queue.emplace(lengths[i], i);
  while(!queue.empty())
  {
    const auto [length, i] = queue.top();
    queue.pop();
    if(length > lengths[i])
      continue; // it was shortened since
    for(Index e : edges_of_vertex[i])
    {
      const Index j = mesh.edges[e][0] == i ? mesh.edges[e][1] : mesh.edges[e][0];
      const double limit = length + gradation * norm(mesh.points[j] - mesh.points[i]);
      if(limit < lengths[j])
      {
        lengths[j] = limit;
        queue.emplace(limit, j);
      }
    }
  }
}

// How many vertices `isotropic_remeshing()` makes of an area with this edge length, about: somewhat more than equilateral
// triangles would have.
inline double estimate_number_of_vertices(double area, double length)
{
  constexpr double irregularity = 1.15;
  return irregularity * area / (std::sqrt(3.) / 2 * length * length);
}

// The gradient of a function that is linear on a triangle, by its values at the corners.
inline double norm_of_gradient(const std::array<Point, 3>& triangle, const std::array<double, 3>& values)
{
  const Vector normal = area_normal(triangle[0], triangle[1], triangle[2]);
  Vector gradient = NULL_VECTOR;
  for(int k = 0; k < 3; ++k)
    gradient = gradient + values[k] * cross_product(normal, triangle[(k + 2) % 3] - triangle[(k + 1) % 3]);
  const double square = normal.squared_length();
  return square > 0 ? norm(gradient) / square : 0;
}

// The same with edge lengths at the vertices. Of the two at the ends of an edge the shorter one counts, which in the mean
// over all directions is shorter than the length in the middle by the edge times the gradient over pi.
inline double estimate_number_of_vertices(const Mesh_arrays& mesh, const std::vector<double>& lengths)
{
  double number = 0;
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
  {
    const auto& v = mesh.face(f);
    const std::array<double, 3> at_corners{ lengths[v[0]], lengths[v[1]], lengths[v[2]] };
    const double length = (at_corners[0] + at_corners[1] + at_corners[2]) / 3;
    const double gradient = (std::min)(norm_of_gradient(mesh.triangle(f), at_corners), 1.);
    number += estimate_number_of_vertices(mesh.area(f), length * (1 - gradient / CGAL_PI));
  }
  return number;
}

// The target edge lengths at the vertices of a mesh for about this number of vertices.
inline std::vector<double> compute_edge_lengths(
  const Mesh_arrays& mesh, const Vertex_means& curvatures, Tolerated_error kind, double number_of_vertices, double gradation)
{
  constexpr double least_curvature = 1e-3; // relative to the mean: planes have edges as long as the gradation allows
  constexpr int number_of_steps = 12;

  double area = 0, mean = 0;
  for(std::size_t i = 0; i < curvatures.areas.size(); ++i)
  {
    area += curvatures.areas[i];
    mean += curvatures.areas[i] * curvatures.values[i];
  }
  mean /= area;
  std::vector<std::vector<Index>> edges_of_vertex(mesh.points.size());
  for(Index e = 0; e < mesh.edges.size(); ++e)
    for(Index i : mesh.edges[e])
      edges_of_vertex[i].push_back(e);

  std::vector<double> lengths(mesh.points.size());
  double scale = std::sqrt(area / number_of_vertices);
  for(int step = 0; step < number_of_steps; ++step)
  {
    for(std::size_t i = 0; i < lengths.size(); ++i)
    {
      const double relative = mean > 0 ? (std::max)(curvatures.values[i] / mean, least_curvature) : 1;
      lengths[i] = scale * std::pow(relative, edge_length_exponent(kind));
    }
    limit_gradation(mesh, edges_of_vertex, gradation, lengths);
    scale *= std::sqrt(estimate_number_of_vertices(mesh, lengths) / number_of_vertices);
  }
  return lengths;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_COMPUTE_EDGE_LENGTHS_H
