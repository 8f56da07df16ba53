// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the least squares placement is for: it agrees with the paper's method where that is exact, finds creases that nobody
// has marked and tips that the remesh has cut off, and trades error for regularity.

#include "check.h"
#include "Distance_to_mesh.h"
#include "Exact_sphere.h"
#include "invariants.h"
#include "mesh_quality.h"
#include "remeshes.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <array>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::parameters;
using Flat_surface = PMP::Flat_triangle_surface<Mesh>;

template <typename NamedParameters>
Mesh optimized_with(Mesh mesh, const Mesh& reference, const NamedParameters& np)
{
  const Mesh before = mesh;
  PMP::optimize_vertex_locations(mesh, Flat_surface(reference), np);
  check_invariants(before, mesh);
  return mesh;
}

Mesh optimized(const Mesh& mesh, const Mesh& reference, PMP::Placement_method method)
{
  return optimized_with(mesh, reference, params::placement_method(method));
}

// By how much the vertices of equilateral triangles with sides h, inscribed in a unit sphere, are to move, in units of
// h^2 / 8: where the samples at the vertices, midpoints and barycenters, at the distances 0, 1 and 4/3, balance each other.
double balanced_distance(double h)
{
  auto pull = [&](double residual) { return residual / std::sqrt(0.001 * (8 / h) + std::abs(residual)); };
  double low = 0, high = 4 / 3.;
  while(high - low > 1e-9)
  {
    const double t = (low + high) / 2;
    (pull(t) * 3 / 20 + pull(t - 1) * 2 / 5 + pull(t - 4 / 3.) * 9 / 20 < 0 ? low : high) = t;
  }
  return low;
}

// The mean distance then, in the same units: of t - 4/3 (1 - 3 (rho / h)^2) at the distance rho from the barycenter.
double balanced_mean(double t)
{
  const double squared_radius = (1 - 0.75 * t) / 3; // of the disk in which it is negative, relative to h^2
  return t - 1 + 16 * CGAL_PI / std::sqrt(3.) * squared_radius * squared_radius;
}

void test_sphere()
{
  start_topic("A sphere of radius r: vertices move by some 1.05 h^2 / 8r, the mean error falls to less than a fifth");
  Mesh mesh = make_mesh(icosphere(4));
  const double area = 4 * CGAL_PI / static_cast<double>(num_faces(mesh));
  const double t = balanced_distance(std::sqrt(area * 4 / std::sqrt(3.)));
  auto distance = [](const Point& p) { return std::abs(norm(p - CGAL::ORIGIN) - 1); };
  const Errors before = measure_errors(mesh, 8, distance);

  // a model of the concept, of which no samples can be taken
  PMP::optimize_vertex_locations(mesh, Exact_sphere(CGAL::ORIGIN, 1), params::placement_method(PMP::LEAST_SQUARES));
  auto is_regular = [&](Mesh::Vertex_index v) { return mesh.degree(v) == 6; };
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    const auto neighbors = CGAL::vertices_around_target(v, mesh);
    if(is_regular(v) && std::all_of(neighbors.begin(), neighbors.end(), is_regular))
      CHECK_NEAR((norm(mesh.point(v) - CGAL::ORIGIN) - 1) / (mean_squared_length_around(mesh, v) / 8), t, 0.04);
  }
  CHECK_NEAR(measure_errors(mesh, 8, distance).mean / before.mean, balanced_mean(t), 0.01);
}

void test_unmarked_creases()
{
  start_topic("A cube gets its edges and corners back, although no vertex was on them and no edge is constrained");
  const Mesh reference = make_mesh(cube(0));
  const Mesh remesh = make_mesh(transformed(icosphere(4), [](const Point& p) {
    const Point q = rotated(p);
    return CGAL::ORIGIN + (q - CGAL::ORIGIN) / (std::max)({ std::abs(q.x()), std::abs(q.y()), std::abs(q.z()) });
  }));
  const Distance_to_mesh distance(reference);
  const double before = measure_errors(remesh, 6, distance).mean;
  const double paper = measure_errors(optimized(remesh, reference, PMP::PIECEWISE_LINEAR), 6, distance).mean;
  const double least_squares = measure_errors(optimized(remesh, reference, PMP::LEAST_SQUARES), 6, distance).mean;
  CHECK_AT_MOST(least_squares, 0.05 * before);
  CHECK_AT_MOST(least_squares, 0.3 * paper);
}

