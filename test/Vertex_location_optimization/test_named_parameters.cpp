// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Each named parameter is read and does what it says.

#include "check.h"
#include "Exact_sphere.h"
#include "irregular_sphere.h"
#include "mesh_quality.h"
#include "test_visitors.h"

#include <CGAL/property_map.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <vector>

void test_defaults(const Input& input)
{
  start_topic("The documented defaults are those of the code");
  const std::vector<Point> expected = optimized(input.mesh, input.reference, parameters::default_values());
  auto is_default = [&](const auto& np1) { return optimized(input.mesh, input.reference, np1) == expected; };
  CHECK(is_default(parameters::number_of_iterations(30)));
  CHECK(is_default(parameters::number_of_free_iterations(20)));
  CHECK(is_default(parameters::convergence_threshold(1e-6)));
  CHECK(is_default(parameters::number_of_relaxation_steps(std::optional<std::size_t>())));
  CHECK(is_default(parameters::geom_traits(Kernel()))); // not documented, but CGAL's functions take it, and users give it
  CHECK(is_default(parameters::placement_method(PMP::PIECEWISE_LINEAR)));
  CHECK(is_default(parameters::relax_constraints(false)));
  CHECK(is_default(parameters::do_self_intersection_tests(false)));
  CHECK(is_default(parameters::visitor(PMP::Vertex_location_optimization_default_visitor())));
  CHECK(is_default(parameters::allow_move_functor([](Vertex, const Point&, const Point&) { return true; })));
  CHECK(is_default(parameters::vertex_is_constrained_map(CGAL::Constant_property_map<Vertex, bool>(false))));
  CHECK(is_default(parameters::edge_is_constrained_map(CGAL::Constant_property_map<Mesh::Edge_index, bool>(false))));
  Mesh mesh = input.mesh;
  PMP::optimize_vertex_locations(mesh, input.reference, parameters::vertex_point_map(get(CGAL::vertex_point, mesh)));
  CHECK(points_of(mesh) == expected);
  // of a regular mesh
  const Mesh regular = make_mesh(icosphere(3));
  CHECK(optimized(regular, input.reference, parameters::default_values()) ==
        optimized(regular, input.reference, parameters::number_of_relaxation_steps(1)));
  const auto least_squares = parameters::placement_method(PMP::LEAST_SQUARES);
  CHECK(optimized(input.mesh, input.reference, least_squares) ==
        optimized(input.mesh, input.reference, least_squares.regularity_weight(std::optional<double>())));
  CHECK(optimized(regular, input.reference, least_squares) ==
        optimized(regular, input.reference, least_squares.regularity_weight(0.19).do_self_intersection_tests(true)));
  CHECK(optimized(input.mesh, input.reference, parameters::default_values(), parameters::sharpness_angle(40)) == expected);
  CHECK(optimized(input.mesh, input.reference, parameters::default_values(),
                  parameters::vertex_point_map(input.reference.points())) == expected);
}

