// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The parallel version gives the result of the sequential one, to the last bit, with any number of threads.

#include "check.h"
#include "Exact_sphere.h"
#include "mesh_quality.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#ifndef CGAL_LINKED_WITH_TBB
#error "The target CGAL::Vertex_location_optimization should have brought TBB."
#endif

namespace PMP = CGAL::Polygon_mesh_processing;
using Report = PMP::Vertex_location_optimization_report;

struct Result
{
  std::vector<Point> points;
  Report report;
};

template <typename ConcurrencyTag, typename Reference>
Result optimize(Mesh mesh, const Reference& reference, PMP::Placement_method method)
{
  Result result;
  result.report =
    PMP::optimize_vertex_locations<ConcurrencyTag>(mesh, reference, CGAL::parameters::placement_method(method));
  result.points = points_of(mesh);
  return result;
}

void check_same(const Result& a, const Result& b)
{
  CHECK(a.points == b.points);
  CHECK_EQUAL(a.report.iterations, b.report.iterations);
  CHECK_EQUAL(a.report.converged, b.report.converged);
  CHECK_EQUAL(a.report.displacement, b.report.displacement);
  CHECK_EQUAL(a.report.corrected_vertices, b.report.corrected_vertices);
}

template <typename Reference>
void test_threads(const std::string& name, const Mesh& mesh, const Reference& reference, PMP::Placement_method method)
{
  start_topic(name + ", sequential");
  const Result expected = optimize<CGAL::Sequential_tag>(mesh, reference, method);
  CHECK_LESS(0u, expected.report.corrected_vertices);
  CHECK(expected.points != points_of(mesh));
  check_same(optimize<CGAL::Sequential_tag>(mesh, reference, method), expected);

  for(int number_of_threads : { 1, 2, 3, 7 })
  {
    start_topic(name + ", " + std::to_string(number_of_threads) + " threads");
    tbb::global_control control(tbb::global_control::max_allowed_parallelism, number_of_threads);
    tbb::task_arena arena(number_of_threads); // also where there are fewer cores
    for(int i = 0; i < 2; ++i)
    {
      arena.execute([&] { check_same(optimize<CGAL::Parallel_tag>(mesh, reference, method), expected); });
      arena.execute([&] { check_same(optimize<CGAL::Parallel_if_available_tag>(mesh, reference, method), expected); });
    }
  }
}

int main()
{
  // an irregular mesh, rough enough that moves must be shortened, of some thousand vertices
  CGAL::Random random(3);
  const Mesh mesh = make_mesh(transformed(icosphere(4), [&](const Point& p) {
    auto moved = [&](double x) { return x + random.get_double(-.03, .03); };
    return CGAL::ORIGIN + (1 + random.get_double(-.02, .02)) * unit(Vector(moved(p.x()), moved(p.y()), moved(p.z())));
  }));
  const Mesh reference = make_mesh(icosphere(3));

  test_threads("piecewise linear", mesh, reference, PMP::PIECEWISE_LINEAR);
  test_threads("least squares", mesh, reference, PMP::LEAST_SQUARES);
  test_threads("a surface of one's own", mesh, Exact_sphere(CGAL::ORIGIN, 1), PMP::PIECEWISE_LINEAR);
  return test_result();
}
