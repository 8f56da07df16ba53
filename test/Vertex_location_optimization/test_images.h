// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_TEST_IMAGES_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_TEST_IMAGES_H

#include "mesh_quality.h"
#include "test_meshes.h"

#include <CGAL/Geometry_image.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <vector>

// Geometry images by formula. Samples that are the same point of the surface are the same bits, but for signs of zeros.

using Image = CGAL::Geometry_image<Point>;

// f(i, j) for each sample
template <typename F>
Image make_image(std::size_t width, std::size_t height, const F& f)
{
  Image image(width, height);
  for(std::size_t i = 0; i < height; ++i)
    for(std::size_t j = 0; j < width; ++j)
      image(i, j) = f(i, j);
  return image;
}

// The unit sphere through an octahedron, whose lower half is unfolded into the corners: each side is folded onto itself.
// The four samples in the middles of the sides are at the distance `spike` from the center.
inline Image octahedral_sphere(std::size_t n, double spike = 1)
{
  return make_image(n, n, [&](std::size_t i, std::size_t j) {
    double x = 2. * j / (n - 1) - 1, y = 2. * i / (n - 1) - 1;
    const double z = 1 - std::abs(x) - std::abs(y);
    if(z < 0)
    {
      const double u = x, v = y;
      x = std::copysign(1 - std::abs(v), u);
      y = std::copysign(1 - std::abs(u), v);
    }
    const bool is_fold = (x == 0 || y == 0) && z == 0;
    return CGAL::ORIGIN + (is_fold ? spike : 1.) * unit(Vector(x, y, z));
  });
}

// The unit sphere with a pole as the first and the last row, and with the first column equal to the last.
inline Image polar_sphere(std::size_t width, std::size_t height)
{
  return make_image(width, height, [&](std::size_t i, std::size_t j) {
    const double theta = i * CGAL_PI / (height - 1), phi = (j % (width - 1)) * 2 * CGAL_PI / (width - 1);
    const double radius = (i == 0 || i + 1 == height) ? 0 : std::sin(theta);
    return Point(radius * std::cos(phi), -radius * std::sin(phi), std::cos(theta));
  });
}

// A torus around the z-axis. If the radii are equal all points of a circle are one: the surface touches itself there.
inline Image torus(std::size_t width, std::size_t height, double large_radius, double small_radius)
{
  return make_image(width, height, [&](std::size_t i, std::size_t j) {
    const double u = (j % (width - 1)) * 2 * CGAL_PI / (width - 1), v = (i % (height - 1)) * 2 * CGAL_PI / (height - 1);
    const double r = i % (height - 1) == 0 ? large_radius - small_radius : large_radius - small_radius * std::cos(v);
    return Point(r * std::cos(u), r * std::sin(u), i % (height - 1) == 0 ? 0 : -small_radius * std::sin(v));
  });
}

// a wavy surface over the unit square
inline Image open_patch(std::size_t width, std::size_t height)
{
  return make_image(width, height, [&](std::size_t i, std::size_t j) {
    const double x = j / (width - 1.), y = i / (height - 1.);
    return Point(x, y, 0.1 * std::sin(5 * x + y) * std::cos(4 * y));
  });
}

// a strip with half a twist, whose last column is the first one upside down
inline Image moebius_strip(std::size_t width, std::size_t height)
{
  return make_image(width, height, [&](std::size_t i, std::size_t j) {
    const bool is_last = j + 1 == width;
    const double t = (is_last ? height - 1. - i : i) / (height - 1.) - 0.5, u = is_last ? 0 : j * 2 * CGAL_PI / (width - 1);
    const double r = 1 + t * std::cos(u / 2);
    return Point(r * std::cos(u), r * std::sin(u), t * std::sin(u / 2));
  });
}

// a cone with its apex in a corner, the sides at which are joined
inline Image cone(std::size_t n)
{
  return make_image(n, n, [&](std::size_t i, std::size_t j) {
    const double r = std::hypot(i, j) / (n - 1), angle = i == 0 || j == 0 ? 0 : 4 * std::atan2(i, j);
    return Point(r * std::cos(angle), r * std::sin(angle), -0.5 * r);
  });
}

// bit by bit
inline bool are_identical(const Point& p, const Point& q)
{
  for(int k = 0; k < 3; ++k)
  {
    const double x = p[k], y = q[k];
    if(std::memcmp(&x, &y, sizeof(double)) != 0)
      return false;
  }
  return true;
}

inline bool are_identical(const Image& a, const Image& b)
{
  if(a.width() != b.width() || a.height() != b.height())
    return false;
  for(std::size_t i = 0; i < a.height(); ++i)
    for(std::size_t j = 0; j < a.width(); ++j)
      if(!are_identical(a(i, j), b(i, j)))
        return false;
  return true;
}

inline Mesh triangulated(const Image& image)
{
  Mesh mesh;
  CGAL::geometry_image_to_polygon_mesh(image, mesh);
  return mesh;
}

inline Mesh triangulated(const Image& image, const Image& diagonals)
{
  Mesh mesh;
  CGAL::geometry_image_to_polygon_mesh(image, mesh, diagonals);
  return mesh;
}

inline std::vector<std::array<std::size_t, 3>> triangles_of(const Mesh& mesh)
{
  std::vector<std::array<std::size_t, 3>> triangles;
  for(Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    triangles.push_back({ mesh.source(h), mesh.target(h), mesh.target(mesh.next(h)) });
  }
  return triangles;
}

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_TEST_IMAGES_H
