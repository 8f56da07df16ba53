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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MEASURE_REGULARITY_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MEASURE_REGULARITY_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// in degrees
inline double smallest_angle(const std::array<Point, 3>& t)
{
  const double a = squared_distance(t[0], t[1]), b = squared_distance(t[1], t[2]), c = squared_distance(t[2], t[0]);
  const double product = (std::max)({ a * b, b * c, c * a }); // of the sides that it is between, squared
  const double sine = product > 0 ? norm(area_normal(t[0], t[1], t[2])) / std::sqrt(product) : 0;
  return std::asin((std::min)(1., sine)) * 180 / CGAL_PI;
}

// of the faces with the vertices at `points`
inline double mean_smallest_angle(const Remesh& remesh, const std::vector<Point>& points)
{
  double sum = 0;
  for(std::size_t f = 0; f < remesh.number_of_faces(); ++f)
    sum += smallest_angle(remesh.triangle(f, points));
  return sum / static_cast<double>((std::max)(remesh.number_of_faces(), std::size_t(1)));
}

// The means of values at the vertices over their neighborhoods.
inline std::vector<double> averaged_over_neighbors(const Remesh& remesh, const std::vector<double>& values)
{
  std::vector<double> means(values.size());
  for(std::size_t i = 0; i < means.size(); ++i)
  {
    double sum = values[i], number = 1;
    remesh.for_each_corner(i, [&](Index c) {
      sum += (values[remesh.vertex(Mesh_arrays::next(c))] + values[remesh.vertex(Mesh_arrays::previous(c))]) / 2;
      ++number;
    });
    means[i] = sum / number;
  }
  return means;
}

// The regularity of the faces of M_0 around each vertex, by the mean of the smallest angles: from 0, as in a simplified mesh
// whose faces follow the curvature, to 1, as after isotropic remeshing.
inline std::vector<double> measure_regularity(const Remesh& remesh)
{
  // in degrees: after simplification the mean is 27 to 41, after isotropic remeshing 50 to 54, and after an optimization of
  // that 47 to 54: it should still count as regular, or a second call would weigh regularity less
  constexpr double irregular = 36, regular = 46;
  constexpr int number_of_averages = 2; // a few bad faces do not make a mesh irregular
  std::vector<double> angles(remesh.points.size(), 0);
  for(std::size_t i = 0; i < angles.size(); ++i)
  {
    double sum = 0, number = 0;
    remesh.for_each_corner(i, [&](Index c) {
      sum += smallest_angle(remesh.triangle(c / 3, remesh.initial_points));
      ++number;
    });
    angles[i] = number > 0 ? sum / number : regular;
  }
  for(int k = 0; k < number_of_averages; ++k)
    angles = averaged_over_neighbors(remesh, angles);
  for(double& angle : angles)
    angle = std::clamp((angle - irregular) / (regular - irregular), 0., 1.);
  return angles;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MEASURE_REGULARITY_H
