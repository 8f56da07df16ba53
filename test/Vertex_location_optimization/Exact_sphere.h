// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_EXACT_SPHERE_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_EXACT_SPHERE_H

#include "mesh_quality.h"
#include "test_meshes.h"

#include <memory>

// A model of `ReferenceSurface` as a user may write it, with no more than the concept has.
class Exact_sphere
{
public:
  using Point_3 = Point;
  using Vector_3 = Vector;
  struct Foot
  {
    std::shared_ptr<Vector> direction;
  }; // in memory of its own: no thread may read what another assigns

  Exact_sphere(const Point& center, double radius) : m_center(center), m_radius(radius) {}

  Foot project(const Point& p) const { return { std::make_shared<Vector>(unit(p - m_center)) }; }
  Foot project(const Point& p, const Foot&) const { return project(p); }
  Point point(const Foot& foot) const { return m_center + m_radius * *foot.direction; }
  Vector normal(const Foot& foot) const { return *foot.direction; }

private:
  Point m_center;
  double m_radius;
};

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_EXACT_SPHERE_H
