// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_MESH_QUALITY_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_MESH_QUALITY_H

#include "test_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>

// The package's own measures are not used here, so that they cannot err with it.

inline double norm(const Vector& v) { return std::sqrt(v.squared_length()); }
inline Vector unit(const Vector& v) { return v.squared_length() > 0 ? v / norm(v) : v; }

inline std::array<Point, 3> corners(const Mesh& mesh, Mesh::Face_index f)
{
  const Mesh::Halfedge_index h = mesh.halfedge(f);
  return { mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h))) };
}

inline Vector area_vector(const std::array<Point, 3>& t) { return CGAL::cross_product(t[1] - t[0], t[2] - t[0]) / 2; }

struct Errors
{
  double mean = 0;
  double max = 0;
};

// The distance from the faces of the mesh to a surface: midpoint rule on splits * splits triangles a face, and also the
// sides for the maximum. `distance(p)` is that of a point to the surface.
template <typename Distance>
Errors measure_errors(const Mesh& mesh, int splits, const Distance& distance)
{
  Errors errors;
  double sum_of_areas = 0;
  for(Mesh::Face_index f : mesh.faces())
  {
    const std::array<Point, 3> t = corners(mesh, f);
    const double area = norm(area_vector(t));
    auto distance_at = [&](double u, double v) {
      const double d = distance(t[0] + (u * (t[1] - t[0]) + v * (t[2] - t[0])));
      errors.max = (std::max)(errors.max, d);
      return d;
    };
    double sum = 0;
    for(int i = 0; i < splits; ++i)
      for(int j = 0; i + j < splits; ++j)
      {
        sum += distance_at((i + 1 / 3.) / splits, (j + 1 / 3.) / splits);
        if(i + j < splits - 1)
          sum += distance_at((i + 2 / 3.) / splits, (j + 2 / 3.) / splits);
      }
    for(int i = 0; i < splits; ++i) // on the sides, where the mean has no samples
    {
      const double u = double(i) / splits;
      distance_at(u, 0);
      distance_at(1 - u, u);
      distance_at(0, 1 - u);
    }
    errors.mean += area * sum / (splits * splits);
    sum_of_areas += area;
  }
  errors.mean /= sum_of_areas;
  return errors;
}

// the mean of the squared lengths of the edges at v
inline double mean_squared_length_around(const Mesh& mesh, Mesh::Vertex_index v)
{
  double sum = 0;
  for(Mesh::Halfedge_index h : halfedges_around_target(v, mesh))
    sum += CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(v));
  return sum / mesh.degree(v);
}

// the mean over the faces of the smallest angle, in degrees
inline double mean_min_angle(const Mesh& mesh)
{
  double sum = 0;
  for(Mesh::Face_index f : mesh.faces())
  {
    const std::array<Point, 3> t = corners(mesh, f);
    double smallest = CGAL_PI;
    for(int k = 0; k < 3; ++k)
    {
      const Vector a = t[(k + 1) % 3] - t[k], b = t[(k + 2) % 3] - t[k];
      smallest = (std::min)(smallest, std::atan2(norm(CGAL::cross_product(a, b)), a * b));
    }
    sum += smallest;
  }
  return sum / mesh.number_of_faces() * 180 / CGAL_PI;
}

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_MESH_QUALITY_H
