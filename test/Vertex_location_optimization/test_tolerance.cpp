// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Remeshing within a tolerance: the search for the edge length, what the result is worth, and remeshers of all kinds.

#include "check.h"
#include "Distance_to_mesh.h"
#include "Exact_sphere.h"
#include "mesh_quality.h"
#include "refine_faces.h"
#include "search_for_edge_length.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh_within_tolerance.h>
#include <CGAL/Polyhedron_3.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::parameters;
using PMP::internal::vertex_location::Edge_length_search;
using Report = PMP::Tolerance_report;

struct Counting_visitor : PMP::Tolerance_default_visitor
{
  void start_remeshing(double length) { lengths.push_back(length); }
  void end_remeshing(const Report& report) { reports.push_back(report); }
  bool go_further() { return reports.size() < limit; }

  std::size_t limit = 100;
  std::vector<double> lengths;
  std::vector<Report> reports;
};

// Of equilateral triangles on the unit sphere that are off it by h^2 / 8 at the vertices, h^2 / 8 is the largest distance,
// so that a tolerance needs 4 pi sqrt(3) / 12 / tolerance vertices.
void test_sphere()
{
  start_topic("A sphere");
  const Mesh input = make_mesh(icosphere(4));
  const double tolerance = 0.02, ideal_number = CGAL_PI / std::sqrt(3.) / tolerance;
  Mesh result;
  Counting_visitor visitor;
  const Report report = PMP::remesh_within_tolerance(input, tolerance, result, params::visitor(std::ref(visitor)));
  CHECK(report.is_within_tolerance);
  CHECK_AT_MOST(hausdorff_distance(result, input), tolerance);
  CHECK_AT_MOST((std::max)(report.to_reference.max, report.from_reference.max), tolerance);
  CHECK_EQUAL(report.number_of_vertices, vertices(result).size());
  CHECK_AT_MOST(double(report.number_of_vertices), 2.2 * ideal_number); // irregular vertices, and an edge length for all
  CHECK_AT_MOST(report.number_of_remeshings, 7u);
  CHECK_AT_LEAST(PMP::volume(result), PMP::volume(input) * 0.99); // it does not shrink

  CHECK_EQUAL(visitor.reports.size(), report.number_of_remeshings);
  CHECK_EQUAL(visitor.lengths.size(), report.number_of_remeshings);
  for(const Report& attempt : visitor.reports)
    CHECK(!attempt.is_within_tolerance || attempt.number_of_vertices >= report.number_of_vertices);

  start_topic("The same with threads, and with the result in the place of the input");
  Mesh parallel = input;
  const Report again = PMP::remesh_within_tolerance<CGAL::Parallel_if_available_tag>(parallel, tolerance, parallel);
  CHECK_EQUAL(again.edge_length, report.edge_length);
  CHECK(points_of(parallel) == points_of(result));

  start_topic("Mean and root mean square");
  for(auto kind : { PMP::MEAN_ERROR, PMP::RMS_ERROR })
  {
    const Report of_kind = PMP::remesh_within_tolerance(input, 0.005, result, params::tolerated_error(kind));
    CHECK(of_kind.is_within_tolerance);
    const double error = kind == PMP::MEAN_ERROR ? (std::max)(of_kind.to_reference.mean, of_kind.from_reference.mean)
                                                 : (std::max)(of_kind.to_reference.rms, of_kind.from_reference.rms);
    CHECK_AT_MOST(error, 0.005);
    CHECK_AT_LEAST(error, 0.0045); // an edge length 2% below has 4% less
  }

  start_topic("Another reference");
  const Exact_sphere sphere(Point(0, 0, 0), 1);
  const Report of_sphere =
    PMP::remesh_within_tolerance(input, tolerance, result, params::reference_surface(std::cref(sphere)));
  CHECK(of_sphere.is_within_tolerance);
  CHECK_AT_MOST(measure_errors(result, 12, [](const Point& p) { return std::abs(norm(p - CGAL::ORIGIN) - 1); }).max,
                tolerance);

  start_topic("A visitor stops the search");
  visitor = Counting_visitor();
  visitor.limit = 1;
  const Report stopped = PMP::remesh_within_tolerance(input, tolerance, result, params::visitor(std::ref(visitor)));
  CHECK_EQUAL(stopped.number_of_remeshings, 1u);
  CHECK_EQUAL(stopped.edge_length, visitor.lengths[0]);
  CHECK_EQUAL(stopped.number_of_vertices, vertices(result).size());
  visitor.limit = 0;
  Mesh untouched = make_mesh(icosphere(0));
  CHECK_EQUAL(
    PMP::remesh_within_tolerance(input, tolerance, untouched, params::visitor(std::ref(visitor))).number_of_remeshings, 0u);
  CHECK_EQUAL(untouched.number_of_vertices(), 12u);
}