void test_numbers(const Input& input)
{
  start_topic("number_of_iterations");
  Mesh mesh = input.mesh;
  Report report = PMP::optimize_vertex_locations(mesh, input.reference, parameters::number_of_iterations(0));
  CHECK_EQUAL(report.iterations, 0u);
  CHECK(!report.converged);
  CHECK_EQUAL(report.displacement, 0);
  CHECK(points_of(mesh) == points_of(input.mesh));
  report = PMP::optimize_vertex_locations(mesh, input.reference, parameters::number_of_iterations(5));
  CHECK_EQUAL(report.iterations, 5u);
  CHECK(!report.converged);
  CHECK_LESS(0, report.displacement);
  CHECK_LESS(report.displacement, 0.1);

  start_topic("displacement is that of the last iteration");
  Counting_visitor visitor(4 * 4); // which stops before the fifth iteration
  const std::vector<Point> after_4 = optimized(input.mesh, input.reference, parameters::visitor(std::ref(visitor)));
  CHECK_NEAR(report.displacement, largest_distance(after_4, points_of(mesh)), 1e-12);

  start_topic("convergence_threshold, relative to the lengths of the edges");
  double shortest = (std::numeric_limits<double>::max)(), longest = 0;
  for(Mesh::Edge_index e : input.mesh.edges())
  {
    const double length = norm(input.mesh.point(input.mesh.vertex(e, 0)) - input.mesh.point(input.mesh.vertex(e, 1)));
    shortest = (std::min)(shortest, length);
    longest = (std::max)(longest, length);
  }
  for(double threshold : { 1e-1, 1e-2, 1e-3 })
  {
    mesh = input.mesh;
    report = PMP::optimize_vertex_locations(mesh, input.reference, parameters::convergence_threshold(threshold));
    CHECK(report.converged);
    CHECK_AT_MOST(report.displacement, threshold * longest);
    CHECK_LESS(report.iterations, 30u);
    if(report.iterations > 2) // two iterations before it was not good enough
    {
      mesh = input.mesh;
      const Report previous = PMP::optimize_vertex_locations(
        mesh, input.reference, parameters::convergence_threshold(threshold).number_of_iterations(report.iterations - 2));
      CHECK(!previous.converged);
      CHECK_LESS(threshold * shortest, previous.displacement);
    }
  }

  start_topic(
    "convergence_threshold of LEAST_SQUARES: the smaller, the more iterations; by default the error is at its end");
  const auto least_squares = parameters::placement_method(PMP::LEAST_SQUARES);
  std::size_t last = 1;
  for(double threshold : { 1e-1, 1e-2, 1e-3, 0. })
  {
    mesh = input.mesh;
    report = PMP::optimize_vertex_locations(mesh, input.reference, least_squares.convergence_threshold(threshold));
    CHECK_EQUAL(report.converged, threshold > 0);
    CHECK_AT_MOST(last, report.iterations);
    last = report.iterations;
  }
  const double error = report.final_error.mean;
  mesh = input.mesh;
  report = PMP::optimize_vertex_locations(mesh, input.reference, least_squares);
  CHECK(report.converged);
  CHECK_LESS(report.iterations, 30u);
  CHECK_AT_MOST(report.final_error.mean, 1.02 * error);
}

void test_regularity(const Input& input)
{
  start_topic("number_of_relaxation_steps: springs make triangles more regular");
  auto angle_with = [&](unsigned int steps) {
    Mesh relaxed = input.mesh;
    PMP::optimize_vertex_locations(relaxed, input.reference, parameters::number_of_relaxation_steps(steps));
    return mean_min_angle(relaxed);
  };
  const double without = angle_with(0), with_one = angle_with(1), with_three = angle_with(3);
  CHECK_LESS(without, with_one);
  CHECK_LESS(with_one, with_three);

  start_topic("number_of_free_iterations: then vertices move along the normal only");
  const Exact_sphere sphere(CGAL::ORIGIN, 1);
  auto turn = [&](unsigned int free_iterations) {
    const std::vector<Point> points =
      optimized(input.mesh, sphere, parameters::number_of_free_iterations(free_iterations).number_of_relaxation_steps(0));
    double largest = 0;
    for(Vertex v : input.mesh.vertices())
      largest = (std::max)(largest, norm(unit(points[v] - CGAL::ORIGIN) - unit(input.mesh.point(v) - CGAL::ORIGIN)));
    return largest;
  };
  CHECK_AT_MOST(turn(0), 1e-12);
  CHECK_AT_LEAST(turn(20), 1e-2);
  CHECK(optimized(input.mesh, input.reference, parameters::number_of_free_iterations(5)) !=
        optimized(input.mesh, input.reference, parameters::default_values()));
}

void test_chaining(const Input& input)
{
  start_topic("The names in any order");
  const auto all = [&](const auto& np1) { return optimized(input.mesh, input.reference, np1); };
  const std::vector<Point> expected =
    all(parameters::number_of_free_iterations(5).convergence_threshold(1e-3).number_of_iterations(10));
  CHECK(all(parameters::convergence_threshold(1e-3).number_of_free_iterations(5).number_of_iterations(10)) == expected);
  CHECK(all(parameters::convergence_threshold(1e-3)
              .number_of_free_iterations(5)
              .number_of_iterations(10)
              .relax_constraints(false)
              .geom_traits(Kernel())) == expected);
  CHECK(all(parameters::number_of_iterations(10).number_of_free_iterations(5).convergence_threshold(1e-3)) == expected);
  CHECK(
    all(parameters::relax_constraints(false).convergence_threshold(1e-3).number_of_iterations(10).number_of_free_iterations(
      5)) == expected);
  CHECK(expected != all(parameters::number_of_iterations(10)));
  CHECK(expected != all(parameters::number_of_free_iterations(5).convergence_threshold(1e-1).number_of_iterations(10)));
  CHECK(expected != all(parameters::number_of_free_iterations(5).convergence_threshold(1e-3).number_of_iterations(3)));
}

