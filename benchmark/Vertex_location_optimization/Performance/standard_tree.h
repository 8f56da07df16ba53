// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_STANDARD_TREE_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_STANDARD_TREE_H

#include "meshes.h"

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/compatibility.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Kernel_traits.h>

#include <cstddef>
#include <vector>

// CGAL's AABB tree as its manual shows it for a mesh, built and ready for closest points.
template <typename TriangleMesh>
class Standard_tree
{
public:
  using Point = typename TriangleMesh::Point;

private:
  using Kernel = typename CGAL::Kernel_traits<Point>::Kernel;
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<TriangleMesh>;
  using Traits = CGAL::Polygon_mesh_processing::internal::vertex_location::AABB_traits_for<Kernel, Primitive>;
  using Tree = CGAL::AABB_tree<Traits>;

public:
  using Foot = typename Tree::Point_and_primitive_id;

  explicit Standard_tree(const TriangleMesh& mesh) : m_tree(faces(mesh).first, faces(mesh).second, mesh)
  {
    m_tree.build();
    m_tree.closest_point(mesh.point(*vertices(mesh).first)); // which builds what speeds up the others
  }

  Point closest_point(const Point& query) const { return m_tree.closest_point(query); }
  Foot project(const Point& query) const { return m_tree.closest_point_and_primitive(query); }
  Foot project(const Point& query, const Foot& hint) const { return m_tree.closest_point_and_primitive(query, hint); }

private:
  Tree m_tree;
};

// seconds for the closest points to the vertices and midpoints of `mesh`
inline double time_of_standard_projection(const Mesh& mesh, const Mesh& reference)
{
  const Standard_tree<Mesh> tree(reference);
  const std::vector<Point> queries = vertices_and_midpoints(mesh);
  std::vector<Point> feet(queries.size());
  return thread_time_of([&] {
    for(std::size_t i = 0; i < queries.size(); ++i)
      feet[i] = tree.closest_point(queries[i]);
  });
}

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_STANDARD_TREE_H
