// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_TEST_MESHES_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_TEST_MESHES_H

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;

// triangles by formula
struct Soup
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

// a mesh of the triangles of a soup
template <typename TriangleMesh = Mesh>
TriangleMesh make_mesh(const Soup& soup)
{
  TriangleMesh mesh;
  auto vpm = get(CGAL::vertex_point, mesh);
  using Target_point = typename boost::property_traits<decltype(vpm)>::value_type;
  using FT = typename CGAL::Kernel_traits<Target_point>::Kernel::FT;

  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices;
  for(const Point& p : soup.points)
  {
    vertices.push_back(add_vertex(mesh));
    put(vpm, vertices.back(), Target_point(FT(p.x()), FT(p.y()), FT(p.z())));
  }
  for(const auto& t : soup.triangles)
    CGAL::Euler::add_face(std::array{ vertices[t[0]], vertices[t[1]], vertices[t[2]] }, mesh);
  return mesh;
}

// the points of a mesh in the order of its vertices
template <typename TriangleMesh>
std::vector<Point> points_of(const TriangleMesh& mesh)
{
  std::vector<Point> points;
  auto vpm = get(CGAL::vertex_point, mesh);
  for(auto v : vertices(mesh))
  {
    const auto& p = get(vpm, v);
    points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }
  return points;
}

// the largest distance between corresponding points
inline double largest_distance(const std::vector<Point>& a, const std::vector<Point>& b)
{
  double largest = a.size() == b.size() ? 0 : HUGE_VAL;
  for(std::size_t i = 0; i < (std::min)(a.size(), b.size()); ++i)
  {
    const double distance = std::sqrt(CGAL::squared_distance(a[i], b[i]));
    if(!(distance <= largest))
      largest = distance; // also a NaN, which stays
  }
  return largest;
}

template <typename Transformation>
Soup transformed(Soup soup, Transformation t)
{
  for(Point& p : soup.points)
    p = t(p);
  return soup;
}

// both, apart from each other
inline Soup combined(Soup a, const Soup& b)
{
  const std::size_t n = a.points.size();
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for(const auto& t : b.triangles)
    a.triangles.push_back({ n + t[0], n + t[1], n + t[2] });
  return a;
}

// A rotation about an axis that is no axis of the coordinate system. Meshes with a symmetry in common should be turned
// against each other by it: the foot of a point on a plane of symmetry can be equally close on both its sides.
inline Point rotated(const Point& p)
{
  const double c = std::cos(0.7), s = std::sin(0.7), d = std::cos(-1.1), e = std::sin(-1.1);
  const Point q(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z());
  return Point(q.x(), d * q.y() - e * q.z(), e * q.y() + d * q.z());
}

inline Point rigid_motion(const Point& p) { return rotated(p) + Vector(0.3, -0.2, 0.5); }

// each triangle in four
inline Soup subdivide(const Soup& coarse)
{
  Soup fine{ coarse.points, {} };
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> midpoints;
  auto middle = [&](std::size_t i, std::size_t j) {
    const auto [it, is_new] = midpoints.emplace(std::minmax(i, j), fine.points.size());
    if(is_new)
      fine.points.push_back(CGAL::midpoint(fine.points[i], fine.points[j]));
    return it->second;
  };
  for(const auto& [a, b, c] : coarse.triangles)
  {
    const std::size_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    fine.triangles.insert(fine.triangles.end(), { { a, ab, ca }, { ab, b, bc }, { ca, bc, c }, { ab, bc, ca } });
  }
  return fine;
}

