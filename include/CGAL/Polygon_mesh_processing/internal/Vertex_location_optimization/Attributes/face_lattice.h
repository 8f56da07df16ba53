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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACE_LATTICE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACE_LATTICE_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Flat_triangle.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// A face is sampled at six points in each of the s * s congruent triangles that its sides, cut into s pieces, make. Each
// sample stands for the same area. The means over them are exact for polynomials of degree 3: their coordinates are the
// roots of x^3 - x^2 + x / 4 - 1 / 60, in each order (Strang and Fix, An Analysis of the Finite Element Method, 1973).
inline std::size_t number_of_lattice_points(std::size_t s) { return 6 * s * s; }

// the smallest s with at least `number_of_points` samples, which may be a fraction
inline std::size_t number_of_pieces(double number_of_points)
{
  constexpr double most = 128; // should a face of the reference have nearly no area
  return static_cast<std::size_t>((std::max)(1., (std::min)(most, std::ceil(std::sqrt(number_of_points / 6)))));
}

// Calls f(x) for the coordinates x of each sample, neighbors after each other.
template <typename F>
void for_each_lattice_point(const std::size_t s, const F& f)
{
  constexpr double a = 0.1090390090728772, b = 0.2319333685530305, c = 0.6590276223740923;
  constexpr std::array<std::array<double, 2>, 6> points{ { { a, b }, { a, c }, { b, c }, { c, b }, { c, a }, { b, a } } };
  for(std::size_t i = 0; i < s; ++i)
    for(std::size_t j = 0; j < s - i; ++j)
    {
      for(const auto& p : points)
        f(Coordinates{ (i + p[0]) / s, (j + p[1]) / s });
      if(i + j + 1 < s)
        for(const auto& p : points)
          f(Coordinates{ (i + 1 - p[0]) / s, (j + 1 - p[1]) / s });
    }
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACE_LATTICE_H
