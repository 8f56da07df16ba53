// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Input that nobody wants. Violated preconditions are found where CGAL's checks are on; where they are off the mesh is
// left as it is. All else must work: it is compiled both ways.

#include "check.h"
#include "check_violation.h"
#include "invalid_input.h"
#include "mesh_quality.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/attribute_error.h>
#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_attributes.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Polygon_mesh_processing/remesh_within_tolerance.h>
#include <CGAL/Polygon_mesh_processing/transfer_face_attributes.h>

#include <CGAL/assertions_behaviour.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace PMP = CGAL::Polygon_mesh_processing;
using Report = PMP::Vertex_location_optimization_report;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;

const Mesh sphere = make_mesh(transformed(icosphere(2), rotated)), reference = make_mesh(icosphere(3)), empty;

void test_refused()
{
  start_topic("An empty remesh or reference");
  check_finite(empty, reference);
  check_finite(empty, empty);
  check_refused(sphere, empty);
  check_refused(sphere, PMP::PN_triangle_surface<Mesh>(empty));
  check_refused(sphere, PMP::Flat_triangle_surface<Mesh>(empty));

  start_topic("Faces that are no polygons");
  for(const Mesh& invalid : with_invalid_faces(sphere))
  {
    check_refused(invalid, reference);
    check_refused(sphere, invalid);
    CHECK_EQUAL(violates_precondition([&] { PMP::Flat_triangle_surface<Mesh> surface(invalid); }), checks_are_on);
  }

  for(double bad : { std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, -HUGE_VAL })
    for(int k = 0; k < 3; ++k)
    {
      start_topic("A coordinate that is " + std::to_string(bad));
      Mesh mesh = sphere;
      mesh.point(Vertex(10)) = Point(k == 0 ? bad : 1, k == 1 ? bad : 0, k == 2 ? bad : 0);
      check_refused(mesh, reference);
      check_refused(sphere, mesh);
      Mesh with_isolated_vertex = sphere;
      with_isolated_vertex.add_vertex(mesh.point(Vertex(10)));
      check_refused(with_isolated_vertex, reference);
    }
}

void test_degenerate_faces()
{
  start_topic("Degenerate faces");
  check_sane(with_degenerate_faces(sphere), reference);
  check_sane(sphere, with_degenerate_faces(reference));
  check_sane(with_degenerate_faces(sphere), with_degenerate_faces(reference));
  check_sane(with_degenerate_faces(sphere), PMP::Flat_triangle_surface<Mesh>(with_degenerate_faces(reference)));

  start_topic("No face has an area");
  const Mesh point = make_mesh(transformed(icosphere(1), [](const Point&) { return Point(1, 0, 0); }));
  const Mesh line = make_mesh(transformed(icosphere(1), [](const Point& p) { return Point(p.x(), 0, 0); }));
  CHECK_AT_MOST(largest_distance(check_sane(point, reference), points_of(point)), 1e-12);
  check_finite(line, reference);
  check_finite(sphere, point);
  check_finite(sphere, line);
  check_finite(point, line);
  check_finite(line, point);

  start_topic("Duplicate points");
  const Soup cut = icosphere(2); // each triangle by itself
  Soup pieces;
  for(const auto& triangle : cut.triangles)
  {
    for(std::size_t i : triangle)
      pieces.points.push_back(cut.points[i]);
    const std::size_t n = pieces.points.size();
    pieces.triangles.push_back({ n - 3, n - 2, n - 1 });
  }
  CHECK(check_sane(make_mesh(pieces), reference) == pieces.points); // all is border
  check_sane(sphere, make_mesh(pieces));
  Mesh folded = sphere; // a vertex on a neighbor's neighbor
  folded.point(Vertex(30)) = folded.point(folded.target(folded.next(folded.opposite(folded.halfedge(Vertex(30))))));
  check_sane(folded, reference);
}

// a mesh and a copy of it beside
Mesh copied(const Mesh& mesh)
{
  Mesh both = mesh, copy = mesh;
  for(Point& p : copy.points())
    p = p + Vector(0, 0, 4);
  both += copy;
  return both;
}

