// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Constrained edges and borders: they stay, or follow the curves of the reference.

#include "check.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/approximation_error.h>
#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

using Edge_map = Mesh::Property_map<Mesh::Edge_index, bool>;

// the cylinder of radius 1 between z = 0 and z = height, with its caps
Soup can(std::size_t columns, std::size_t rows, double height)
{
  const double step = 2 * CGAL_PI / columns;
  Soup soup = transformed(triangle_grid(columns, rows, true), [&](const Point& p) {
    return Point(std::cos(p.x() * step), std::sin(p.x() * step), p.y() * height / rows);
  });
  const std::size_t bottom = soup.points.size(), top = bottom + 1, last_row = rows * columns;
  soup.points.insert(soup.points.end(), { Point(0, 0, 0), Point(0, 0, height) });
  for(std::size_t i = 0; i < columns; ++i)
  {
    const std::size_t j = (i + 1) % columns;
    soup.triangles.push_back({ j, i, bottom });
    soup.triangles.push_back({ last_row + i, last_row + j, top });
  }
  return soup;
}

double radius(const Point& p) { return std::sqrt(p.x() * p.x() + p.y() * p.y()); }

template <typename IsCrease>
Edge_map mark(Mesh& mesh, const IsCrease& is_crease)
{
  Edge_map map = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_crease", false).first;
  for(Mesh::Edge_index e : mesh.edges())
    map[e] = is_crease(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)));
  return map;
}

// whether an edge is on a rim of the can
struct Is_on_rim
{
  bool operator()(const Point& p, const Point& q) const { return is_on_rim(p) && is_on_rim(q) && p.z() == q.z(); }
  bool is_on_rim(const Point& p) const { return (p.z() == 0 || p.z() == height) && radius(p) > 0.9; }

  double height;
};

// The fit to a circle of radius 1 is a polygon whose corners are chord^2 / 12 outside.
void check_fitted_circle(const Mesh& remesh, const Mesh& mesh, double chord, double z)
{
  const double shift = chord * chord / 12;
  int count = 0;
  for(Mesh::Vertex_index v : mesh.vertices())
    if(remesh.point(v).z() == z && radius(remesh.point(v)) > 0.9)
    {
      CHECK_NEAR(radius(mesh.point(v)) - 1, shift, 0.03 * shift);
      CHECK_NEAR(mesh.point(v).z(), z, 0.03 * shift);
      ++count;
    }
  CHECK_AT_LEAST(count, 10);
}

// The mean error is not allowed to grow, and the caps of an inscribed polygon have none: `shortened` allows for rims that
// therefore do not come as far as they should.
void test_rims(double height, std::size_t rows, bool shortened)
{
  constexpr std::size_t columns = 24;
  const double chord = 2 * std::sin(CGAL_PI / columns);
  const Is_on_rim is_on_rim{ height };
  const Mesh reference = make_mesh(can(480, 8, height));
  // turned by less than a column of the reference: no sample on its vertices
  const Mesh remesh = make_mesh(transformed(can(columns, rows, height), [](const Point& p) {
    const double c = std::cos(0.005), s = std::sin(0.005);
    return Point(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z());
  }));

  for(bool is_flat : { true, false })
  {
    auto optimize = [&](Mesh& mesh, bool relax) {
      const auto np = CGAL::parameters::edge_is_constrained_map(mark(mesh, is_on_rim)).relax_constraints(relax);
      if(is_flat)
        PMP::optimize_vertex_locations(mesh, PMP::Flat_triangle_surface<Mesh>(reference), np);
      else
        PMP::optimize_vertex_locations(mesh, reference, np);
    };
    Mesh fixed = remesh, relaxed = remesh;
    optimize(fixed, false);
    optimize(relaxed, true);
    for(Mesh::Vertex_index v : remesh.vertices())
      if(is_on_rim.is_on_rim(remesh.point(v)))
      {
        CHECK(fixed.point(v) == remesh.point(v));
        CHECK_NEAR(relaxed.point(v).z(), remesh.point(v).z(), 1e-3 * height);
      }
    if(!shortened)
      for(double z : { 0., height })
        check_fitted_circle(remesh, relaxed, chord, z);
  }
}

