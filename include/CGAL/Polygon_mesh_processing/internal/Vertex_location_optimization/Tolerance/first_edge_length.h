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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIRST_EDGE_LENGTH_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIRST_EDGE_LENGTH_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Mesh_arrays.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// the edge lengths that are tried: the first one, and those between which all are
struct Edge_length_range
{
  double first;
  double shortest;
  double longest;
};

struct Mesh_extent
{
  explicit Mesh_extent(const Mesh_arrays& mesh)
  {
    Bbox_3 box;
    for(const Point& p : mesh.points)
      box += p.bbox();
    longest_side = (std::max)({ box.x_span(), box.y_span(), box.z_span() });
    for(Index e = 0; e < mesh.edges.size(); ++e)
    {
      const double length = norm(mesh.points[mesh.edges[e][1]] - mesh.points[mesh.edges[e][0]]);
      mean_edge_length += length / mesh.edges.size();
      if(!mesh.is_border(e))
        bending += length * dihedral_angle(mesh, e);
    }
    for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      area += mesh.area(f);
  }

  double longest_side = 0;
  double mean_edge_length = 0;
  double area = 0;
  double bending = 0; // the integral of the larger principal curvature, about: edge lengths times angles between faces

private:
  static double dihedral_angle(const Mesh_arrays& mesh, Index e)
  {
    const Vector m = mesh.area_normal(mesh.edge_corners[e][0] / 3), n = mesh.area_normal(mesh.edge_corners[e][1] / 3);
    return std::atan2(norm(cross_product(m, n)), m * n);
  }
};

// The best equilateral triangles of edge length h on a surface of area A have the mean error f h^2 sqrt(3) / 4 times the
// mean of the larger curvature, where f depends on the ratio of the curvatures and is about 0.055. The tolerated error is
// `ratio` times the mean error. On a rough input the curvatures are those of its noise: a length below its own is no guess.
inline double guess_edge_length(const Mesh_extent& extent, double tolerance, double ratio)
{
  constexpr double f = 0.055;
  const double square = 4 * extent.area * tolerance / (std::sqrt(3.) * f * ratio * extent.bending);
  const double longest = extent.longest_side / 4; // still leaves a shape to measure
  return square < longest * longest ? (std::max)(std::sqrt(square), (std::min)(extent.mean_edge_length, longest)) : longest;
}

// No mesh has more than four times the faces of the input, or a hundred thousand if that is more: whatever the guess and
// the errors say, the time has a bound. None has longer edges than the longest side of the model.
inline Edge_length_range
find_edge_length_range(const Mesh_extent& extent, std::size_t number_of_faces, double tolerance, double ratio)
{
  constexpr double least_bound_of_faces = 100000, growth = 4;
  const double faces = (std::max)(growth * number_of_faces, least_bound_of_faces);
  const double longest = extent.longest_side;
  const double shortest = std::sqrt(extent.area / faces * 4 / std::sqrt(3.));
  return { guess_edge_length(extent, tolerance, ratio), std::clamp(shortest, 1e-5 * longest, longest), longest };
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIRST_EDGE_LENGTH_H