void test_components()
{
  const std::vector<Point> expected = check_sane(sphere, reference);

  start_topic("Isolated vertices");
  Mesh mesh = sphere;
  mesh.add_vertex(Point(0.5, 0, 0));
  mesh.add_vertex(Point(0, 0, 0));
  std::vector<Point> result = check_sane(mesh, reference);
  CHECK_EQUAL(result[result.size() - 2], Point(0.5, 0, 0));
  CHECK_EQUAL(result.back(), Point(0, 0, 0));
  Mesh reference_with_isolated_vertex = reference;
  reference_with_isolated_vertex.add_vertex(Point(1.1, 0, 0));
  CHECK_AT_MOST(largest_distance(check_sane(sphere, reference_with_isolated_vertex), expected), 1e-12);
  Mesh only_vertices;
  only_vertices.add_vertex(Point(0.5, 0, 0));
  only_vertices.add_vertex(Point(0.7, 0, 0));
  CHECK(check_finite(only_vertices, reference) == points_of(only_vertices));
  check_refused(sphere, only_vertices);

  start_topic("Several components are optimized each by itself");
  result = check_sane(copied(sphere), copied(reference));
  for(std::size_t i = 0; i < expected.size(); ++i)
  {
    CHECK_AT_MOST(norm(result[i] - expected[i]), 1e-9);
    CHECK_AT_MOST(norm(result[i + expected.size()] - (expected[i] + Vector(0, 0, 4))), 1e-9);
  }
}

void test_odd_connectivity()
{
  start_topic("Non-manifold vertices");
  Mesh pinched = copied(sphere); // two spheres with one vertex in common
  const Vertex kept(0), lost(static_cast<Mesh::size_type>(sphere.number_of_vertices()));
  for(Halfedge h : CGAL::halfedges_around_target(lost, pinched))
    pinched.set_target(h, kept);
  check_finite(pinched, copied(reference));
  check_finite(copied(sphere), pinched);
  Soup fans{ { { 0, 0, 0 }, { 1, 0, 0.1 }, { 1, 1, 0 }, { 0, 1, 0.1 }, { -1, 0, 0.1 }, { -1, -1, 0 }, { 0, -1, 0.1 } },
             { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 4, 5 }, { 0, 5, 6 } } };
  check_finite(make_mesh(fans), reference);
  check_finite(sphere, make_mesh(subdivide(subdivide(fans))));
  check_sane(make_mesh(subdivide(subdivide(fans))), make_mesh(fans));

  start_topic("A reference of one triangle");
  const Soup triangle{ { { 0, 0, 1 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } } };
  check_finite(sphere, make_mesh(triangle));
  check_finite(sphere, PMP::Flat_triangle_surface<Mesh>(make_mesh(triangle)));
  check_finite(make_mesh(triangle), reference);
  Mesh tetrahedron;
  CGAL::make_tetrahedron(Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), Point(0, 0, 0), tetrahedron);
  check_finite(tetrahedron, tetrahedron);
  check_finite(tetrahedron, reference);
}

void test_scales()
{
  start_topic("Huge and tiny coordinates");
  const Mesh small_sphere = make_mesh(transformed(icosphere(1), rotated)), small_reference = make_mesh(icosphere(1));
  for(double scale : { 1e-300, 1e-200, 1e-160, 1e-100, 1e100, 1e153, 1e160, 1e200, 1e300 })
  {
    check_finite(scaled(small_sphere, scale), scaled(small_reference, scale));
    check_finite(scaled(small_sphere, scale), PMP::Flat_triangle_surface<Mesh>(scaled(small_reference, scale)));
    check_finite(scaled(small_sphere, scale), small_reference);
    check_finite(small_sphere, scaled(small_reference, scale));
  }
}

using Vertex_values = Mesh::Property_map<Vertex, double>;
using Face_values = Mesh::Property_map<Mesh::Face_index, int>;

template <typename Reference>
void check_attributes_refused(Mesh mesh, const Reference& reference, Vertex_values values, Face_values labels)
{
  const Vertex_values result = mesh.add_property_map<Vertex, double>("v:result", 7).first;
  const Face_values face_result = mesh.add_property_map<Mesh::Face_index, int>("f:result", 7).first;
  check_violation([&] { PMP::optimize_vertex_attributes(mesh, reference, values, result); });
  check_violation([&] { PMP::transfer_face_attributes(mesh, reference, labels, face_result); });
  check_violation([&] { CHECK_EQUAL(PMP::attribute_error(mesh, reference, values, result).mean, HUGE_VAL); });
  CHECK(std::all_of(mesh.vertices().begin(), mesh.vertices().end(), [&](Vertex v) { return result[v] == 7; }));
  CHECK(std::all_of(mesh.faces().begin(), mesh.faces().end(), [&](Mesh::Face_index f) { return face_result[f] == 7; }));
}

