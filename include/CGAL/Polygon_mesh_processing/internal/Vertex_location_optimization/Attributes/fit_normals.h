// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIT_NORMALS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIT_NORMALS_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/sample_normals.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Placement/piecewise_linear_update.h>

#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The direction of `n` unless it turns away from the sample `otherwise`, which it replaces; never without a length.
inline Vector unit_normal_or(const Vector& n, const Vector& otherwise)
{
  if(n * otherwise > 0 && normalized(n) != NULL_VECTOR)
    return normalized(n);
  return otherwise != NULL_VECTOR ? otherwise : Vector(0, 0, 1);
}

// Section 3.4: the unit normals at the corners of the faces whose linear interpolation is closest to the samples, by
// equations (1) and (2) over the sector of each corner. All corners of a sector have the same normal.
template <typename ConcurrencyTag>
std::vector<Vector> fit_normals(const Mesh_arrays& mesh, const Normal_samples& samples, const std::vector<char>& is_crease)
{
  const Sectors sectors(mesh, is_crease);

  std::vector<Vector> normals(3 * mesh.number_of_faces());
  for_each_index<ConcurrencyTag>(normals.size(), [&](std::size_t i) {
    Vector sum = NULL_VECTOR, sample = NULL_VECTOR;
    sectors.for_each_corner(static_cast<Index>(i), [&](Index c) {
      const Index first = c - c % 3;
      const auto n = [&](Index k) -> const Vector& { return samples.at_corners[first + k]; };
      const auto m = [&](Index k) -> const Vector& { return samples.at_midpoints[first + k]; };
      sum = sum + norm(mesh.area_normal(c / 3)) * (n(c % 3) + piecewise_linear_update(c % 3, n, m));
      if(sample == NULL_VECTOR)
        sample = n(c % 3);
    });
    normals[i] = unit_normal_or(sum, sample);
  });
  return normals;
}

// The normals of the vertices: that of the sector with the largest area, the reference's own for a vertex without faces.
inline std::vector<Vector> choose_vertex_normals(const Mesh_arrays& mesh,
                                                 const Normal_samples& samples,
                                                 const std::vector<char>& is_crease,
                                                 const std::vector<Vector>& corner_normals)
{
  const Sectors sectors(mesh, is_crease);
  std::vector<double> largest(mesh.points.size(), -1);
  std::vector<Vector> normals(mesh.points.size());
  for(std::size_t i = 0; i < normals.size(); ++i)
    normals[i] = unit_normal_or(samples.at_vertices[i], samples.at_vertices[i]);

  for(Index c = 0; c < corner_normals.size(); ++c)
  {
    double area = 0;
    sectors.for_each_corner(c, [&](Index other) { area += norm(mesh.area_normal(other / 3)); });
    if(area > largest[mesh.vertex(c)])
    {
      largest[mesh.vertex(c)] = area;
      normals[mesh.vertex(c)] = corner_normals[c];
    }
  }
  return normals;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIT_NORMALS_H
