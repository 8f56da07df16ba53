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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PATCH_VOLUME_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PATCH_VOLUME_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <array>
#include <cstddef>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The signed volume of the cone from `apex` over a patch. The patch is replaced by triangles on finer and finer lattices,
// with n pieces on a side; the error is a polynomial in 1 / n^2, as the patch is polynomial, and is extrapolated to 0.
template <typename Patch>
double volume_of_cone(const Patch& patch, const Point& apex)
{
  constexpr std::size_t levels = 5;
  std::array<double, levels> volumes; // row by row of Neville's scheme
  for(std::size_t k = 0; k < levels; ++k)
  {
    const int n = static_cast<int>(k) + 1;
    const auto at = [&](int i, int j) { return patch.point({ double(i) / n, double(j) / n }) - apex; };
    const auto cone = [](const Vector& p, const Vector& q, const Vector& r) { return p * cross_product(q, r) / 6; };
    volumes[k] = 0;
    for(int i = 0; i < n; ++i)
      for(int j = 0; j < n - i; ++j)
      {
        volumes[k] += cone(at(i, j), at(i + 1, j), at(i, j + 1));
        if(i + j + 1 < n)
          volumes[k] += cone(at(i + 1, j + 1), at(i, j + 1), at(i + 1, j));
      }
    for(std::size_t l = k; l > 0; --l)
    {
      const double ratio = square(double(n) / static_cast<double>(l));
      volumes[l - 1] = volumes[l] + (volumes[l] - volumes[l - 1]) / (ratio - 1);
    }
  }
  return volumes[0];
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PATCH_VOLUME_H
