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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PN_TRIANGLE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PN_TRIANGLE_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/triangle_coordinates.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// A curved PN triangle (Vlachos et al., Curved PN triangles, 2001): a cubic Bezier triangle for the points, a quadratic
// one for the normals. A `Surface_patch`, see `Patch_tree` and `Reference_patches`.
class PN_triangle
{
public:
  // What a corner contributes. The offsets are those of the control points next to it from their places on the edges to
  // the next and to the previous corner.
  struct Corner
  {
    Point point;
    Vector normal;
    std::array<Vector, 2> offsets;
  };

  PN_triangle() {} // nothing is initialized, which takes time

  explicit PN_triangle(const std::array<Corner, 3>& c)
    : m_corners{ { c[0].point, c[1].point, c[2].point } }, n200(c[0].normal), n020(c[1].normal), n002(c[2].normal),
      n110(edge_normal(c[0], c[1])), n011(edge_normal(c[1], c[2])), n101(edge_normal(c[2], c[0]))
  {
    // of the control points from their places on the flat triangle
    const Vector &o210 = c[0].offsets[0], &o201 = c[0].offsets[1], &o021 = c[1].offsets[0], &o120 = c[1].offsets[1],
                 &o102 = c[2].offsets[0], &o012 = c[2].offsets[1];
    const Vector o111 = (o210 + o120 + o021 + o012 + o102 + o201) / 4;

    c20 = 3 * (o120 - 2 * o210);
    c02 = 3 * (o102 - 2 * o201);
    c11 = 6 * (o111 - o210 - o201);
    c30 = 3 * (o210 - o120);
    c03 = 3 * (o201 - o102);
    c21 = 3 * (o021 - o120 - 2 * (o111 - o210) + o201);

    // By the convex hull property no point of the patch is farther from the point of the flat triangle with the same
    // coordinates than the control point that is farthest from its place there.
    double deviation2 = 0;
    for(const Vector& o : { o210, o201, o021, o120, o102, o012, o111 })
      deviation2 = (std::max)(deviation2, o.squared_length());
    m_deviation = std::sqrt(deviation2);
  }

  Bbox_3 bbox() const
  {
    const Bbox_3 box = bounding_box(m_corners);
    return { box.xmin() - m_deviation, box.ymin() - m_deviation, box.zmin() - m_deviation,
             box.xmax() + m_deviation, box.ymax() + m_deviation, box.zmax() + m_deviation };
  }

  const std::array<Point, 3>& corners() const { return m_corners; }
  double deviation() const { return m_deviation; } // from the flat triangle, at most
  double area() const { return norm(area_normal(m_corners[0], m_corners[1], m_corners[2])) / 2; } // of the flat triangle

  Point point(const Coordinates& x) const
  {
    const double u = x.u, v = x.v;
    return m_corners[0] +
           (u * (c10() + u * (c20 + u * c30) + v * (c11 + u * c21 + v * c12())) + v * (c01() + v * (c02 + v * c03)));
  }

  // the quadratic normal; where it vanishes that of the cubic patch
  Vector normal(const Coordinates& x) const
  {
    const double u = x.u, v = x.v, w = 1 - u - v;
    const Vector n = normalized(w * w * n200 + u * u * n020 + v * v * n002 + w * u * n110 + u * v * n011 + w * v * n101);
    if(n != NULL_VECTOR)
      return n;
    const Derivatives d = evaluate(x);
    return normalized(cross_product(d.du, d.dv));
  }

  Coordinates flat_coordinates(const Point& query) const { return project_to_plane(m_corners, query); }

  std::array<bool, 3> sides_farther_than(const Coordinates& x, double squared_distance) const // of the flat triangle
  {
    return vertex_location::sides_farther_than(m_corners, x, squared_distance);
  }

  // from the flat triangle
  Foot_estimate estimate_foot(const Point& query) const
  {
    const Coordinates x = closest_on_triangle(m_corners, query);
    const double distance = std::sqrt(squared_distance(query, point_at(m_corners, x)));
    return { x, (std::max)(0., distance - m_deviation), distance + m_deviation };
  }

  bool improve_foot(const Point& query, Coordinates& x, double& squared_distance_bound) const
  {
    return minimize_distance(query, is_bent() ? closest_of_lattice(query, x) : x, x, squared_distance_bound);
  }

  bool improve_foot_from(const Point& query, Coordinates& x, double& squared_distance_bound) const
  {
    return minimize_distance(query, x, x, squared_distance_bound);
  }

private:
  struct Derivatives
  {
    Point point;
    Vector du, dv, duu, duv, dvv;
  };

  // what follows of the other coefficients, from the ends of the boundary curves and the control point in the middle
  Vector c10() const { return (m_corners[1] - m_corners[0]) - (c20 + c30); }
  Vector c01() const { return (m_corners[2] - m_corners[0]) - (c02 + c03); }
  Vector c12() const { return 2 * (c30 + c03) - c21; }

  static Vector edge_normal(const Corner& a, const Corner& b)
  {
    const Vector d = b.point - a.point, n = a.normal + b.normal;
    const double length2 = d.squared_length();
    return length2 > 0 ? normalized(n - (2 * (d * n) / length2) * d) : normalized(n);
  }

