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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_DISTANCE_SAMPLES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_DISTANCE_SAMPLES_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Mesh_arrays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
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

// The signed distances of a face to the reference at its corners and at the midpoints of the sides opposite to them.
struct Distances_on_sides
{
  // the least and the largest
  std::pair<double, double> range() const
  {
    return std::minmax({ at_corners[0], at_corners[1], at_corners[2], at_midpoints[0], at_midpoints[1], at_midpoints[2] });
  }

  double maximum() const // of the absolute values
  {
    const auto [least, largest] = range();
    return (std::max)(-least, largest);
  }

  Distances_on_sides without_signs() const
  {
    Distances_on_sides result;
    const auto absolute = [](double d) { return std::abs(d); };
    std::transform(at_corners.begin(), at_corners.end(), result.at_corners.begin(), absolute);
    std::transform(at_midpoints.begin(), at_midpoints.end(), result.at_midpoints.begin(), absolute);
    return result;
  }

  std::array<double, 3> at_corners{}, at_midpoints{};
};

// those of face f, from those at the vertices and at the midpoints of the edges
inline Distances_on_sides distances_on_sides(const Mesh_arrays& mesh,
                                             const std::size_t f,
                                             const std::vector<double>& at_vertices,
                                             const std::vector<double>& at_midpoints)
{
  Distances_on_sides result;
  for(int k = 0; k < 3; ++k)
  {
    result.at_corners[k] = at_vertices[mesh.face(f)[k]];
    result.at_midpoints[k] = at_midpoints[mesh.face_edges[f][k]];
  }
  return result;
}

// The distances of a mesh to the reference, signed at the vertices and midpoints.
struct Distance_samples
{
  explicit Distance_samples(const Mesh_arrays& mesh)
    : at_vertices(mesh.points.size()), at_midpoints(mesh.edges.size()), largest_inside(mesh.number_of_faces())
  {}

  double maximum(const Mesh_arrays& mesh, std::size_t f) const
  {
    return (std::max)(largest_inside[f], on_sides(mesh, f).maximum());
  }

  Distances_on_sides on_sides(const Mesh_arrays& mesh, std::size_t f) const
  {
    return distances_on_sides(mesh, f, at_vertices, at_midpoints);
  }

  std::vector<double> at_vertices;
  std::vector<double> at_midpoints;
  std::vector<double> largest_inside; // of the faces: at first those at the barycenters
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_DISTANCE_SAMPLES_H
