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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_PATCHES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_PATCHES_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Patch_tree.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/triangle_coordinates.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// For each patch the largest area(k) of the feet hint(k), k < m, in it; where there is none, the larger one of those
// before and after it: what follows each other is close in space, but for a few leaps.
template <typename HintAt, typename AreaAt>
std::vector<double>
spread_over_patches(const std::size_t number_of_patches, const std::size_t m, const HintAt& hint, const AreaAt& area)
{
  std::vector<double> areas(number_of_patches, 0);
  for(std::size_t k = 0; k < m; ++k)
  {
    double& of_patch = areas[Patch_foot(hint(k)).patch];
    of_patch = (std::max)(of_patch, area(k));
  }
  double last = 0;
  for(std::size_t begin = 0, end = 0; begin < areas.size(); begin = end)
  {
    while(end < areas.size() && !(areas[end] > 0))
      ++end;
    const double next = end < areas.size() ? areas[end] : 0;
    std::fill(areas.begin() + begin, areas.begin() + end, (std::max)(last, next));
    last = next;
    end += end < areas.size();
  }
  return areas;
}

// Samples patches as `for_each_area_sample()` in `Reference_access.h` says. They are in an order in which neighbors follow
// each other: points at equal steps of the area are spread over the surface.
template <typename Patch, typename HintAt, typename AreaAt, typename F>
void sample_patches(const std::vector<Patch>& patches,
                    const std::size_t n,
                    const std::size_t m,
                    const HintAt& hint,
                    const AreaAt& area,
                    const F& f)
{
  const std::vector<double> areas = spread_over_patches(patches.size(), m, hint, area); // that a sample there stands for
  std::vector<double> numbers(patches.size());                                          // of samples
  for(Index i = 0; i < patches.size(); ++i)
    numbers[i] = areas[i] > 0 ? patches[i].area() / areas[i] : 0;
  const double factor = n / std::accumulate(numbers.begin(), numbers.end(), 0.); // so that they are n

  double passed = 0;
  std::size_t number = 0; // of the samples so far
  for(Index i = 0; i < patches.size(); ++i)
    if(numbers[i] > 0)
      for(passed += factor * numbers[i]; number + 0.5 < passed; ++number)
        f(Patch_foot{ i, low_discrepancy_coordinates(number) }, areas[i] / factor);
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_PATCHES_H
