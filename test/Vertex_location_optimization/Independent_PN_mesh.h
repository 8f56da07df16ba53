// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_INDEPENDENT_PN_MESH_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_INDEPENDENT_PN_MESH_H

#include "mesh_quality.h"
#include "test_meshes.h"

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

// Curved PN triangles over a mesh, written down from Vlachos et al. without a look at the package: it is what the package
// is compared with. Normals stop at borders and at edges where the surface turns by more than `sharpness_angle` degrees;
// the two sides of such an edge have different curves.
class Independent_PN_mesh
{
public:
  explicit Independent_PN_mesh(const Mesh& mesh, double sharpness_angle = 180)
    : m_mesh(mesh), m_normals(mesh.number_of_halfedges())
  {
    std::vector<Vector> face_normals;
    for(Mesh::Face_index f : mesh.faces())
      face_normals.push_back(unit(area_vector(corners(mesh, f))));

    auto is_smooth = [&](Mesh::Halfedge_index h) {
      return !mesh.is_border(mesh.edge(h)) && face_normals[mesh.face(h)] * face_normals[mesh.face(mesh.opposite(h))] >=
                                                std::cos(sharpness_angle * CGAL_PI / 180);
    };
    auto weighted_normal = [&](Mesh::Halfedge_index h) -> Vector {
      const Vector a = mesh.point(mesh.source(h)) - mesh.point(mesh.target(h));
      const Vector b = mesh.point(mesh.target(mesh.next(h))) - mesh.point(mesh.target(h));
      return std::atan2(norm(CGAL::cross_product(a, b)), a * b) * face_normals[mesh.face(h)];
    };
    for(Mesh::Halfedge_index h : mesh.halfedges())
    {
      if(mesh.is_border(h))
        continue;
      Vector sum = weighted_normal(h);
      Mesh::Halfedge_index g = h;
      while(is_smooth(mesh.next(g)) && (g = mesh.opposite(mesh.next(g))) != h)
        sum += weighted_normal(g);
      if(g != h || !is_smooth(mesh.next(g))) // no full turn: the other way as well
        for(g = h; is_smooth(g);)
        {
          g = mesh.prev(mesh.opposite(g));
          sum += weighted_normal(g);
        }
      m_normals[h] = unit(sum);
    }
  }

  // the normal at the corner that h points to
  const Vector& normal(Mesh::Halfedge_index h) const { return m_normals[h]; }

  // the middle of the boundary curve along h, and the interpolated normal there
  Point curve_midpoint(Mesh::Halfedge_index h) const
  {
    const Point &p = m_mesh.point(m_mesh.source(h)), &q = m_mesh.point(m_mesh.target(h));
    const Vector m = normal(m_mesh.prev(h)), n = normal(h);
    const Vector d = q - p;
    const Vector b1 = d / 3 - (d * m) / 3 * m, b2 = -d / 3 + (d * n) / 3 * n;
    return CGAL::midpoint(p, q) + 3. / 8 * (b1 + b2);
  }
  Vector curve_midpoint_normal(Mesh::Halfedge_index h) const
  {
    const Vector d = m_mesh.point(m_mesh.target(h)) - m_mesh.point(m_mesh.source(h));
    const Vector sum = normal(m_mesh.prev(h)) + normal(h);
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
    for(Mesh::Halfedge_index h : halfedges_around_face(m_mesh.halfedge(f), m_mesh))
    {
      p[k] = m_mesh.point(m_mesh.target(h)) - CGAL::ORIGIN;
      n[k++] = m_normals[h];
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
        sum += 6 / (factorial[i] * factorial[j] * factorial[3 - i - j]) * std::pow(u, i) * std::pow(v, j) *
               std::pow(w, 3 - i - j) * b[i][j];
    return CGAL::ORIGIN + sum;
  }

  const Mesh& m_mesh;
  std::vector<Vector> m_normals; // by halfedge: at the corner that it points to
};

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_INDEPENDENT_PN_MESH_H
