// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_DISTANCE_TO_MESH_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_DISTANCE_TO_MESH_H

#include "test_meshes.h"

#include <CGAL/version.h>
#if CGAL_VERSION_MAJOR >= 6
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>

#include <cmath>
#include <utility>

// CGAL's closest points on a triangle mesh, with nothing of the package
class Distance_to_mesh
{
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
#if CGAL_VERSION_MAJOR >= 6
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>>;
#else
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
#endif

public:
  explicit Distance_to_mesh(Mesh mesh)
    : m_mesh(std::move(mesh)), m_tree(faces(m_mesh).begin(), faces(m_mesh).end(), m_mesh)
  {}

  Distance_to_mesh(const Distance_to_mesh&) = delete;
  Distance_to_mesh& operator=(const Distance_to_mesh&) = delete;

  double operator()(const Point& p) const { return std::sqrt(m_tree.squared_distance(p)); }

  double operator()(const Point& p, Point& hint) const
  {
    hint = m_tree.closest_point(p, hint);
    return std::sqrt(CGAL::squared_distance(p, hint));
  }

  // the closest point and its face
  std::pair<Point, Mesh::Face_index> closest(const Point& p) const { return m_tree.closest_point_and_primitive(p); }

  const Mesh& mesh() const { return m_mesh; }

private:
  Mesh m_mesh;
  Tree m_tree;
};

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_DISTANCE_TO_MESH_H
