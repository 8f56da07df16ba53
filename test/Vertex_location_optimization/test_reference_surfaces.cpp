// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The feet on the two reference surfaces, against brute force and closed forms.

#include "check.h"
#include "creases_of_surfaces.h"
#include "Distance_to_mesh.h"
#include "Independent_PN_mesh.h"
#include "tessellate_patches.h"
#include "mesh_quality.h"
#include "read_model.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/PN_triangle_surface.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Random.h>

#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
using PN_surface = PMP::PN_triangle_surface<Mesh>;
using Flat_surface = PMP::Flat_triangle_surface<Mesh>;

// queries within `distance` of the vertices, or so
std::vector<Point> queries_around(const Mesh& mesh, double distance)
{
  std::vector<Point> queries;
  for(Mesh::Vertex_index v : mesh.vertices())
    queries.push_back(mesh.point(v) + random_vector(distance));
  return queries;
}

// the feet of the queries against the closest points of a tessellation that is within `tolerance` of the surface
template <typename Surface>
void check_feet(const Surface& surface,
                const Distance_to_mesh& tessellation,
                const std::vector<Point>& queries,
                double tolerance)
{
  typename Surface::Foot hint = surface.project(queries.back());
  for(const Point& query : queries)
  {
    const auto foot = surface.project(query);
    const Point p = surface.point(foot);
    const double distance = std::sqrt(CGAL::squared_distance(query, p));
    CHECK_NEAR(distance, tessellation(query), tolerance);
    CHECK_AT_MOST(tessellation(p), tolerance);
    CHECK_NEAR(norm(surface.normal(foot)), 1, 1e-12);

    // A hint makes it faster and nothing else. The hint is that of another point, the first far away.
    hint = surface.project(query, hint);
    CHECK_NEAR(std::sqrt(CGAL::squared_distance(query, surface.point(hint))), distance, 1e-4 * tolerance + 1e-15 * distance);
  }
}

// the closest points of the patches
void test_against_brute_force(const Mesh& mesh, int level, double near_by, double far_away)
{
  double tolerance;
  const PN_surface surface(mesh, CGAL::parameters::sharpness_angle(180));
  const Distance_to_mesh tessellation(tessellate_patches(surface, mesh.number_of_faces(), level, tolerance));
  check_feet(surface, tessellation, queries_around(mesh, near_by), tolerance);
  check_feet(surface, tessellation, queries_around(mesh, far_away), tolerance);
}

// PN triangles as in the paper, on a mesh where any average of the faces is the normal
void test_against_independent_patches(const Mesh& mesh)
{
  double tolerance;
  const Independent_PN_mesh independent(mesh);
  const Distance_to_mesh tessellation(independent.tessellate(80, tolerance));
  const PN_surface surface(mesh, CGAL::parameters::sharpness_angle(180));
  std::vector<Point> queries;
  for(int i = 0; i < 2000; ++i)
    queries.push_back(CGAL::ORIGIN + random_vector(1.5));
  check_feet(surface, tessellation, queries, tolerance);

  // the quadratic normals, where their place is known
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    const auto foot = surface.project(mesh.point(v));
    CHECK_AT_MOST(norm(surface.point(foot) - mesh.point(v)), 1e-9);
    CHECK_AT_MOST(norm(surface.normal(foot) - independent.normal(mesh.halfedge(v))), 1e-6);
  }
  for(Mesh::Edge_index e : mesh.edges())
  {
    const Point p = independent.curve_midpoint(mesh.halfedge(e));
    const auto foot = surface.project(p);
    CHECK_AT_MOST(norm(surface.point(foot) - p), 1e-9);
    CHECK_AT_MOST(norm(surface.normal(foot) - independent.curve_midpoint_normal(mesh.halfedge(e))), 1e-5);
  }
}

void test_flat(const Mesh& mesh, double near_by, double far_away)
{
  const Distance_to_mesh distance(mesh);
  const Flat_surface surface(mesh);
  check_feet(surface, distance, queries_around(mesh, near_by), 1e-12 * far_away);
  check_feet(surface, distance, queries_around(mesh, far_away), 1e-12 * far_away);
  for(Mesh::Face_index f : mesh.faces())
  {
    const std::array<Point, 3> t = corners(mesh, f);
    const auto foot = surface.project(CGAL::centroid(t[0], t[1], t[2]));
    CHECK_AT_MOST(norm(surface.normal(foot) - unit(area_vector(t))), 1e-9);
  }
}