void test_attributes_refused()
{
  start_topic("Attributes that are refused");
  Mesh mesh = make_mesh(transformed(icosphere(1), rotated)), reference = make_mesh(icosphere(2)),
       small = make_mesh(icosphere(0)), without_faces;
  const auto add_values = [](Mesh& m) { return m.add_property_map<Vertex, double>("v:value", 1).first; };
  const auto add_labels = [](Mesh& m) { return m.add_property_map<Mesh::Face_index, int>("f:label", 1).first; };
  const Vertex_values values = add_values(reference);
  const Face_values labels = add_labels(reference);
  check_attributes_refused(mesh, without_faces, add_values(without_faces), add_labels(without_faces));
  check_attributes_refused(mesh, PMP::PN_triangle_surface<Mesh>(without_faces), add_values(without_faces),
                           add_labels(without_faces));
  check_attributes_refused(mesh, reference, add_values(small), add_labels(small)); // maps of another mesh
  check_attributes_refused(mesh, reference, Vertex_values(), Face_values());
  check_attributes_refused(mesh, PMP::Flat_triangle_surface<Mesh>(reference), add_values(small), add_labels(small));
  for(Mesh invalid : with_invalid_faces(mesh))
  {
    check_attributes_refused(invalid, reference, values, labels);
    check_attributes_refused(mesh, invalid, add_values(invalid), add_labels(invalid));
  }
  Mesh without_point = mesh;
  without_point.point(Vertex(3)) = Point(HUGE_VAL, 0, 0);
  check_attributes_refused(without_point, reference, values, labels);

  // values to be written to a map of another mesh, and values that are not finite
  const Vertex_values of_small = add_values(small);
  const Face_values labels_of_small = add_labels(small);
  check_violation([&] { PMP::optimize_vertex_attributes(mesh, reference, values, of_small); });
  check_violation([&] { PMP::transfer_face_attributes(mesh, reference, labels, labels_of_small); });
  check_violation([&] { PMP::attribute_error(mesh, reference, values, of_small); });
  const Vertex_values result = add_values(mesh);
  for(double bad : { std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, -HUGE_VAL })
  {
    values[Vertex(40)] = bad;
    check_violation([&] { PMP::optimize_vertex_attributes(mesh, reference, values, result); });
    check_violation([&] { PMP::attribute_error(mesh, reference, values, result); });
    values[Vertex(40)] = 1;
    CHECK_EQUAL(result[Vertex(0)], 1);
    result[Vertex(5)] = bad;
    check_violation([&] { PMP::attribute_error(mesh, reference, values, result); });
    result[Vertex(5)] = 1;
  }
}

void check_tolerance_refused(const Mesh& input, double tolerance, double precision = 0.02)
{
  Mesh result = sphere;
  check_violation([&] {
    const PMP::Tolerance_report report =
      PMP::remesh_within_tolerance(input, tolerance, result, CGAL::parameters::edge_length_precision(precision));
    CHECK_EQUAL(report.number_of_remeshings, 0u);
    CHECK(!report.is_within_tolerance);
  });
  CHECK(are_same(points_of(result), points_of(sphere)));
}

void test_tolerances_refused()
{
  start_topic("Tolerances and meshes that cannot be remeshed within them");
  for(double bad : { 0., -1., std::numeric_limits<double>::quiet_NaN(), HUGE_VAL })
  {
    check_tolerance_refused(reference, bad);
    check_tolerance_refused(reference, 0.01, bad);
  }
  check_tolerance_refused(empty, 0.01);
  check_tolerance_refused(make_mesh(transformed(icosphere(1), [](const Point&) { return Point(1, 0, 0); })), 0.01);
  Mesh quads = sphere;
  CGAL::Euler::join_face(quads.halfedge(Mesh::Edge_index(5)), quads);
  check_tolerance_refused(quads, 0.01);
  Mesh infinite = sphere;
  infinite.point(Vertex(10)) = Point(HUGE_VAL, 0, 0);
  check_tolerance_refused(infinite, 0.01);
}

int main()
{
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {}); // no words, only exceptions
  test_refused();
  test_degenerate_faces();
  test_components();
  test_odd_connectivity();
  test_scales();
  test_attributes_refused();
  test_tolerances_refused();
  return test_result();
}
