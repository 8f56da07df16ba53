// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_POLYGON_MESHES_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_POLYGON_MESHES_H

#include "test_meshes.h"

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/centroid.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

// polygons by formula
struct Polygon_soup
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
};

template <typename PolygonMesh = Mesh>
PolygonMesh make_mesh(const Polygon_soup& soup)
{
  PolygonMesh mesh;
  std::vector<typename boost::graph_traits<PolygonMesh>::vertex_descriptor> vertices;
  for(const Point& p : soup.points)
  {
    vertices.push_back(add_vertex(mesh));
    put(get(CGAL::vertex_point, mesh), vertices.back(), p);
  }
  for(const std::vector<std::size_t>& polygon : soup.polygons)
  {
    std::vector<typename boost::graph_traits<PolygonMesh>::vertex_descriptor> corners;
    for(std::size_t i : polygon)
      corners.push_back(vertices[i]);
    CGAL::Euler::add_face(corners, mesh);
  }
  return mesh;
}

template <typename Transformation>
Polygon_soup transformed(Polygon_soup soup, Transformation t)
{
  for(Point& p : soup.points)
    p = t(p);
  return soup;
}

// the squares of the grid [0, columns] x [0, rows]
inline Polygon_soup square_grid(std::size_t columns, std::size_t rows)
{
  Polygon_soup soup;
  for(std::size_t j = 0; j <= rows; ++j)
    for(std::size_t i = 0; i <= columns; ++i)
      soup.points.emplace_back(i, j, 0);
  for(std::size_t j = 0; j < rows; ++j)
    for(std::size_t i = 0; i < columns; ++i)
    {
      const std::size_t a = j * (columns + 1) + i;
      soup.polygons.push_back({ a, a + 1, a + columns + 2, a + columns + 1 });
    }
  return soup;
}

inline Point to_unit_sphere(const Point& p)
{
  return CGAL::ORIGIN + (p - CGAL::ORIGIN) / std::sqrt((p - CGAL::ORIGIN).squared_length());
}

// the unit sphere with n x n quads on each side of a cube, whose edges are great arcs that are equally far apart
inline Polygon_soup cube_sphere(int n)
{
  Polygon_soup soup;
  std::map<std::array<int, 3>, std::size_t> numbers;
  for(int axis = 0; axis < 3; ++axis)
    for(int side = 0; side < 2; ++side)
    {
      const auto number_at = [&](int i, int j) {
        std::array<int, 3> key;
        key[axis] = side * n;
        key[(axis + 1) % 3] = i;
        key[(axis + 2) % 3] = j;
        const auto [it, is_new] = numbers.emplace(key, soup.points.size());
        const auto coordinate = [&](int k) { return std::tan(CGAL_PI / 4 * (2. * key[k] / n - 1)); };
        if(is_new)
          soup.points.push_back(to_unit_sphere(Point(coordinate(0), coordinate(1), coordinate(2))));
        return it->second;
      };
      for(int i = 0; i < n; ++i)
        for(int j = 0; j < n; ++j)
        {
          const std::size_t a = number_at(i, j), b = number_at(i + 1, j), c = number_at(i + 1, j + 1),
                            d = number_at(i, j + 1);
          soup.polygons.push_back(side == 1 ? std::vector<std::size_t>{ a, b, c, d }
                                            : std::vector<std::size_t>{ a, d, c, b });
        }
    }
  return soup;
}

// the unit sphere with 12 pentagons and, above level 0, hexagons
inline Mesh dual_icosphere(int level)
{
  const Mesh triangles = make_mesh(icosphere(level));
  Polygon_soup soup;
  for(const Mesh::Face_index f : triangles.faces())
  {
    std::vector<Point> corners;
    for(const Mesh::Vertex_index v : vertices_around_face(triangles.halfedge(f), triangles))
      corners.push_back(triangles.point(v));
    soup.points.push_back(to_unit_sphere(CGAL::centroid(corners.begin(), corners.end(), CGAL::Dimension_tag<0>())));
  }
  for(const Mesh::Vertex_index v : triangles.vertices())
  {
    std::vector<std::size_t> corners;
    for(const Mesh::Face_index f : faces_around_target(triangles.halfedge(v), triangles))
      corners.insert(corners.begin(), std::size_t(f)); // these go clockwise
    soup.polygons.push_back(corners);
  }
  return make_mesh(soup);
}

// The mesh with the fan of each face from its corner number `shift`, counted from the halfedge of the face.
inline Mesh with_fans(Mesh mesh, int shift)
{
  const std::vector<Mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
  for(const Mesh::Face_index f : faces)
  {
    Mesh::Halfedge_index h = mesh.halfedge(f);
    for(int i = 0; i < shift; ++i)
      h = mesh.next(h);
    while(!CGAL::is_triangle(h, mesh))
      CGAL::Euler::split_face(h, mesh.next(mesh.next(h)), mesh);
  }
  return mesh;
}

// the mesh with other first corners
inline Mesh with_other_corners_first(Mesh mesh)
{
  for(const Mesh::Face_index f : mesh.faces())
    for(std::size_t i = 0; i < std::size_t(f) % 7; ++i)
      mesh.set_halfedge(f, mesh.next(mesh.halfedge(f)));
  return mesh;
}

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_POLYGON_MESHES_H