// With the foot of a point nearby as hint, however near, the foot is that of the query.
void test_hints()
{
  start_topic("A hint does not move the foot");
  const PN_surface surface(make_mesh(icosphere(2)));
  for(int i = 0; i < 200; ++i)
  {
    const Point query = CGAL::ORIGIN + 1.1 * unit(random_vector(1));
    const Point expected = surface.point(surface.project(query));
    for(double distance = 1e-9; distance < 1; distance *= 10)
    {
      const auto hint = surface.project(query + random_vector(distance));
      CHECK_AT_MOST(norm(surface.point(surface.project(query, hint)) - expected), 1e-11);
      const auto local = surface.patches().project_locally({ query.x(), query.y(), query.z() }, hint);
      CHECK_AT_MOST(norm(surface.point(local) - expected), 1e-11);
    }
  }
}

// Beyond the edges of a convex polyhedron two facets have the closest point; the one that is reported is always the same.
void test_feet_on_sides()
{
  start_topic("Where facets share the closest point the hint does not choose the normal");
  const Mesh mesh = make_mesh(icosphere(1));
  const CGAL::Polygon_mesh_processing::Flat_triangle_surface<Mesh> surface(mesh);
  for(auto e : mesh.edges())
  {
    const Point p = mesh.point(source(halfedge(e, mesh), mesh)), q = mesh.point(target(halfedge(e, mesh), mesh));
    const Point beyond_edge = CGAL::ORIGIN + 1.3 * (CGAL::midpoint(p, q) - CGAL::ORIGIN);
    const Point beyond_vertex = CGAL::ORIGIN + 1.3 * (p - CGAL::ORIGIN);
    for(const Point& query : { beyond_edge, beyond_vertex })
    {
      const Vector normal = surface.normal(surface.project(query));
      for(int i = 0; i < 10; ++i)
      {
        const auto hint = surface.project(query + random_vector(0.5));
        CHECK_AT_MOST(norm(surface.normal(surface.project(query, hint)) - normal), 1e-9);
        const auto local = surface.patches().project_locally({ query.x(), query.y(), query.z() }, hint);
        CHECK_AT_MOST(norm(surface.normal(local) - normal), 1e-9);
      }
    }
  }
}

void test_border()
{
  start_topic("A border ends the surface");
  const Mesh mesh = make_mesh(cylinder(12, 4, 0)); // planar quads: its normals are in the planes of the borders
  const double height = points_of(mesh).back().z();
  const PN_surface surface(mesh);
  for(int i = 0; i < 100; ++i)
  {
    const double angle = generator.get_double(0, 2 * CGAL_PI);
    const Point above(1.01 * std::cos(angle), 1.01 * std::sin(angle), height + 0.5);
    const Point p = surface.point(surface.project(above));
    CHECK_NEAR(p.z(), height, 1e-9);
    CHECK_NEAR(std::hypot(p.x(), p.y()), 1, 2e-3);
  }
}

void test_degenerate_faces()
{
  start_topic("Faces without an area do no harm");
  Mesh mesh = make_mesh(icosphere(2));
  for(int i = 0; i < 10; ++i) // edges of length 0
  {
    const Mesh::Halfedge_index h(31 * i);
    mesh.point(mesh.target(h)) = mesh.point(mesh.source(h));
  }
  for(int i = 0; i < 10; ++i) // a corner on the opposite edge
  {
    const Mesh::Halfedge_index h(401 + 31 * i);
    mesh.point(mesh.target(mesh.next(h))) = CGAL::midpoint(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
  }
  const PN_surface surface(mesh);
  const Flat_surface flat(mesh);
  for(int i = 0; i < 5000; ++i)
  {
    const Point query = CGAL::ORIGIN + random_vector(1.5);
    CHECK_NEAR(distance_to(surface, query), distance_to(flat, query), 0.2);
    CHECK_NEAR(norm(surface.normal(surface.project(query))), 1, 1e-12);
  }
}

int main()
{
  start_topic("Feet on the icosahedron, whose patches are strongly curved");
  const Mesh icosahedron = make_mesh(icosphere(0));
  test_against_independent_patches(icosahedron);
  test_against_brute_force(icosahedron, 80, 0.1, 1);

  start_topic("Feet on the elephant");
  const Mesh elephant = read_model("elephant");
  const CGAL::Bbox_3 box = CGAL::bbox_3(elephant.points().begin(), elephant.points().end());
  const double size = box.ymax() - box.ymin();
  test_against_brute_force(elephant, 8, 0.005 * size, 0.05 * size);

  start_topic("Feet on the flat elephant");
  test_flat(elephant, 0.005 * size, 0.05 * size);

  test_hints();
  test_feet_on_sides();
  test_creases();
  test_watertight();
  test_border();
  test_degenerate_faces();
  return test_result();
}
