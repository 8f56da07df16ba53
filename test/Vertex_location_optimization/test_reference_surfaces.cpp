// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The feet on the two reference surfaces, against brute force and closed forms.

#include "check.h"
#include "Distance_to_mesh.h"
#include "Independent_PN_mesh.h"
#include "tessellate_patches.h"
#include "mesh_quality.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/PN_triangle_surface.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Random.h>

#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
using PN_surface = PMP::PN_triangle_surface<Mesh>;
using Flat_surface = PMP::Flat_triangle_surface<Mesh>;

CGAL::Random generator(1);

Vector random_vector(double size)
{
  return size * Vector(generator.get_double(-1, 1), generator.get_double(-1, 1), generator.get_double(-1, 1));
}

// queries within `distance` of the vertices, or so
std::vector<Point> queries_around(const Mesh& mesh, double distance)
{
  std::vector<Point> queries;
  for(Mesh::Vertex_index v : mesh.vertices())
    queries.push_back(mesh.point(v) + random_vector(distance));
  return queries;
}

template <typename Surface>
double distance_to(const Surface& surface, const Point& query)
{
  return std::sqrt(CGAL::squared_distance(query, surface.point(surface.project(query))));
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

double distance_to_cube(const Point& p)
{
  const double x = std::abs(p.x()), y = std::abs(p.y()), z = std::abs(p.z());
  const double largest = (std::max)({ x, y, z });
  if(largest <= 1)
    return 1 - largest;
  return norm(Vector((std::max)(x - 1, 0.), (std::max)(y - 1, 0.), (std::max)(z - 1, 0.)));
}

// the largest difference between the distances to the surface and to the cube
double deviation_from_cube(const PN_surface& surface)
{
  double deviation = 0;
  for(int i = 0; i < 1000; ++i)
  {
    const Point query = CGAL::ORIGIN + random_vector(1.3);
    deviation = (std::max)(deviation, std::abs(distance_to(surface, query) - distance_to_cube(query)));
  }
  return deviation;
}

void test_creases()
{
  using CGAL::parameters::edge_is_constrained_map;
  using CGAL::parameters::sharpness_angle;

  start_topic("A cube stays a cube, unless its edges are no creases");
  for(int level : { 0, 2 })
  {
    Mesh mesh = make_mesh(cube(level));
    auto none = mesh.add_property_map<Mesh::Edge_index, bool>("none", false).first;
    auto all = mesh.add_property_map<Mesh::Edge_index, bool>("all", true).first;
    CHECK_AT_MOST(deviation_from_cube(PN_surface(mesh)), 1e-12);
    CHECK_AT_MOST(deviation_from_cube(PN_surface(mesh, sharpness_angle(89))), 1e-12);
    CHECK_AT_LEAST(deviation_from_cube(PN_surface(mesh, sharpness_angle(91))), 0.01);
    CHECK_AT_LEAST(deviation_from_cube(PN_surface(mesh, edge_is_constrained_map(none))), 0.01);
    CHECK_AT_MOST(deviation_from_cube(PN_surface(mesh, edge_is_constrained_map(all))), 1e-12);
    CHECK_AT_MOST(deviation_from_cube(PN_surface(mesh, sharpness_angle(89).edge_is_constrained_map(none))), 1e-12);
    CHECK_AT_MOST(deviation_from_cube(PN_surface(mesh, edge_is_constrained_map(all).sharpness_angle(91))), 1e-12);
  }

  start_topic("The default of sharpness_angle is 40 degrees");
  for(std::size_t segments : { 8, 10 })
  {
    // a prism whose edges turn by 45 or 36 degrees
    const PN_surface surface(make_mesh(cylinder(segments, 1, 0)));
    const double angle = CGAL_PI / segments; // between two edges
    const double deviation = std::abs(distance_to(surface, Point(std::cos(angle), std::sin(angle), 0.1)));
    if(segments == 8)
      CHECK_NEAR(deviation, 1 - std::cos(angle), 1e-9);
    else
      CHECK_AT_MOST(deviation, 0.1 * (1 - std::cos(angle)));
  }
}

// Walks over the surface in small steps from the foot of a point to `goal`, which a crack would make impossible.
void check_walk(const PN_surface& surface, const Point& from, const Point& goal)
{
  constexpr int number_of_steps = 500;
  auto foot = surface.project(from);
  Point p = surface.point(foot);
  const double step = norm(goal - p) / number_of_steps;
  double longest = 0;
  for(int i = 0; i < 2 * number_of_steps && norm(goal - p) > step; ++i)
  {
    foot = surface.project(p + step * unit(goal - p), foot);
    const Point q = surface.point(foot);
    longest = (std::max)(longest, norm(q - p));
    p = q;
  }
  CHECK_AT_MOST(norm(goal - p), step);
  CHECK_AT_MOST(longest, 2 * step);
}

// walks from both sides to the middle of every `stride`th crease
template <typename Is_crease>
void check_walks(const Mesh& mesh, const PN_surface& surface, int stride, const Is_crease& is_crease)
{
  int count = 0;
  for(Mesh::Edge_index e : mesh.edges())
    if(!mesh.is_border(e) && is_crease(e) && ++count % stride == 0)
    {
      const Mesh::Halfedge_index h = mesh.halfedge(e);
      const Point &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h));
      const auto s = corners(mesh, mesh.face(h)), t = corners(mesh, mesh.face(mesh.opposite(h)));
      const Vector m = unit(area_vector(s)), n = unit(area_vector(t));
      const Point a = CGAL::centroid(s[0], s[1], s[2]), b = CGAL::centroid(t[0], t[1], t[2]);

      // a query on that side of the surface where the crease is closest
      const double side = (b - p) * m < 0 ? 0.1 : -0.1;
      const Point query = CGAL::midpoint(p, q) + side * norm(q - p) * (m + n);
      const Point goal = surface.point(surface.project(query));
      check_walk(surface, a, goal);
      check_walk(surface, b, goal);
    }
  CHECK_AT_LEAST(count, stride);
}

