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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_FACES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_FACES_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Reference_access.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Mesh_arrays.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/triangle_coordinates.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// how many samples a face gets where nothing else is said
constexpr std::size_t default_number_of_points_per_face = 64;

// How densely the user wants faces to be sampled.
struct Sampling_density
{
  bool is_given() const { return number_of_points_per_face > 0 || number_of_points_per_area_unit > 0; }

  // the larger number of the two parameters
  std::size_t number_of_points(const double area) const
  {
    constexpr double most = 1e9; // what overflows is not sampled any denser
    const double number = std::ceil(number_of_points_per_area_unit * area);
    return (std::max)({ std::size_t(1), number_of_points_per_face, number < most ? static_cast<std::size_t>(number) : 0 });
  }

  std::size_t number_of_points_per_face = 0;
  double number_of_points_per_area_unit = 0;
};

// the density given by the named parameters
template <typename NamedParameters>
Sampling_density read_sampling_density(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  Sampling_density density;
  if constexpr(!is_default_parameter<NamedParameters, internal_np::number_of_points_per_face_t>::value)
    density.number_of_points_per_face =
      (std::max)(std::size_t(1), static_cast<std::size_t>(get_parameter(np, internal_np::number_of_points_per_face)));
  density.number_of_points_per_area_unit =
    to_double(choose_parameter(get_parameter(np, internal_np::nb_points_per_area_unit), 0.));
  return density;
}

// The points of the reference closest to `points`, of which consecutive ones are near each other.
template <typename ConcurrencyTag, typename Reference>
std::vector<typename Reference::Foot> project_vertices(const std::vector<Point>& points, const Reference& reference)
{
  constexpr std::size_t block_size = 64;
  std::vector<typename Reference::Foot> feet(points.size());
  for_each_block<ConcurrencyTag>(feet.size(), block_size, [&](std::size_t begin, std::size_t end) {
    for(std::size_t i = begin; i < end; ++i)
      feet[i] = i == begin ? reference.project(points[i]) : reference.project(points[i], feet[i - 1]);
  });
  return feet;
}

// Samples of a triangle, each of which stands for the same area: the centroids of the s * s triangles that its sides, cut
// into s pieces, make, where s is the smallest number for which they are at least `number_of_points`. Calls f(x) with the
// coordinates of each; those that follow each other are neighbors.
template <typename F>
void for_each_sample(const std::size_t number_of_points, const F& f)
{
  const double root = std::sqrt(static_cast<double>(number_of_points));
  const std::size_t s = (std::max)(std::size_t(1), static_cast<std::size_t>(std::ceil(root)));
  for(std::size_t i = 0; i < s; ++i)
    for(std::size_t j = 0; j < s - i; ++j)
    {
      f(Coordinates{ (i + 1 / 3.) / s, (j + 1 / 3.) / s });
      if(i + j + 1 < s)
        f(Coordinates{ (i + 2 / 3.) / s, (j + 2 / 3.) / s });
    }
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_FACES_H