// A torus of n * 2n vertices, whatever is given: a remesher of which the coarsest mesh can be found by trying all.
Mesh torus(std::size_t n)
{
  Soup soup;
  for(std::size_t i = 0; i < 2 * n; ++i)
    for(std::size_t j = 0; j < n; ++j)
    {
      const double u = CGAL_PI * (i + 0.5 * (j % 2)) / n, v = 2 * CGAL_PI * j / n, r = 2 + std::cos(v);
      soup.points.emplace_back(r * std::cos(u), r * std::sin(u), std::sin(v));
    }
  const auto at = [&](std::size_t i, std::size_t j) { return (i % (2 * n)) * n + j % n; };
  for(std::size_t i = 0; i < 2 * n; ++i)
    for(std::size_t j = 0; j < n; ++j)
    {
      const std::size_t k = j % 2; // the odd columns are shifted by half a step
      soup.triangles.push_back({ at(i, j), at(i + 1, j), at(i + k, j + 1) });
      soup.triangles.push_back({ at(i + 1, j), at(i + 1 + k, j + 1), at(i + k, j + 1) });
    }
  return make_mesh(soup);
}

void test_coarsest()
{
  start_topic("No coarser mesh of the remesher would do");
  const Mesh input = torus(80);
  const auto number = [](double edge_length) {
    return 2 * (std::max)(2ul, static_cast<unsigned long>(std::ceil(CGAL_PI / edge_length))); // even
  };
  const auto remesh = [&](Mesh& mesh, double edge_length) { mesh = torus(number(edge_length)); };
  const PMP::Flat_triangle_surface<Mesh> reference(input);
  const auto error = [&](unsigned long n) {
    Mesh mesh = torus(n);
    PMP::optimize_vertex_locations(mesh, reference, params::placement_method(PMP::LEAST_SQUARES));
    return (std::max)(PMP::approximation_error(mesh, reference).rms,
                      PMP::approximation_error(input, PMP::Flat_triangle_surface<Mesh>(mesh)).rms);
  };
  const double tolerance = 0.02;
  unsigned long least = 4;
  while(error(least) > tolerance)
    least += 2;

  Mesh result;
  const Report report =
    PMP::remesh_within_tolerance(input, tolerance, result, remesh, params::tolerated_error(PMP::RMS_ERROR));
  CHECK(report.is_within_tolerance);
  CHECK_EQUAL(report.number_of_vertices, 2 * least * least);
  CHECK_AT_MOST(report.number_of_remeshings, 9u); // the last ones tell one number from the next
}