void test_vertex_point_map(const Input& input)
{
  start_topic("vertex_point_map");
  Mesh mesh = input.mesh;
  const std::vector<Point> expected = optimized(mesh, input.reference, parameters::default_values());

  // the points are elsewhere, and those of the meshes themselves make no sense
  using Other_point = CGAL::Simple_cartesian<double>::Point_3;
  auto points = mesh.add_property_map<Vertex, Other_point>("v:other").first;
  std::map<Vertex, Point> reference_points;
  for(Vertex v : mesh.vertices())
  {
    points[v] = Other_point(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
    mesh.point(v) = Point(v, 1, 2);
  }
  Mesh reference = input.reference;
  for(Vertex v : reference.vertices())
  {
    reference_points[v] = reference.point(v);
    reference.point(v) = Point(0, 0, v);
  }
  const std::vector<Point> own_points = points_of(mesh);
  PMP::optimize_vertex_locations(mesh, reference, parameters::vertex_point_map(points),
                                 parameters::vertex_point_map(boost::make_assoc_property_map(reference_points)));
  CHECK(points_of(mesh) == own_points);
  for(Vertex v : mesh.vertices())
    CHECK(Point(points[v].x(), points[v].y(), points[v].z()) == expected[v]);
}

void test_constraints(const Input& input)
{
  start_topic("Constrained vertices, the ends of constrained edges and the border stay, bit for bit");
  Mesh mesh = input.mesh;
  auto vertex_is_constrained = mesh.add_property_map<Vertex, bool>("constrained", false).first;
  auto edge_is_constrained = mesh.add_property_map<Mesh::Edge_index, bool>("constrained", false).first;
  std::set<Vertex> by_vertex, by_edge, by_border;
  CGAL::Random random(11);
  for(Vertex v : mesh.vertices())
    if(random.get_int(0, 8) == 0)
    {
      vertex_is_constrained[v] = true;
      by_vertex.insert(v);
    }
  for(Mesh::Edge_index e : mesh.edges())
    if(random.get_int(0, 20) == 0)
    {
      edge_is_constrained[e] = true;
      by_edge.insert({ mesh.vertex(e, 0), mesh.vertex(e, 1) });
    }
  auto stay = [](const std::vector<Point>& before, const std::vector<Point>& after, const std::set<Vertex>& fixed) {
    // all of them and, as nothing on a curved surface keeps the others, no others
    bool ok = true;
    for(std::size_t i = 0; i < before.size(); ++i)
      ok = ok && (before[i] == after[i]) == (fixed.count(Vertex(i)) != 0);
    return ok;
  };
  const std::vector<Point> before = points_of(mesh);
  CHECK(stay(before, optimized(mesh, input.reference, parameters::default_values()), {}));
  CHECK(
    stay(before, optimized(mesh, input.reference, parameters::vertex_is_constrained_map(vertex_is_constrained)), by_vertex));
  CHECK(stay(before, optimized(mesh, input.reference, parameters::edge_is_constrained_map(edge_is_constrained)), by_edge));
  std::set<Vertex> both = by_vertex;
  both.insert(by_edge.begin(), by_edge.end());
  CHECK(stay(
    before,
    optimized(mesh, input.reference,
              parameters::vertex_is_constrained_map(vertex_is_constrained).edge_is_constrained_map(edge_is_constrained)),
    both));

  for(int i = 0; i < 3; ++i)
    CGAL::Euler::remove_face(mesh.halfedge(Mesh::Face_index(50 * i)), mesh);
  for(Vertex v : mesh.vertices())
    if(mesh.is_border(v))
      by_border.insert(v);
  CHECK_EQUAL(by_border.size(), 9u);
  CHECK(stay(before, optimized(mesh, input.reference, parameters::default_values()), by_border));
}

void test_allow_move_functor(const Input& input)
{
  start_topic("allow_move_functor");
  Mesh mesh = input.mesh;
  const std::vector<Point> before = points_of(mesh);
  std::map<Vertex, Point> last_targets;
  std::set<Vertex> refused;
  int wrong_sources = 0;
  auto functor = [&](Vertex v, const Point& source, const Point& target) {
    wrong_sources += source != before[v] || source == target;
    if(v % 3 == 0)
    {
      refused.insert(v);
      return false;
    }
    last_targets[v] = target;
    return true;
  };
  PMP::optimize_vertex_locations(mesh, input.reference, parameters::number_of_iterations(1).allow_move_functor(functor));
  CHECK_EQUAL(wrong_sources, 0);
  CHECK_EQUAL(refused.size(), (before.size() + 2) / 3);
  for(Vertex v : mesh.vertices())
    CHECK(mesh.point(v) == (v % 3 == 0 ? before[v] : last_targets[v]));

  // limits on how far a vertex goes are kept through all iterations
  mesh = input.mesh;
  constexpr double limit = 0.01;
  auto is_near = [&](Vertex v, const Point&, const Point& target) {
    return CGAL::squared_distance(before[v], target) <= limit * limit;
  };
  PMP::optimize_vertex_locations(mesh, input.reference, parameters::allow_move_functor(is_near));
  CHECK_AT_MOST(largest_distance(points_of(mesh), before), limit * (1 + 1e-12));
  CHECK_AT_LEAST(largest_distance(points_of(mesh), before), limit / 2);
  CHECK_AT_LEAST(largest_distance(optimized(input.mesh, input.reference, parameters::default_values()), before), limit);
}

void test_reference_parameters(const Input& input)
{
  start_topic("np2: creases");
  Mesh reference = make_mesh(cube(2));
  auto none = reference.add_property_map<Mesh::Edge_index, bool>("none", false).first;
  auto all = reference.add_property_map<Mesh::Edge_index, bool>("all", true).first;
  const auto on_cube = [&](const auto& np2) {
    return optimized(input.mesh, reference, parameters::number_of_iterations(3), np2);
  };
  const std::vector<Point> with_creases = on_cube(parameters::default_values());
  CHECK(on_cube(parameters::sharpness_angle(89)) == with_creases);
  CHECK(on_cube(parameters::sharpness_angle(91)) != with_creases);
  CHECK(on_cube(parameters::edge_is_constrained_map(none)) == on_cube(parameters::sharpness_angle(91)));
  CHECK_AT_MOST(largest_distance(on_cube(parameters::edge_is_constrained_map(all)), with_creases), 1e-9);

  start_topic("A surface made once gives the same results as the mesh, as often as one likes");
  const std::vector<Point> expected = optimized(input.mesh, input.reference, parameters::default_values());
  const PMP::PN_triangle_surface<Mesh> surface(input.reference);
  for(int i = 0; i < 3; ++i)
  {
    Mesh mesh = input.mesh;
    PMP::optimize_vertex_locations(mesh, surface);
    CHECK(points_of(mesh) == expected);
    PMP::optimize_vertex_locations(mesh, surface, parameters::number_of_iterations(1)); // another mesh in between
  }
  const PMP::PN_triangle_surface<Mesh> cube_surface(reference, parameters::sharpness_angle(91));
  Mesh mesh = input.mesh;
  PMP::optimize_vertex_locations(mesh, cube_surface, parameters::number_of_iterations(3));
  CHECK(points_of(mesh) == on_cube(parameters::sharpness_angle(91)));
}

int main()
{
  const Input input;
  test_defaults(input);
  test_numbers(input);
  test_regularity(input);
  test_chaining(input);
  test_vertex_point_map(input);
  test_constraints(input);
  test_allow_move_functor(input);
  test_visitor(input);
  test_cancelling(input);
  test_reference_parameters(input);
  return test_result();
}
