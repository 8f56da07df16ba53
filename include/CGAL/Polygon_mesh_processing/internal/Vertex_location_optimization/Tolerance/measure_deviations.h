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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MEASURE_DEVIATIONS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MEASURE_DEVIATIONS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/approximation_error.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/measure_error.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Flat_triangle.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Patch_tree.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Sampling/Area_samples.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Mesh_arrays.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Points of the reference, and how many of the first ones count for the maximum only.
struct Reference_samples
{
  std::vector<Point> points;
  std::size_t number_of_extremes;
};

// The vertices of a mesh, and points of its edges that are at most so far apart: where its distance has ridges.
inline std::vector<Point> sample_edges(const Mesh_arrays& mesh, double spacing)
{
  constexpr double most_per_edge = 1e4;
  std::vector<Point> samples = mesh.points;
  for(Index e = 0; e < mesh.edges.size(); ++e)
  {
    const Point& p = mesh.points[mesh.edges[e][0]];
    const Vector v = mesh.points[mesh.edges[e][1]] - p;
    const double pieces = (std::min)(1 + std::ceil(norm(v) / spacing), most_per_edge);
    for(int i = 1; i < pieces; ++i)
      samples.push_back(p + (i / pieces) * v);
  }
  return samples;
}

// Adds points that are spread evenly over a surface, each of which stands for `area_of_sample`.
template <typename Patches>
void sample_area(const Patches& patches, double area_of_sample, std::vector<Point>& samples)
{
  const auto number = static_cast<std::size_t>(std::ceil(patches.area() / area_of_sample));
  // one hint will do: the density is the same everywhere
  patches.for_each_area_sample(
    number, 1, [&](std::size_t) { return patches.project(samples.front()); }, [](std::size_t) { return 1.; },
    [&](const auto& foot, double) { samples.push_back(patches.point(foot)); });
}

// The vertices and edges of the input and points spread evenly over it, each of which stands for `area_of_sample`, on the
// reference that it was made into; on the reference itself if that can be sampled.
template <typename ConcurrencyTag, typename Reference, typename InputPatches>
Reference_samples sample_reference(const Reference& reference,
                                   const Mesh_arrays& input,
                                   const InputPatches& input_patches,
                                   double area_of_sample)
{
  std::vector<Point> samples = sample_edges(input, std::sqrt(area_of_sample));
  const std::size_t number_of_extremes = samples.size();
  const bool is_sampled = reference.area() > 0;
  if(is_sampled)
    sample_area(reference, area_of_sample, samples);
  else
    sample_area(input_patches, area_of_sample, samples);
  for_each_index<ConcurrencyTag>(is_sampled ? number_of_extremes : samples.size(),
                                 [&](std::size_t i) { samples[i] = reference.point(reference.project(samples[i])); });
  return { std::move(samples), number_of_extremes };
}

// The face that a sample is closest to, and its distance.
using Face_and_distance = std::pair<Index, double>;

template <typename ConcurrencyTag>
std::vector<Face_and_distance> measure_distances(const std::vector<Point>& samples, const Mesh_arrays& mesh)
{
  const Patch_tree<Flat_triangle> tree = make_face_tree(mesh);
  std::vector<Face_and_distance> distances(samples.size());
  project_to_faces<ConcurrencyTag>(
    tree, samples.size(), [&](std::size_t i) -> const Point& { return samples[i]; },
    [&](std::size_t i, const Patch_foot& foot) {
      distances[i] = { foot.patch, norm(samples[i] - tree.point(foot)) };
    });
  return distances;
}

// For each face the largest distance from it to the reference, and from the samples of the reference that it is closest to.
template <typename ConcurrencyTag, typename Reference>
std::vector<double>
measure_deviations(const Mesh_arrays& mesh, const Reference& reference, const std::vector<Point>& samples)
{
  constexpr Sampling_density density{ 36, 0 };
  std::vector<double> deviations;
  deviations.reserve(mesh.number_of_faces());
  for(const Face_measurement& face : measure_error<ConcurrencyTag>(mesh, mesh.points, reference, density).faces)
    deviations.push_back(face.max);
  for(const auto& [face, distance] : measure_distances<ConcurrencyTag>(samples, mesh))
    deviations[face] = (std::max)(deviations[face], distance);
  return deviations;
}

// the distance of the samples to a mesh
template <typename ConcurrencyTag>
Approximation_error measure_samples(const Reference_samples& samples, const Mesh_arrays& mesh)
{
  Error_integral integral;
  std::size_t i = 0;
  for(const auto& [face, distance] : measure_distances<ConcurrencyTag>(samples.points, mesh))
  {
    const double weight = i++ < samples.number_of_extremes ? 0 : 1;
    integral += Error_integral{ weight, weight * distance, weight * distance * distance, distance };
  }
  return integral.error();
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MEASURE_DEVIATIONS_H
