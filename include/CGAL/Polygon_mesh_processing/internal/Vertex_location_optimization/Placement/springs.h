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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SPRINGS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SPRINGS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

constexpr std::size_t default_number_of_relaxation_steps = 1;

// The force between two neighbors, equations (3) and (4).
struct Spring
{
  // on the end of the spring, where `from_other_end` leads; `length` is that of the edges there
  static Vector force(const Vector& from_other_end, const double length)
  {
    constexpr double area_per_vertex = 0.866; // in units of length^2, of equilateral triangles
    const double two_sigma2 = 2 * square(0.3) * area_per_vertex * square(length); // the paper's, but local
    return two_sigma2 > 0 ? Vector(std::exp(-from_other_end.squared_length() / two_sigma2) * from_other_end) : NULL_VECTOR;
  }
};

// Section 3.3: springs between neighbors keep the vertices apart. Only the force in the tangent plane, orthogonal to
// `normal(i)`, is applied: along the normal, it would inflate the surface. Vertices that the fit does not move have no
// springs, so that planar parts do not change. `strength(i)` is a factor to the force on vertex i.
template <typename ConcurrencyTag, typename Strength, typename Normal>
void relax_springs(Remesh& remesh, const std::size_t number_of_steps, const Strength& strength, const Normal& normal)
{
  if(number_of_steps == 0)
    return;

  std::vector<Point> relaxed(remesh.points.size());
  for(std::size_t step = 0; step < number_of_steps; ++step)
  {
    for_each_index<ConcurrencyTag>(relaxed.size(), [&](std::size_t i) {
      const Point& p = remesh.next_points[i];
      relaxed[i] = p;
      if(!remesh.is_free(i) || remesh.is_at_rest(i))
        return;

      Vector force = NULL_VECTOR;
      remesh.for_each_corner(i, [&](Index c) {
        // around an inner vertex each neighbor follows it in one polygon
        if(remesh.ear(c) == c)
          force = force + Spring::force(p - remesh.next_points[remesh.vertex(Mesh_arrays::next(c))], remesh.lengths[i]);
      });
      const Vector& n = normal(i);
      relaxed[i] = p + strength(i) * (force - (force * n) * n);
    });
    remesh.next_points.swap(relaxed);
  }
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SPRINGS_H