void test_tip()
{
  start_topic("A tip that the remesh has cut off comes back");
  auto with_tip = [](const Point& p) {
    const Vector n = unit(p - CGAL::ORIGIN);
    return CGAL::ORIGIN + (1 + std::exp(-60 * (1 - n.z()))) * n;
  };
  const Mesh reference = make_mesh(transformed(icosphere(5), with_tip));
  const Mesh remesh = make_mesh(transformed(icosphere(3), [&](const Point& p) { return with_tip(rotated(p)); }));
  auto largest_distance_back = [&](const Mesh& mesh) {
    const Distance_to_mesh distance(mesh);
    double largest = 0;
    for(const Point& p : reference.points())
      largest = (std::max)(largest, distance(p));
    return largest;
  };
  const double before = largest_distance_back(remesh);
  const double paper = largest_distance_back(optimized(remesh, reference, PMP::PIECEWISE_LINEAR));
  const double least_squares = largest_distance_back(optimized(remesh, reference, PMP::LEAST_SQUARES));
  CHECK_AT_MOST(least_squares, 0.4 * before);
  CHECK_AT_MOST(least_squares, 0.7 * paper);
}

void test_regularity_weight()
{
  start_topic("The larger the weight, the larger the angles and the error");
  CGAL::Random random(11);
  auto bumpy = [](const Vector& n) { return CGAL::ORIGIN + (1 + 0.1 * std::sin(5 * n.x()) * std::sin(4 * n.y())) * n; };
  const Mesh reference = make_mesh(transformed(icosphere(5), [&](const Point& p) { return bumpy(unit(p - CGAL::ORIGIN)); }));
  const Mesh remesh = make_mesh(transformed(icosphere(3), [&](const Point& p) {
    auto moved = [&](double x) { return x + random.get_double(-.04, .04); };
    const double x = moved(p.x()), y = moved(p.y());
    return bumpy(unit(Vector(x, y, moved(p.z()))));
  }));
  const Distance_to_mesh distance(reference);
  double last_error = 0, last_angle = 0;
  for(double weight : { 0.0125, 0.1, 0.8 })
  {
    const Mesh mesh =
      optimized_with(remesh, reference, params::placement_method(PMP::LEAST_SQUARES).regularity_weight(weight));
    const double error = measure_errors(mesh, 6, distance).mean, angle = mean_min_angle(mesh);
    CHECK_LESS(last_error, error);
    CHECK_LESS(last_angle, angle);
    last_error = error;
    last_angle = angle;
  }
}

// The weight of a call is that of the next, and no sample is lost on the way: what creases and folded parts can gain is
// gained.
void test_one_call_at_creases()
{
  start_topic("One call reaches what an unmarked crease can gain");
  const Mesh reference = read_model("fandisk");
  const Mesh remesh = make_remesh(reference, 0.0366); // 2000 vertices
  const Mesh mesh = optimized(remesh, reference, PMP::LEAST_SQUARES);
  CHECK_AT_MOST(measure_errors(mesh, 6, Distance_to_mesh(reference)).mean, 0.62e-4 * longest_side(reference));
  CHECK_AT_LEAST(mean_min_angle(mesh), 49.4);
}

// CGAL's default simplification, which has small errors and anisotropic faces already
Mesh simplified(Mesh mesh, std::size_t number_of_edges)
{
  CGAL::Surface_mesh_simplification::edge_collapse(
    mesh, [&](const auto&, const auto&, std::size_t, std::size_t number) { return number < number_of_edges; });
  mesh.collect_garbage();
  return mesh;
}

void test_simplified_meshes()
{
  start_topic("A simplified mesh gains, and its angles get no worse");
  for(const char* name : { "bunny00", "refined_elephant" })
  {
    const Mesh reference = read_model(name);
    const Mesh remesh = simplified(reference, 6000); // of 2000 vertices
    const Distance_to_mesh distance(reference);
    const Mesh mesh = optimized(remesh, reference, PMP::LEAST_SQUARES);
    CHECK_AT_MOST(measure_errors(mesh, 4, distance).mean, 0.95 * measure_errors(remesh, 4, distance).mean);
    CHECK_AT_LEAST(mean_min_angle(mesh), mean_min_angle(remesh));
  }
}

void test_too_large_weight()
{
  start_topic("Where the weight is too large for any gain, a smaller one is tried");
  const Mesh reference = read_model("bunny00");
  const Mesh remesh = simplified(reference, 1500); // of 500 vertices
  const Distance_to_mesh distance(reference);
  const double before = measure_errors(remesh, 4, distance).mean;
  for(double weight : { 0.2, 0.8 })
  {
    const Mesh mesh =
      optimized_with(remesh, reference, params::placement_method(PMP::LEAST_SQUARES).regularity_weight(weight));
    CHECK_AT_MOST(measure_errors(mesh, 4, distance).mean, 0.95 * before);
  }
}