void test_watertight()
{
  start_topic("Both sides of a crease share its curve");
  auto is_sharp = [](const Mesh& mesh) {
    return [&mesh](Mesh::Edge_index e) {
      const Vector m = area_vector(corners(mesh, mesh.face(mesh.halfedge(e, 0))));
      const Vector n = area_vector(corners(mesh, mesh.face(mesh.halfedge(e, 1))));
      return unit(m) * unit(n) < std::sqrt(0.5);
    };
  };

  // a cylinder closed by two planar caps
  constexpr std::size_t columns = 12, rows = 4;
  Soup can = cylinder(columns, rows);
  const double height = can.points.back().z();
  const std::size_t bottom = can.points.size(), top = bottom + 1;
  can.points.emplace_back(0, 0, 0);
  can.points.emplace_back(0, 0, height);
  for(std::size_t i = 0; i < columns; ++i)
  {
    can.triangles.push_back({ bottom, (i + 1) % columns, i });
    can.triangles.push_back({ top, rows * columns + i, rows * columns + (i + 1) % columns });
  }
  const Mesh can_mesh = make_mesh(can);
  const PN_surface can_surface(can_mesh);
  check_walks(can_mesh, can_surface, 1, is_sharp(can_mesh));
  for(std::size_t i = 0; i < columns; ++i)
  {
    // between the rim's chord and its arc
    const double angle = 2 * CGAL_PI * (i + 0.5) / columns, radius = (1 + std::cos(CGAL_PI / columns)) / 2;
    CHECK_AT_MOST(distance_to(can_surface, Point(radius * std::cos(angle), radius * std::sin(angle), 0)), 1e-9);
    CHECK_AT_MOST(distance_to(can_surface, Point(radius * std::cos(angle), radius * std::sin(angle), height)), 1e-9);
  }

  Mesh fandisk;
  CHECK(CGAL::IO::read_OFF(CGAL::data_file_path("meshes/fandisk.off"), fandisk));
  check_walks(fandisk, PN_surface(fandisk), 10, is_sharp(fandisk));

  // creases where there is none
  Mesh sphere = make_mesh(icosphere(1));
  auto is_crease = sphere.add_property_map<Mesh::Edge_index, bool>("crease", false).first;
  for(Mesh::Edge_index e : sphere.edges())
    is_crease[e] = generator.get_bool();
  check_walks(sphere, PN_surface(sphere, CGAL::parameters::edge_is_constrained_map(is_crease)), 1,
              [&](Mesh::Edge_index e) { return is_crease[e]; });
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
  Mesh elephant;
  CHECK(CGAL::IO::read_OFF(CGAL::data_file_path("meshes/elephant.off"), elephant));
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