  Derivatives evaluate(const Coordinates& x) const
  {
    const double u = x.u, v = x.v;
    const Vector c10 = this->c10(), c01 = this->c01(), c12 = this->c12();
    return { m_corners[0] +
               (u * (c10 + u * (c20 + u * c30) + v * (c11 + u * c21 + v * c12)) + v * (c01 + v * (c02 + v * c03))),
             c10 + u * (2 * c20 + 3 * u * c30) + v * (c11 + 2 * u * c21 + v * c12),
             c01 + v * (2 * c02 + 3 * v * c03) + u * (c11 + u * c21 + 2 * v * c12),
             2 * c20 + 6 * u * c30 + 2 * v * c21,
             c11 + 2 * u * c21 + 2 * v * c12,
             2 * c02 + 6 * v * c03 + 2 * u * c12 };
  }

  // Whether the patch is so curved that the foot on the flat triangle is a poor estimate of the foot on the patch.
  bool is_bent() const { return 100 * m_deviation * m_deviation > squared_longest_side(m_corners); }

  Coordinates closest_of_lattice(const Point& query, Coordinates best) const
  {
    constexpr int level = 6;
    double best_distance = squared_distance(query, point(best));
    for(int i = 0; i <= level; ++i)
      for(int j = 0; j <= level - i; ++j)
      {
        const Coordinates x{ double(i) / level, double(j) / level };
        const double distance = squared_distance(query, point(x));
        if(distance < best_distance)
        {
          best_distance = distance;
          best = x;
        }
      }
    return best;
  }

  // Newton's method from `x`, the quadratic model being minimized over the whole triangle of coordinates.
  bool minimize_distance(const Point& query, Coordinates x, Coordinates& foot, double& squared_distance_bound) const
  {
    constexpr int max_iterations = 20;
    constexpr double precision = 1e-6; // convergence is quadratic: this step leaves an error of some 1e-12
    Derivatives s = evaluate(x);
    double distance = squared_distance(query, s.point);
    for(int iteration = 0; iteration < max_iterations; ++iteration)
    {
      Coordinates step = newton_step(s, query, x);
      if(std::abs(step.u) + std::abs(step.v) < precision)
      {
        // too short for the distance to matter
        x = { x.u + step.u, x.v + step.v };
        break;
      }

      // shorten the step until the distance decreases
      bool decreased = false;
      for(int halving = 0; halving < 8 && !decreased; ++halving, step = { step.u / 2, step.v / 2 })
      {
        const Coordinates next{ x.u + step.u, x.v + step.v };
        const Derivatives at_next = evaluate(next);
        const double next_distance = squared_distance(query, at_next.point);
        if(next_distance < distance)
        {
          decreased = true;
          x = next;
          s = at_next;
          distance = next_distance;
        }
      }
      if(!decreased)
        break;
    }

    if(!(distance < squared_distance_bound))
      return false;
    squared_distance_bound = distance;
    foot = x;
    return true;
  }

  // The step from `x` to the minimum of the quadratic model of the squared distance over the triangle of coordinates.
  static Coordinates newton_step(const Derivatives& s, const Point& query, const Coordinates& x)
  {
    const Vector d = s.point - query;
    const double g_u = d * s.du, g_v = d * s.dv;
    double h_uu = s.du * s.du + d * s.duu, h_uv = s.du * s.dv + d * s.duv, h_vv = s.dv * s.dv + d * s.dvv;
    double det = h_uu * h_vv - h_uv * h_uv;
    if(!(h_uu > 0 && det > 1e-6 * h_uu * h_vv))
    {
      // not convex here: Gauss-Newton
      h_uu = s.du * s.du;
      h_uv = s.du * s.dv;
      h_vv = s.dv * s.dv;
      det = h_uu * h_vv - h_uv * h_uv;
    }

    if(det > 0)
    {
      const Coordinates step{ (h_uv * g_v - h_vv * g_u) / det, (h_uv * g_u - h_uu * g_v) / det };
      const double u = x.u + step.u, v = x.v + step.v;
      if(u >= 0 && v >= 0 && u + v <= 1)
        return step;
    }

    // the minimum is on the boundary: the best of the three sides
    Coordinates best{ 0, 0 };
    double best_value = 0;
    auto try_side = [&](const Coordinates& a, const Coordinates& b) {
      const double e_u = b.u - a.u, e_v = b.v - a.v, a_u = a.u - x.u, a_v = a.v - x.v;
      const double curvature = h_uu * e_u * e_u + 2 * h_uv * e_u * e_v + h_vv * e_v * e_v;
      const double slope = g_u * e_u + g_v * e_v + h_uu * a_u * e_u + h_uv * (a_u * e_v + a_v * e_u) + h_vv * a_v * e_v;
      const double t = curvature > 0 ? (std::min)(1., (std::max)(0., -slope / curvature)) : 0.;
      const Coordinates step{ a_u + t * e_u, a_v + t * e_v };
      const double value =
        g_u * step.u + g_v * step.v + (h_uu * step.u * step.u + 2 * h_uv * step.u * step.v + h_vv * step.v * step.v) / 2;
      if(value < best_value)
      {
        best_value = value;
        best = step;
      }
    };
    try_side({ 0, 0 }, { 1, 0 });
    try_side({ 0, 0 }, { 0, 1 });
    try_side({ 1, 0 }, { 0, 1 });
    return best;
  }

  // what an estimate takes comes first
  std::array<Point, 3> m_corners;
  double m_deviation; // upper bound of the distance between corresponding points of the patch and the flat triangle
  Vector c20, c11, c02, c30, c21, c03; // coefficients of the patch in powers of u and v, from corner 0
  Vector n200, n020, n002, n110, n011, n101;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PN_TRIANGLE_H