void test_borders()
{
  constexpr std::size_t columns = 24;
  const double chord = 2 * std::sin(CGAL_PI / columns);
  // rows of the same height on both: the borders are at the same heights
  const Mesh remesh = make_mesh(cylinder(columns, 6));
  const double height = remesh.point(*std::prev(remesh.vertices().end())).z();
  const Mesh reference = make_mesh(transformed(cylinder(480, 20), [&](const Point& p) {
    const double reference_height = 20 * 2 * CGAL_PI / 480 * std::sqrt(3.) / 2;
    return Point(p.x(), p.y(),
                 p.z() == 0                                       ? 0
                 : std::abs(p.z() / reference_height - 1) < 1e-12 ? height
                                                                  : p.z() / reference_height * height);
  }));
  Mesh fixed = remesh, relaxed = remesh;
  PMP::optimize_vertex_locations(fixed, reference);
  PMP::optimize_vertex_locations(relaxed, reference, CGAL::parameters::relax_constraints(true));
  for(Mesh::Vertex_index v : remesh.vertices())
    if(remesh.is_border(v))
      CHECK(fixed.point(v) == remesh.point(v));
  check_fitted_circle(remesh, relaxed, chord, 0);
  check_fitted_circle(remesh, relaxed, chord, height);

  start_topic("a pinned vertex of a border stays");
  Mesh pinned = remesh;
  auto is_pinned = pinned.add_property_map<Mesh::Vertex_index, bool>("v:is_pinned", false).first;
  const Mesh::Vertex_index v(0);
  is_pinned[v] = true;
  PMP::optimize_vertex_locations(pinned, reference,
                                 CGAL::parameters::vertex_is_constrained_map(is_pinned).relax_constraints(true));
  CHECK(pinned.point(v) == remesh.point(v));
  CHECK(relaxed.point(v) != remesh.point(v));
}

// All edges and corners of a cube are where they should be; so are its faces.
void test_cube()
{
  const Mesh reference = make_mesh(cube(0));
  const Mesh remesh = make_mesh(cube(3));
  Mesh mesh = remesh;
  PMP::optimize_vertex_locations(
    mesh, reference,
    CGAL::parameters::relax_constraints(true).edge_is_constrained_map(mark(mesh, [](const Point& p, const Point& q) {
      return (p.x() == q.x() && std::abs(p.x()) == 1) + (p.y() == q.y() && std::abs(p.y()) == 1) +
               (p.z() == q.z() && std::abs(p.z()) == 1) ==
             2;
    })));
  CHECK_AT_MOST(largest_distance(points_of(mesh), points_of(remesh)), 1e-12);
}

// Constrained edges that run along no crease of the reference hold their vertices; so do those that run beyond its end.
void test_edges_without_crease()
{
  const Mesh reference = make_mesh(icosphere(5)); // no crease at all
  Mesh remesh = make_mesh(transformed(icosphere(2), rotated));
  Mesh mesh = remesh;
  const Edge_map is_marked = mark(mesh, [](const Point& p, const Point& q) { return p.z() > 0 && q.z() > 0; });
  PMP::optimize_vertex_locations(mesh, reference,
                                 CGAL::parameters::edge_is_constrained_map(is_marked).relax_constraints(true));
  for(Mesh::Edge_index e : mesh.edges())
    if(is_marked[e])
      for(int k : { 0, 1 })
        CHECK(mesh.point(mesh.vertex(e, k)) == remesh.point(mesh.vertex(e, k)));

  // the reference has a crease only along half of the rim
  constexpr std::size_t columns = 24;
  Mesh part = make_mesh(can(480, 8, 1));
  const Is_on_rim is_on_rim{ 1 };
  const Edge_map is_crease =
    mark(part, [&](const Point& p, const Point& q) { return is_on_rim(p, q) && p.y() > 0 && q.y() > 0; });
  const Mesh coarse = make_mesh(can(columns, 4, 1));
  Mesh relaxed = coarse;
  PMP::optimize_vertex_locations(
    relaxed, PMP::Flat_triangle_surface<Mesh>(part, CGAL::parameters::edge_is_constrained_map(is_crease)),
    CGAL::parameters::edge_is_constrained_map(mark(relaxed, is_on_rim)).relax_constraints(true));
  const double chord = 2 * std::sin(CGAL_PI / columns);
  for(Mesh::Vertex_index v : coarse.vertices())
  {
    const Point p = coarse.point(v);
    if(!is_on_rim.is_on_rim(p))
      continue;
    if(p.y() < -0.01)
      CHECK(relaxed.point(v) == p);
    else if(p.y() > 2 * chord)
      CHECK_NEAR(radius(relaxed.point(v)) - 1, chord * chord / 12, 0.03 * chord * chord / 12);
  }
}

// Two spheres that touch in a vertex, of which each has a copy.
void test_coincident_vertices()
{
  start_topic("Copies of a vertex stay together");
  const auto add = [](Mesh& mesh, int level) {
    const Mesh sphere = make_mesh(icosphere(level));
    const Point touching = sphere.point(Mesh::Vertex_index(0));
    for(double sign : { -1., 1. })
    {
      Mesh copy = sphere;
      for(Point& p : copy.points())
        p = CGAL::ORIGIN + sign * (p - touching); // the touching vertex is the origin, exactly
      if(sign < 0)
        PMP::reverse_face_orientations(copy);
      mesh += copy;
    }
  };
  Mesh reference, mesh;
  add(reference, 4);
  add(mesh, 2);
  for(PMP::Placement_method method : { PMP::PIECEWISE_LINEAR, PMP::LEAST_SQUARES })
  {
    Mesh optimized = mesh;
    PMP::optimize_vertex_locations(optimized, reference, CGAL::parameters::placement_method(method));
    int number_of_copies = 0, number_of_moves = 0;
    for(Mesh::Vertex_index v : mesh.vertices())
      if(mesh.point(v) == CGAL::ORIGIN)
      {
        ++number_of_copies;
        CHECK(optimized.point(v) == CGAL::ORIGIN);
      }
      else
        number_of_moves += optimized.point(v) != mesh.point(v);
    CHECK_EQUAL(number_of_copies, 2);
    CHECK_AT_LEAST(number_of_moves, 200);
  }
}

