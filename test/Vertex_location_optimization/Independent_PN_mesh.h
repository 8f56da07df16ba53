// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_INDEPENDENT_PN_MESH_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_INDEPENDENT_PN_MESH_H

#include "test_meshes.h"

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

inline double norm(const Vector& v) { return std::sqrt(v.squared_length()); }
inline Vector unit(const Vector& v) { return v / norm(v); }

inline std::array<Point, 3> corners(const Mesh& mesh, Mesh::Face_index f)
{
  const Mesh::Halfedge_index h = mesh.halfedge(f);
  return { mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h))) };
}

inline Vector area_vector(const std::array<Point, 3>& t) { return CGAL::cross_product(t[1] - t[0], t[2] - t[0]) / 2; }

// Curved PN triangles over a closed smooth mesh, written down from Vlachos et al. without a look at the package: it is
// what the package is compared with.
class Independent_PN_mesh
{
public:
  explicit Independent_PN_mesh(const Mesh& mesh) : m_mesh(mesh)
  {
    m_normals.assign(mesh.number_of_vertices(), Vector(0, 0, 0));
    for(Mesh::Face_index f : mesh.faces())
    {
      const Vector normal = unit(area_vector(corners(mesh, f)));
      for(Mesh::Halfedge_index h : halfedges_around_face(mesh.halfedge(f), mesh))
      {
        const Vector a = unit(mesh.point(mesh.source(h)) - mesh.point(mesh.target(h)));
        const Vector b = unit(mesh.point(mesh.target(mesh.next(h))) - mesh.point(mesh.target(h)));
        m_normals[mesh.target(h)] += std::acos((std::max)(-1., (std::min)(1., a * b))) * normal;
      }
    }
    for(Vector& n : m_normals)
      n = unit(n);
  }

  const Vector& normal(Mesh::Vertex_index v) const { return m_normals[v]; }

  // the middle of the boundary curve along h, and the interpolated normal there
  Point curve_midpoint(Mesh::Halfedge_index h) const
  {
    const Point &p = m_mesh.point(m_mesh.source(h)), &q = m_mesh.point(m_mesh.target(h));
    const Vector m = normal(m_mesh.source(h)), n = normal(m_mesh.target(h));
    const Vector d = q - p;
    const Vector b1 = d / 3 - (d * m) / 3 * m, b2 = -d / 3 + (d * n) / 3 * n;
    return CGAL::midpoint(p, q) + 3. / 8 * (b1 + b2);
  }
  Vector curve_midpoint_normal(Mesh::Halfedge_index h) const
  {
    const Vector d = m_mesh.point(m_mesh.target(h)) - m_mesh.point(m_mesh.source(h));
    const Vector sum = normal(m_mesh.source(h)) + normal(m_mesh.target(h));
    return unit(sum + unit(sum - 2 * (d * sum) / (d * d) * d));
  }

  // Each face in level * level triangles. `tolerance` is how far they are at most from the patches.
  Mesh tessellate(int level, double& tolerance) const
  {
    Soup soup;
    double bend = 0; // the largest second difference of the control points
    for(Mesh::Face_index f : m_mesh.faces())
    {
      const Control_points b = control_points(f);
      for(int i = 0; i < 2; ++i)
        for(int j = 0; i + j < 2; ++j)
        {
          const Vector p = b[i][j], u = b[i + 1][j] - p, v = b[i][j + 1] - p;
          bend = (std::max)({ bend, norm(b[i + 2][j] - b[i + 1][j] - u), norm(b[i][j + 2] - b[i][j + 1] - v),
                              norm(b[i + 1][j + 1] - p - u - v) });
        }

      std::map<std::pair<int, int>, std::size_t> index;
      for(int i = 0; i <= level; ++i)
        for(int j = 0; i + j <= level; ++j)
        {
          index[{ i, j }] = soup.points.size();
          soup.points.push_back(evaluate(b, double(i) / level, double(j) / level));
        }
      for(int i = 0; i < level; ++i)
        for(int j = 0; i + j < level; ++j)
        {
          soup.triangles.push_back({ index[{ i, j }], index[{ i + 1, j }], index[{ i, j + 1 }] });
          if(i + j < level - 1)
            soup.triangles.push_back({ index[{ i + 1, j }], index[{ i + 1, j + 1 }], index[{ i, j + 1 }] });
        }
    }
    // the second derivatives are 6 times convex combinations of second differences
    tolerance = 6 * bend / (2. * level * level);
    return make_mesh(soup);
  }

private:
  using Control_points = std::array<std::array<Vector, 4>, 4>; // [i][j] is b_{3-i-j, i, j}

  Control_points control_points(Mesh::Face_index f) const
  {
    std::array<Vector, 3> p, n;
    std::size_t k = 0;
    for(Mesh::Vertex_index v : vertices_around_face(m_mesh.halfedge(f), m_mesh))
    {
      p[k] = m_mesh.point(v) - CGAL::ORIGIN;
      n[k++] = m_normals[v];
    }
    auto edge_point = [&](int i, int j) { return (2 * p[i] + p[j] - ((p[j] - p[i]) * n[i]) * n[i]) / 3; };
    Control_points b;
    b[0][0] = p[0];
    b[3][0] = p[1];
    b[0][3] = p[2];
    b[1][0] = edge_point(0, 1);
    b[2][0] = edge_point(1, 0);
    b[2][1] = edge_point(1, 2);
    b[1][2] = edge_point(2, 1);
    b[0][2] = edge_point(2, 0);
    b[0][1] = edge_point(0, 2);
    const Vector e = (b[1][0] + b[2][0] + b[2][1] + b[1][2] + b[0][2] + b[0][1]) / 6;
    b[1][1] = e + (e - (p[0] + p[1] + p[2]) / 3) / 2;
    return b;
  }

  static Point evaluate(const Control_points& b, double u, double v)
  {
    constexpr double factorial[] = { 1, 1, 2, 6 };
    const double w = 1 - u - v;
    Vector sum(0, 0, 0);
    for(int i = 0; i <= 3; ++i)
      for(int j = 0; i + j <= 3; ++j)
        sum += 6 / (factorial[i] * factorial[j] * factorial[3 - i - j]) *
               std::pow(u, i) * std::pow(v, j) * std::pow(w, 3 - i - j) * b[i][j];
    return CGAL::ORIGIN + sum;
  }

  const Mesh& m_mesh;
  std::vector<Vector> m_normals;
};

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_INDEPENDENT_PN_MESH_H