void test_creases()
{
  start_topic("A cube whose edges are kept");
  Mesh input = make_mesh(cube(4));
  const auto is_crease = input.add_property_map<Mesh::Edge_index, bool>("e:is_crease", false).first;
  PMP::detect_sharp_edges(input, 60, is_crease);
  Mesh result;
  Report report = PMP::remesh_within_tolerance(input, 0.01, result, params::edge_is_constrained_map(is_crease));
  CHECK(report.is_within_tolerance);
  CHECK_AT_MOST(hausdorff_distance(result, input), 1e-9);
  CHECK_NEAR(PMP::volume(result), 8, 1e-9);
  CHECK_AT_MOST(report.number_of_vertices, 14u); // the corners, and one a side

  start_topic("A cylinder with caps, its circles creases");
  Soup soup = transformed(triangle_grid(96, 24, true), [](const Point& p) {
    const double u = p.x() * 2 * CGAL_PI / 96;
    return Point(std::cos(u), std::sin(u), p.y() / 12);
  });
  for(std::size_t end : { 0, 1 })
  {
    soup.points.emplace_back(0, 0, 2. * end);
    for(std::size_t i = 0; i < 96; ++i)
    {
      const std::size_t a = end * 24 * 96 + i, b = end * 24 * 96 + (i + 1) % 96;
      if(end == 0)
        soup.triangles.push_back({ b, a, soup.points.size() - 1 });
      else
        soup.triangles.push_back({ a, b, soup.points.size() - 1 });
    }
  }
  input = make_mesh(soup);
  const auto is_circle = input.add_property_map<Mesh::Edge_index, bool>("e:is_crease", false).first;
  PMP::detect_sharp_edges(input, 60, is_circle);
  bool is_map_kept = true;
  const auto remesh = [&](Mesh& mesh, double edge_length, const auto& map) {
    PMP::isotropic_remeshing(faces(mesh), edge_length, mesh, params::edge_is_constrained_map(map).number_of_iterations(5));
    for(Mesh::Edge_index e : mesh.edges()) // the circles are what is constrained
      if(get(map, e))
        for(Mesh::Vertex_index v : { mesh.vertex(e, 0), mesh.vertex(e, 1) })
          is_map_kept = is_map_kept && std::abs(std::abs(mesh.point(v).z() - 1) - 1) < 1e-9;
  };
  const double tolerance = 0.02;
  report = PMP::remesh_within_tolerance(input, tolerance, result, remesh, params::edge_is_constrained_map(is_circle));
  CHECK(report.is_within_tolerance);
  CHECK(is_map_kept);
  CHECK_AT_MOST(hausdorff_distance(result, input), tolerance);
  double lowest = 1, highest = 1;
  for(const Point& p : points_of(result))
  {
    lowest = (std::min)(lowest, p.z());
    highest = (std::max)(highest, p.z());
  }
  CHECK_NEAR(lowest, 0, 1e-9); // the caps stay planes
  CHECK_NEAR(highest, 2, 1e-9);
  CHECK_AT_LEAST(PMP::volume(result), 0.98 * 2 * CGAL_PI);
}

// a remesher that does nothing useful: the result is untouched, or honest
void test_bad_remeshers()
{
  const Mesh input = make_mesh(icosphere(3)), other = make_mesh(icosphere(0));
  Mesh result = other;

  start_topic("A remesher that does nothing");
  Report report = PMP::remesh_within_tolerance(input, 0.01, result, [](Mesh&, double) {});
  CHECK(report.is_within_tolerance);
  CHECK_AT_MOST(report.number_of_remeshings, 3u);
  CHECK_EQUAL(result.number_of_vertices(), input.number_of_vertices());

  start_topic("One that always returns the same coarse mesh");
  report = PMP::remesh_within_tolerance(
    input, 1e-3, result, [&](Mesh& mesh, double) { mesh = other; }, params::number_of_iterations(3));
  CHECK(!report.is_within_tolerance);
  CHECK_AT_MOST(report.number_of_remeshings, 3u);
  CHECK_EQUAL(result.number_of_vertices(), report.number_of_vertices);
  const double distance = hausdorff_distance(result, input);
  CHECK_NEAR((std::max)(report.to_reference.max, report.from_reference.max), distance, 0.02 * distance);

  start_topic("One that returns no mesh, or one that is not finite");
  const auto check_nothing = [&](const auto& remesh) {
    result = other;
    const Report report = PMP::remesh_within_tolerance(input, 0.01, result, remesh);
    CHECK(!report.is_within_tolerance);
    CHECK_EQUAL(report.to_reference.max, infinity);
    CHECK_EQUAL(report.from_reference.max, infinity);
    CHECK_EQUAL(report.edge_length, 0);
    CHECK_AT_MOST(report.number_of_remeshings, 12u);
    CHECK(points_of(result) == points_of(other));
  };
  check_nothing([](Mesh& mesh, double) { mesh.clear(); });
  check_nothing([](Mesh& mesh, double) { mesh.point(Mesh::Vertex_index(0)) = Point(NAN, 0, 0); });
  check_nothing([](Mesh& mesh, double) { CGAL::Euler::join_face(mesh.halfedge(Mesh::Edge_index(5)), mesh); });

  start_topic("One that throws");
  bool has_thrown = false;
  try
  {
    PMP::remesh_within_tolerance(input, 0.01, result, [](Mesh&, double) { throw std::runtime_error(""); });
  }
  catch(const std::runtime_error&)
  {
    has_thrown = true;
  }
  CHECK(has_thrown);
  CHECK(points_of(result) == points_of(other));

  start_topic("One that fails for large edge lengths");
  report = PMP::remesh_within_tolerance(input, 0.1, result, [](Mesh& mesh, double edge_length) {
    if(edge_length > 0.3)
      mesh.clear();
    else
      PMP::isotropic_remeshing(faces(mesh), edge_length, mesh);
  });
  CHECK(report.is_within_tolerance);
  CHECK_AT_MOST(report.edge_length, 0.3);
  CHECK_AT_LEAST(report.edge_length, 0.3 / 1.02);
}