// A rectangle, flat or curved, of which the remesh has cut off two corners: they come back if the border may move.
void test_cut_corners()
{
  constexpr std::size_t columns = 12, rows = 8;
  for(const double height : { 0., 0.4 })
  {
    start_topic("corners that the remesh cuts off come back, height " + std::to_string(height));
    const auto terrain = [&](std::size_t refinement) {
      return make_mesh(transformed(triangle_grid(refinement * columns, refinement * rows, false, 0), [&](const Point& p) {
        const double x = p.x() / refinement, y = p.y() / refinement;
        return Point(x, y,
                     height * std::exp(-((x - 6) * (x - 6) + (y - 4) * (y - 4)) / 8)); // the maximum error is not there
      }));
    };
    const Mesh reference = terrain(5);
    Mesh remesh = terrain(1);
    const std::vector<Mesh::Vertex_index> cut{ Mesh::Vertex_index(0), Mesh::Vertex_index(rows * (columns + 1)) };
    std::vector<Point> corners;
    for(const Mesh::Vertex_index v : cut)
    {
      corners.push_back(remesh.point(v));
      CHECK_EQUAL(remesh.degree(v), 2u);
      CGAL::Euler::remove_face(remesh.is_border(remesh.halfedge(v)) ? remesh.opposite(remesh.next(remesh.halfedge(v)))
                                                                    : remesh.halfedge(v),
                               remesh);
    }
    remesh.collect_garbage();
    const auto distance_of_corners = [&](const Mesh& mesh) {
      double largest = 0;
      for(const Point& corner : corners)
      {
        double nearest = HUGE_VAL;
        for(const Point& p : mesh.points())
          nearest = (std::min)(nearest, std::sqrt(CGAL::squared_distance(p, corner)));
        largest = (std::max)(largest, nearest);
      }
      return largest;
    };
    CHECK_LESS(0.9, distance_of_corners(remesh));
    for(const PMP::Placement_method method : { PMP::PIECEWISE_LINEAR, PMP::LEAST_SQUARES })
    {
      Mesh fixed = remesh, relaxed = remesh;
      PMP::optimize_vertex_locations(fixed, reference, CGAL::parameters::placement_method(method));
      PMP::optimize_vertex_locations(relaxed, reference, CGAL::parameters::placement_method(method).relax_constraints(true));
      CHECK_AT_LEAST(distance_of_corners(fixed), 0.9);
      CHECK_AT_MOST(distance_of_corners(relaxed), 1e-9);
      const auto largest_gap = [&](const Mesh& mesh) {
        return PMP::approximation_error(reference, PMP::Flat_triangle_surface<Mesh>(mesh)).max;
      };
      CHECK_LESS(0.65, largest_gap(remesh));
      CHECK_LESS(largest_gap(relaxed), 0.1);
      CHECK(!PMP::does_self_intersect(relaxed));
    }
  }

  start_topic("the corners of a cube come back");
  const Mesh reference = make_mesh(cube(0));
  const Mesh expected = make_mesh(cube(3));
  Mesh mesh = expected;
  const Edge_map is_crease = mark(mesh, [](const Point& p, const Point& q) {
    return (p.x() == q.x() && std::abs(p.x()) == 1) + (p.y() == q.y() && std::abs(p.y()) == 1) +
             (p.z() == q.z() && std::abs(p.z()) == 1) ==
           2;
  });
  mesh.point(Mesh::Vertex_index(0)) = mesh.point(Mesh::Vertex_index(0)) + Vector(0.08, 0.05, 0.06);
  PMP::optimize_vertex_locations(mesh, reference,
                                 CGAL::parameters::relax_constraints(true).edge_is_constrained_map(is_crease));
  CHECK_NEAR(std::sqrt(CGAL::squared_distance(mesh.point(Mesh::Vertex_index(0)), expected.point(Mesh::Vertex_index(0)))), 0,
             1e-12);
  CHECK_NEAR(PMP::approximation_error(mesh, reference).max, 0, 1e-9);
}

int main()
{
  start_topic("the rims of a can follow its circles");
  test_rims(1, 4, false);
  start_topic("the rims of a disk thinner than its edges do not jump to each other");
  test_rims(0.05, 1, true);
  start_topic("borders follow the border");
  test_borders();
  start_topic("a cube stays a cube");
  test_cube();
  start_topic("edges without a crease stay");
  test_edges_without_crease();
  test_coincident_vertices();
  test_cut_corners();
  return test_result();
}
