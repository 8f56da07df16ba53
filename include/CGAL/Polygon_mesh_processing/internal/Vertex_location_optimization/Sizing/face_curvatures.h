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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACE_CURVATURES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACE_CURVATURES_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/corner_normals.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Mesh_arrays.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// the principal curvatures, |k1| >= |k2|
struct Curvatures
{
  double k1 = 0;
  double k2 = 0;
};

// The eigenvalues of the matrix ((a, b), (b, c)).
inline Curvatures principal_curvatures(double a, double b, double c)
{
  const double mean = (a + c) / 2, root = std::hypot((a - c) / 2, b);
  return mean >= 0 ? Curvatures{ mean + root, mean - root } : Curvatures{ mean - root, mean + root };
}

// The curvatures that best explain how the normals change along the sides of a triangle: the second fundamental form
// ((a, b), (b, c)), in an orthonormal basis of the plane, is fitted to its products with the sides.
inline Curvatures fit_curvatures(const std::array<Point, 3>& triangle, const std::array<Vector, 3>& normals)
{
  const Vector x = normalized(triangle[1] - triangle[0]);
  const Vector y = cross_product(normalized(area_normal(triangle[0], triangle[1], triangle[2])), x);
  double uu = 0, uv = 0, vv = 0, u_p = 0, cross = 0, v_q = 0;
  for(int k = 0; k < 3; ++k)
  {
    const Vector side = triangle[(k + 2) % 3] - triangle[(k + 1) % 3], change = normals[(k + 2) % 3] - normals[(k + 1) % 3];
    const double u = side * x, v = side * y, p = change * x, q = change * y;
    uu += u * u;
    uv += u * v;
    vv += v * v;
    u_p += u * p;
    cross += v * p + u * q;
    v_q += v * q;
  }
  // uu a + uv b = u_p, uv a + (uu + vv) b + uv c = cross, uv b + vv c = v_q
  const double determinant = (uu + vv) * (uu * vv - uv * uv);
  if(!(determinant > 0))
    return {};
  const double b = (uu * vv * cross - uv * (vv * u_p + uu * v_q)) / determinant;
  const Curvatures curvatures = principal_curvatures((u_p - uv * b) / uu, b, (v_q - uv * b) / vv);
  return std::isfinite(curvatures.k1) && std::isfinite(curvatures.k2) ? curvatures : Curvatures();
}

// the normals at the corners: those of the faces around, weighted by their angles, up to the creases
template <typename ConcurrencyTag>
std::vector<Vector>
average_corner_normals(const Mesh_arrays& mesh, const std::vector<Vector>& face_normals, const std::vector<char>& is_crease)
{
  const Sectors sectors(mesh, is_crease);
  std::vector<Vector> normals(3 * mesh.number_of_faces());
  for_each_index<ConcurrencyTag>(normals.size(), [&](std::size_t corner) {
    Vector sum = NULL_VECTOR;
    sectors.for_each_corner(static_cast<Index>(corner), [&](Index c) {
      const Point& p = mesh.points[mesh.vertex(c)];
      const Point &q = mesh.points[mesh.vertex(Mesh_arrays::next(c))],
                  &r = mesh.points[mesh.vertex(Mesh_arrays::previous(c))];
      sum = sum + angle_at(p, q, r) * face_normals[c / 3];
    });
    normals[corner] = normalized(sum);
  });
  return normals;
}

template <typename ConcurrencyTag>
std::vector<Curvatures>
compute_face_curvatures(const Mesh_arrays& mesh, const std::vector<Vector>& face_normals, const std::vector<char>& is_crease)
{
  const std::vector<Vector> normals = average_corner_normals<ConcurrencyTag>(mesh, face_normals, is_crease);
  std::vector<Curvatures> curvatures(mesh.number_of_faces());
  for_each_index<ConcurrencyTag>(curvatures.size(), [&](std::size_t f) {
    curvatures[f] = fit_curvatures(mesh.triangle(f), { normals[3 * f], normals[3 * f + 1], normals[3 * f + 2] });
  });
  return curvatures;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACE_CURVATURES_H
