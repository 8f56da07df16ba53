// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_INVARIANTS_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_INVARIANTS_H

#include "check.h"
#include "mesh_quality.h"
#include "test_meshes.h"

#include <algorithm>
#include <cmath>

// What holds for a remesh before and after an optimization, whatever the input, its errors aside.

// the smallest angle of a triangle, in degrees
inline double min_angle(const std::array<Point, 3>& t)
{
  double smallest = 180;
  for(int k = 0; k < 3; ++k)
    smallest = (std::min)(smallest, CGAL::approximate_angle(t[(k + 1) % 3], t[k], t[(k + 2) % 3]));
  return smallest;
}

inline void check_connectivity(const Mesh& before, const Mesh& after)
{
  CHECK_EQUAL(after.number_of_vertices(), before.number_of_vertices());
  CHECK_EQUAL(after.number_of_faces(), before.number_of_faces());
  bool same = after.number_of_halfedges() == before.number_of_halfedges();
  if(same)
    for(Mesh::Halfedge_index h : before.halfedges())
      same =
        same && before.target(h) == after.target(h) && before.next(h) == after.next(h) && before.face(h) == after.face(h);
  CHECK(same);
}

inline void check_finite(const Mesh& mesh)
{
  for(const Point& p : mesh.points())
    CHECK(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()));
}

template <typename IsFixed>
void check_fixed(const Mesh& before, const Mesh& after, const IsFixed& is_fixed)
{
  for(Mesh::Vertex_index v : before.vertices())
    if(is_fixed(v))
      CHECK_EQUAL(after.point(v), before.point(v));
}

// the smallest angle of the faces that share a vertex with f
inline double smallest_angle_around(const Mesh& mesh, Mesh::Face_index f)
{
  double result = 180;
  for(Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
    for(Mesh::Face_index g : mesh.faces_around_target(mesh.halfedge(v)))
      if(g != Mesh::null_face())
        result = (std::min)(result, min_angle(corners(mesh, g)));
  return result;
}

// No face has turned by more than 60 degrees, and none has collapsed, but those that have no area save rounding errors. One
// that has collapsed has a smaller angle than all faces around had before.
inline void check_faces(const Mesh& before, const Mesh& after)
{
  for(Mesh::Face_index f : before.faces())
  {
    const std::array<Point, 3> s = corners(before, f), t = corners(after, f);
    if(s == t)
      continue;
    const Vector m = area_vector(s), n = area_vector(t);
    if(norm(m) > 1e-12 * (std::max)(CGAL::squared_distance(s[0], s[1]), CGAL::squared_distance(s[0], s[2])))
    {
      CHECK_AT_LEAST(m * n, 0.499 * norm(m) * norm(n));
      if(min_angle(t) < (std::min)(10., min_angle(s) / 2) - 1e-6)
        CHECK_AT_LEAST(min_angle(t), smallest_angle_around(before, f) - 1e-6);
    }
  }
}

// with the default parameters
inline void check_invariants(const Mesh& before, const Mesh& after)
{
  check_connectivity(before, after);
  check_finite(after);
  check_fixed(before, after, [&](Mesh::Vertex_index v) { return before.is_border(v); });
  check_faces(before, after);
}

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_INVARIANTS_H