void test_one_call()
{
  start_topic("One call is at its end: four more gain little");
  const Mesh reference = read_model("bunny00");
  const Mesh remesh = make_remesh(reference, 0.04); // 2000 vertices
  const Distance_to_mesh distance(reference);
  const Mesh mesh = optimized(remesh, reference, PMP::LEAST_SQUARES);
  Mesh again = mesh;
  for(int call = 0; call < 4; ++call)
    again = optimized(again, reference, PMP::LEAST_SQUARES);
  const double error = measure_errors(mesh, 4, distance).mean;
  CHECK_AT_MOST(error, 0.365 * measure_errors(remesh, 4, distance).mean);
  CHECK_AT_MOST(error, 1.06 * measure_errors(again, 4, distance).mean);
}

void test_planes()
{
  start_topic("A planar mesh stays in its plane, its border where it is");
  const Mesh plane = make_mesh(transformed(planar_patch(12), rigid_motion));
  const Mesh reference = make_mesh(
    transformed(triangle_grid(5, 5), [](const Point& p) { return rigid_motion(Point(4 * p.x() - 3, 4 * p.y() - 3, 0)); }));
  const Mesh mesh = optimized(plane, reference, PMP::LEAST_SQUARES);
  const Vector normal = rigid_motion(Point(0, 0, 1)) - rigid_motion(CGAL::ORIGIN);
  for(const Point& p : mesh.points())
    CHECK_AT_MOST(std::abs((p - rigid_motion(CGAL::ORIGIN)) * normal), 1e-12 * 12);
}

// How much of the mean error to a sphere is left, of the part of the mesh with the vertices of `before` from `first` on.
double remaining_error(const Mesh& mesh, std::size_t first, const Soup& before, const Point& center, double radius)
{
  Mesh part = make_mesh(before);
  auto error = [&]() {
    return measure_errors(part, 6, [&](const Point& p) { return std::abs(norm(p - center) - radius); }).mean;
  };
  const double error_before = error();
  for(Mesh::Vertex_index v : part.vertices())
    part.point(v) = mesh.point(Mesh::Vertex_index(first + v));
  return error() / error_before;
}

void test_graded_mesh()
{
  start_topic("Two spheres, one a hundred times smaller, gain in one mesh what they gain alone");
  const double small = 0.01;
  const Point center(3, 0, 0);
  auto smaller = [&](const Soup& soup) {
    return transformed(soup, [&](const Point& p) { return center + small * (p - CGAL::ORIGIN); });
  };
  const Soup remesh = transformed(icosphere(3), rotated), reference = icosphere(5);
  const Mesh both = make_mesh(combined(remesh, smaller(remesh)));
  for(PMP::Placement_method method : { PMP::PIECEWISE_LINEAR, PMP::LEAST_SQUARES })
  {
    const double alone =
      remaining_error(optimized(make_mesh(remesh), make_mesh(reference), method), 0, remesh, CGAL::ORIGIN, 1);
    CHECK_LESS(alone, 0.3);
    const Mesh mesh = optimized(both, make_mesh(combined(reference, smaller(reference))), method);
    CHECK_NEAR(remaining_error(mesh, 0, remesh, CGAL::ORIGIN, 1) / alone, 1, 0.01);
    CHECK_NEAR(remaining_error(mesh, remesh.points.size(), smaller(remesh), center, small) / alone, 1, 0.01);
  }
}

void test_equivariance()
{
  start_topic("Scaled by a power of two, the result is the same to the last bit; moved, it is as good");
  // The samples of the reference depend on the order of its faces, and that on the directions of the axes.
  const Mesh reference = make_mesh(icosphere(4)), remesh = make_mesh(transformed(icosphere(3), rotated));
  auto transformed_mesh = [](Mesh mesh, const auto& transformation) {
    for(Point& p : mesh.points())
      p = transformation(p);
    return mesh;
  };
  const Mesh result = optimized(remesh, reference, PMP::LEAST_SQUARES);
  for(double factor : { std::ldexp(1, -20), std::ldexp(1, 20) })
  {
    auto scale = [&](const Point& p) { return CGAL::ORIGIN + factor * (p - CGAL::ORIGIN); };
    const Mesh scaled = optimized(transformed_mesh(remesh, scale), transformed_mesh(reference, scale), PMP::LEAST_SQUARES);
    CHECK(points_of(scaled) == points_of(transformed_mesh(result, scale)));
  }
  const Mesh moved_reference = transformed_mesh(reference, rigid_motion);
  const Mesh moved = optimized(transformed_mesh(remesh, rigid_motion), moved_reference, PMP::LEAST_SQUARES);
  const double error = measure_errors(result, 6, Distance_to_mesh(reference)).mean;
  const double error_moved = measure_errors(moved, 6, Distance_to_mesh(moved_reference)).mean;
  CHECK_NEAR(error_moved / error, 1, 0.02);
}

int main()
{
  test_sphere();
  test_unmarked_creases();
  test_tip();
  test_regularity_weight();
  test_simplified_meshes();
  test_too_large_weight();
  test_one_call();
  test_one_call_at_creases();
  test_planes();
  test_graded_mesh();
  test_equivariance();
  return test_result();
}