void test_limits()
{
  const Mesh input = make_mesh(icosphere(2));
  Mesh result;

  start_topic("A tolerance that cannot be met");
  const auto remesh = [](Mesh& mesh, double h) { mesh = make_mesh(transformed(icosphere(h > 0.2 ? 0 : 1), rotated)); };
  Report report = PMP::remesh_within_tolerance(input, 1e-6, result, remesh);
  CHECK(!report.is_within_tolerance);
  CHECK_AT_MOST(report.number_of_remeshings, 12u);
  CHECK_AT_LEAST(report.number_of_vertices, 42u); // the finer one of the two
  report =
    PMP::remesh_within_tolerance(input, 1e-6, result, params::maximum_number_of_remeshings(1).number_of_iterations(3));
  CHECK_EQUAL(report.number_of_remeshings, 1u);

  start_topic("A tolerance larger than the model");
  report = PMP::remesh_within_tolerance(input, 100, result);
  CHECK(report.is_within_tolerance);
  CHECK_AT_MOST(report.number_of_vertices, 12u);

  start_topic("An open surface, its border fitted");
  const Soup cut = transformed(triangle_grid(24, 24, false, 0), [](const Point& p) {
    const double x = p.x() / 12 - 1, y = p.y() / 12 - 1;
    return Point(x, y, 0.3 * std::sin(2 * x) * y);
  });
  const Mesh patch = make_mesh(cut);
  report = PMP::remesh_within_tolerance(patch, 0.01, result);
  CHECK(report.is_within_tolerance);
  CHECK_AT_MOST(hausdorff_distance(result, patch), 0.01);
  CHECK_LESS(report.number_of_vertices, patch.number_of_vertices() / 3);

  start_topic("The result does not depend on the unit");
  for(double scale : { std::ldexp(1, -20), std::ldexp(1, 20) })
  {
    const Soup large = transformed(cut, [&](const Point& p) { return CGAL::ORIGIN + scale * (p - CGAL::ORIGIN); });
    const Report scaled = PMP::remesh_within_tolerance(make_mesh(large), 0.01 * scale, result);
    CHECK_NEAR(scaled.edge_length, report.edge_length * scale, 1e-9 * report.edge_length * scale);
    CHECK(scaled.is_within_tolerance);
  }

  start_topic("A Polyhedron_3");
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  const Polyhedron polyhedron = make_mesh<Polyhedron>(icosphere(3));
  Polyhedron coarse;
  report = PMP::remesh_within_tolerance(polyhedron, 0.03, coarse);
  CHECK(report.is_within_tolerance);
  CHECK_EQUAL(report.number_of_vertices, coarse.size_of_vertices());
}

int main()
{
  test_search();
  test_flips();
  test_pulls();
  test_sphere();
  test_coarsest();
  test_creases();
  test_bad_remeshers();
  test_limits();
  return test_result();
}