// the unit sphere
inline Soup icosphere(int level)
{
  const double g = (1 + std::sqrt(5.)) / 2;
  Soup soup{ { { -1, g, 0 },
               { 1, g, 0 },
               { -1, -g, 0 },
               { 1, -g, 0 },
               { 0, -1, g },
               { 0, 1, g },
               { 0, -1, -g },
               { 0, 1, -g },
               { g, 0, -1 },
               { g, 0, 1 },
               { -g, 0, -1 },
               { -g, 0, 1 } },
             { { 0, 11, 5 },  { 0, 5, 1 },  { 0, 1, 7 },  { 0, 7, 10 }, { 0, 10, 11 }, { 1, 5, 9 }, { 5, 11, 4 },
               { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 },  { 3, 9, 4 },  { 3, 4, 2 },   { 3, 2, 6 }, { 3, 6, 8 },
               { 3, 8, 9 },   { 4, 9, 5 },  { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 },   { 9, 8, 1 } } };
  auto project = [](const Point& p) {
    return CGAL::ORIGIN + (p - CGAL::ORIGIN) / std::sqrt((p - CGAL::ORIGIN).squared_length());
  };
  soup = transformed(soup, project);
  for(int i = 0; i < level; ++i)
    soup = transformed(subdivide(soup), project);
  return soup;
}

// A regular grid of triangles over [0, columns] x [0, rows], odd rows shifted, by half a column as in a grid of equilateral
// triangles; if periodic, the first column follows the last.
inline Soup triangle_grid(std::size_t columns, std::size_t rows, bool is_periodic = false, double shift = 0.5)
{
  Soup soup;
  const std::size_t width = is_periodic ? columns : columns + 1;
  for(std::size_t j = 0; j <= rows; ++j)
    for(std::size_t i = 0; i < width; ++i)
      soup.points.emplace_back(i + (j % 2) * shift, j, 0.);
  for(std::size_t j = 0; j < rows; ++j)
    for(std::size_t i = 0; i < columns; ++i)
    {
      const std::size_t next = (i + 1) % width;
      const std::size_t a = j * width + i, b = j * width + next, c = a + width, d = b + width;
      if(j % 2 == 0)
        soup.triangles.insert(soup.triangles.end(), { { a, b, c }, { b, d, c } });
      else
        soup.triangles.insert(soup.triangles.end(), { { a, d, c }, { a, b, d } });
    }
  return soup;
}

// an open cylinder around the z-axis of radius 1; unless another shift is given, of equilateral triangles that are bent
inline Soup cylinder(std::size_t columns, std::size_t rows, double shift = 0.5)
{
  const double step = 2 * CGAL_PI / columns, height = step * std::sqrt(3.) / 2;
  return transformed(triangle_grid(columns, rows, true, shift),
                     [&](const Point& p) { return Point(std::cos(p.x() * step), std::sin(p.x() * step), p.y() * height); });
}

// an irregular patch of the plane z = 0 over [0, n] x [0, n]
inline Soup planar_patch(std::size_t n)
{
  CGAL::Random random(7);
  return transformed(triangle_grid(n, n), [&](const Point& p) {
    auto moved = [&](double x) { return (x == 0 || x >= n) ? x : x + random.get_double(-0.24, 0.24); };
    const double x = moved(p.x()), y = moved(p.y());
    return Point(x, y, 0);
  });
}

// the cube [-1, 1]^3 with 2 * 4^level triangles a side
inline Soup cube(int level)
{
  Soup soup{
    { { -1, -1, -1 }, { 1, -1, -1 }, { 1, 1, -1 }, { -1, 1, -1 }, { -1, -1, 1 }, { 1, -1, 1 }, { 1, 1, 1 }, { -1, 1, 1 } },
    { { 0, 2, 1 },
      { 0, 3, 2 },
      { 4, 5, 6 },
      { 4, 6, 7 },
      { 0, 1, 5 },
      { 0, 5, 4 },
      { 1, 2, 6 },
      { 1, 6, 5 },
      { 2, 3, 7 },
      { 2, 7, 6 },
      { 3, 0, 4 },
      { 3, 4, 7 } }
  };
  for(int i = 0; i < level; ++i)
    soup = subdivide(soup);
  return soup;
}

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_TEST_MESHES_H
