// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_REFINE_FACES_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_REFINE_FACES_H

// What changes a remesh where it is beyond a tolerance: flips and pulls.

#include "check.h"
#include "Distance_to_mesh.h"
#include "mesh_quality.h"
#include "test_meshes.h"

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/Polygon_mesh_processing/remesh_within_tolerance.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

// The largest distance between the points of two meshes, measured by other means than the package's.
inline double hausdorff_distance(const Mesh& a, const Mesh& b)
{
  const Distance_to_mesh to_a(a), to_b(b);
  return (std::max)(measure_errors(a, 12, [&](const Point& p) { return to_b(p); }).max,
                    measure_errors(b, 4, [&](const Point& p) { return to_a(p); }).max);
}

struct Mesh_to_refine
{
  using Point_map = Mesh::Property_map<Mesh::Vertex_index, Point>;
  using Test =
    CGAL::Polygon_mesh_processing::internal::vertex_location::Self_intersection_test<CGAL::Sequential_tag, Mesh, Point_map>;

  explicit Mesh_to_refine(Mesh& m)
    : mesh(m), is_constrained(m.add_property_map<Mesh::Edge_index, bool>("e:is_constrained", false).first)
  {
    namespace vl = CGAL::Polygon_mesh_processing::internal::vertex_location;
    vl::read_mesh(m, m.points(), arrays, descriptors);
  }

  // those that `pull_vertices` moves among some vertices
  std::size_t pull(const std::vector<Mesh::Vertex_index>& vertices, const Mesh& reference)
  {
    namespace vl = CGAL::Polygon_mesh_processing::internal::vertex_location;
    std::vector<vl::Index> indices;
    for(vl::Index i = 0; i < descriptors.vertices.size(); ++i)
      if(std::find(vertices.begin(), vertices.end(), descriptors.vertices[i]) != vertices.end())
        indices.push_back(i);
    const CGAL::Polygon_mesh_processing::Flat_triangle_surface<Mesh> surface(reference);
    const Point_map points = mesh.points();
    const Test test(mesh, points, descriptors, true);
    return vl::pull_vertices(indices, arrays, descriptors, points, test, surface.patches()).size();
  }

  std::size_t flip(const Mesh& reference)
  {
    namespace vl = CGAL::Polygon_mesh_processing::internal::vertex_location;
    const CGAL::Polygon_mesh_processing::Flat_triangle_surface<Mesh> surface(reference);
    const auto& patches = surface.patches();
    const Point_map points = mesh.points();
    const Test test(mesh, points, descriptors, true);
    const vl::Side_flips<Mesh, Point_map, Mesh::Property_map<Mesh::Edge_index, bool>, std::decay_t<decltype(patches)>> flips(
      mesh, points, is_constrained, patches);
    return flips.flip({ mesh.faces().begin(), mesh.faces().end() }, arrays.points, test).size();
  }

  Mesh& mesh;
  Mesh::Property_map<Mesh::Edge_index, bool> is_constrained;
  CGAL::Polygon_mesh_processing::internal::vertex_location::Mesh_arrays arrays;
  CGAL::Polygon_mesh_processing::internal::vertex_location::Mesh_descriptors<Mesh> descriptors;
};

inline void test_flips()
{
  start_topic("Edges of a sphere that were flipped are flipped back");
  const Mesh reference = make_mesh(icosphere(2));
  Mesh mesh = reference;
  const std::vector<Mesh::Edge_index> flipped = { Mesh::Edge_index(3), Mesh::Edge_index(200), Mesh::Edge_index(401) };
  for(Mesh::Edge_index e : flipped)
    CGAL::Euler::flip_edge(mesh.halfedge(e), mesh);
  CHECK_AT_LEAST(hausdorff_distance(mesh, reference), 1e-3);
  Mesh kept = mesh;
  const std::size_t number = Mesh_to_refine(mesh).flip(reference);
  CHECK_EQUAL(number, flipped.size());
  CHECK_AT_MOST(hausdorff_distance(mesh, reference), 1e-12);

  Mesh_to_refine with_constraint(kept);
  with_constraint.is_constrained[flipped[1]] = true;
  const std::size_t number_of_others = with_constraint.flip(reference);
  CHECK_EQUAL(number_of_others, flipped.size() - 1);
  CHECK_AT_LEAST(hausdorff_distance(kept, reference), 1e-3);
}

inline void test_pulls()
{
  start_topic("Vertices go to the reference, unless faces come to intersect");
  const Mesh sphere = make_mesh(icosphere(2));
  Mesh mesh = sphere;
  const Mesh::Vertex_index top(0);
  mesh.point(top) = CGAL::ORIGIN + 1.7 * (mesh.point(top) - CGAL::ORIGIN);
  std::size_t number = Mesh_to_refine(mesh).pull({ top }, sphere);
  CHECK_EQUAL(number, 1u);
  CHECK_AT_MOST(norm(mesh.point(top) - sphere.point(top)), 1e-12);

  // The vertex is at a distance of 4.4 from a plane behind the opposite side: the whole way and half of it lead through
  // that.
  const Vector up = sphere.point(top) - CGAL::ORIGIN, u = CGAL::cross_product(up, Vector(1, 2, 3)),
               v = CGAL::cross_product(up, u);
  Soup plane;
  for(const Vector& w : { u, v, -u - v })
    plane.points.push_back(CGAL::ORIGIN - 3.4 * up + 10 * w);
  plane.triangles.push_back({ 0, 1, 2 });
  mesh = sphere;
  number = Mesh_to_refine(mesh).pull({ top }, make_mesh(plane));
  CHECK_EQUAL(number, 1u);
  CHECK_AT_MOST(norm(mesh.point(top) - (CGAL::ORIGIN - 0.1 * up)), 1e-12);
  CHECK(!CGAL::Polygon_mesh_processing::does_self_intersect(mesh));

  // from below the opposite side, no part of the way is free
  for(Point& p : plane.points)
    p = p - 4.6 * up;
  mesh = sphere;
  number = Mesh_to_refine(mesh).pull({ top }, make_mesh(plane));
  CHECK_EQUAL(number, 0u);
  CHECK(points_of(mesh) == points_of(sphere));
}

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_REFINE_FACES_H
