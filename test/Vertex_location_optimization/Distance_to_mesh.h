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
#include <CGAL/property_map.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <utility>

// Closest points are several times faster in plain double precision.
using Double_kernel = CGAL::Simple_cartesian<double>;
using Double_point = Double_kernel::Point_3;

template <typename To, typename From>
To converted(const From& p)
{
  return To(p.x(), p.y(), p.z());
}

struct Double_point_map
{
  using key_type = Mesh::Vertex_index;
  using value_type = Double_point;
  using reference = Double_point;
  using category = boost::readable_property_map_tag;

  friend Double_point get(const Double_point_map& map, Mesh::Vertex_index v)
  {
    return converted<Double_point>(map.mesh->point(v));
  }

  const Mesh* mesh = nullptr;
};

// CGAL's closest points on a triangle mesh, with nothing of the package
class Distance_to_mesh
{
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh, Double_point_map, CGAL::Tag_true, CGAL::Tag_true>;
#if CGAL_VERSION_MAJOR >= 6
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Double_kernel, Primitive>>;
#else
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Double_kernel, Primitive>>;
#endif

public:
  explicit Distance_to_mesh(Mesh mesh) : m_mesh(std::move(mesh))
  {
    m_tree.insert(faces(m_mesh).begin(), faces(m_mesh).end(), m_mesh, Double_point_map{ &m_mesh });
    m_tree.build();
  }

  Distance_to_mesh(const Distance_to_mesh&) = delete;
  Distance_to_mesh& operator=(const Distance_to_mesh&) = delete;

  double operator()(const Point& p) const { return std::sqrt(m_tree.squared_distance(converted<Double_point>(p))); }

  // the same, faster if `hint` is the closest point of a point nearby; it becomes that of p
  double operator()(const Point& p, Point& hint) const
  {
    hint = converted<Point>(m_tree.closest_point(converted<Double_point>(p), converted<Double_point>(hint)));
    return std::sqrt(CGAL::squared_distance(p, hint));
  }

  Mesh::Face_index closest_face(const Point& p) const
  {
    return m_tree.closest_point_and_primitive(converted<Double_point>(p)).second;
  }

  const Mesh& mesh() const { return m_mesh; }

private:
  Mesh m_mesh;
  Tree m_tree;
};

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_DISTANCE_TO_MESH_H
