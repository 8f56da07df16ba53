// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces where the result is known: spheres, cylinders and planes.

#include "check.h"
#include "check_equivariance.h"
#include "Exact_sphere.h"
#include "mesh_quality.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>

namespace PMP = CGAL::Polygon_mesh_processing;

// another model of `ReferenceSurface`: the cylinder of radius 1 around the z-axis
class Exact_cylinder
{
public:
  using Point_3 = Point;
  using Vector_3 = Vector;
  struct Foot
  {
    Vector direction;
    double height;
  };

  Foot project(const Point& p) const { return { unit(Vector(p.x(), p.y(), 0)), p.z() }; }
  Foot project(const Point& p, const Foot&) const { return project(p); }
  Point point(const Foot& foot) const { return Point(0, 0, foot.height) + foot.direction; }
  Vector normal(const Foot& foot) const { return foot.direction; }
};

// What equations (1) and (2) make of a sphere of radius 1 around v, where the height over the tangent plane is minus half
// the squared distance, for any lengths of the edges.
double expected_shift(const Mesh& mesh, Mesh::Vertex_index v)
{
  double sum = 0, sum_of_areas = 0;
  for(Mesh::Halfedge_index h : halfedges_around_target(v, mesh))
  {
    const Point &p = mesh.point(v), &q = mesh.point(mesh.source(h)), &r = mesh.point(mesh.target(mesh.next(h)));
    const double a2 = CGAL::squared_distance(p, q), b2 = CGAL::squared_distance(p, r), c2 = CGAL::squared_distance(q, r);
    const double area = norm(area_vector({ p, q, r }));
    sum += area * (11 * (a2 + b2) - 7 * c2) / 120;
    sum_of_areas += area;
  }
  return sum / sum_of_areas;
}

void test_sphere()
{
  start_topic("A sphere of radius r: vertices move by h^2 / 8r, the mean error falls to a fifth");
  const double r = 3;
  const Point center(1, -2, 5);
  for(int level : { 2, 4 })
  {
    Mesh mesh = make_mesh(transformed(icosphere(level), [&](const Point& p) { return center + r * (p - CGAL::ORIGIN); }));
    const Exact_sphere sphere(center, r);
    auto distance = [&](const Point& p) { return std::abs(norm(p - center) - r); };
    const Errors before = measure_errors(mesh, 8, distance);
    PMP::optimize_vertex_locations(mesh, sphere);
    const Errors after = measure_errors(mesh, 8, distance);

    for(Mesh::Vertex_index v : mesh.vertices())
    {
      const double shift = norm(mesh.point(v) - center) - r;
      CHECK_NEAR(shift / (expected_shift(mesh, v) / r), 1, 0.02);
      if(mesh.degree(v) == 6)
        CHECK_NEAR(shift / (mean_squared_length_around(mesh, v) / (8 * r)), 1, 0.02);
    }
    CHECK_NEAR(after.mean / before.mean, 0.2, 0.01);
    CHECK_LESS(after.max, before.max);
  }
}

void test_cylinder()
{
  start_topic("A cylinder of radius r: vertices move by h^2 / 16r, the mean error falls to 0.38 of what it was");
  Mesh mesh = make_mesh(cylinder(64, 60));
  auto is_inner = [rows = 60u](Mesh::Vertex_index v) { return v / 64 >= 10 && v / 64 <= rows - 10; };
  auto distance = [&](const Point& p) { return std::abs(std::hypot(p.x(), p.y()) - 1); };
  const std::vector<Point> initial = points_of(mesh);
  const Errors before = measure_errors(mesh, 8, distance);
  PMP::optimize_vertex_locations(mesh, Exact_cylinder());
  const Errors after = measure_errors(mesh, 8, distance);

  const double h = 2 * CGAL_PI / 64;
  for(Mesh::Vertex_index v : mesh.vertices())
    if(mesh.is_border(v))
      CHECK_EQUAL(mesh.point(v), initial[v]);
    else if(is_inner(v))
      CHECK_NEAR((std::hypot(mesh.point(v).x(), mesh.point(v).y()) - 1) * 16 / (h * h), 1, 0.02);
  CHECK_NEAR(after.mean / before.mean, 0.38, 0.02);
}

void test_planes()
{
  start_topic("Planar meshes stay as they are");
  for(double size : { 1e-6, 1., 1e6 })
  {
    auto place = [&](const Point& p) { return CGAL::ORIGIN + size * (rigid_motion(p) - CGAL::ORIGIN); };
    const Mesh plane = make_mesh(transformed(planar_patch(12), place));
    const Mesh reference = make_mesh(
      transformed(triangle_grid(5, 5), [&](const Point& p) { return place(Point(4 * p.x() - 3, 4 * p.y() - 3, 0)); }));
    const double extent = 12 * size;

    Mesh mesh = plane;
    const auto report = PMP::optimize_vertex_locations(mesh, reference);
    CHECK_AT_MOST(largest_distance(points_of(mesh), points_of(plane)), 1e-12 * extent);
    CHECK(report.converged);
    CHECK_AT_MOST(report.displacement, 1e-12 * extent);

    // with a vertex and an edge inside that are constrained
    mesh = plane;
    auto vertex_is_constrained = mesh.add_property_map<Mesh::Vertex_index, bool>("constrained", false).first;
    auto edge_is_constrained = mesh.add_property_map<Mesh::Edge_index, bool>("constrained", false).first;
    vertex_is_constrained[Mesh::Vertex_index(70)] = true;
    edge_is_constrained[mesh.edge(mesh.halfedge(Mesh::Vertex_index(100)))] = true;
    const auto constrained_report = PMP::optimize_vertex_locations(
      mesh, reference,
      CGAL::parameters::vertex_is_constrained_map(vertex_is_constrained).edge_is_constrained_map(edge_is_constrained));
    CHECK_AT_MOST(largest_distance(points_of(mesh), points_of(plane)), 1e-12 * extent);
    CHECK(constrained_report.converged);
  }
}

void test_equivariance()
{
  start_topic("The optimized sphere scales and moves with the input");
  check_equivariance(make_mesh(transformed(icosphere(3), rotated)), make_mesh(icosphere(4)));
}

int main()
{
  test_sphere();
  test_cylinder();
  test_planes();
  test_equivariance();
  return test_result();
}
