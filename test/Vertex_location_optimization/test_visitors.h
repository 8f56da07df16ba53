// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_TEST_VISITORS_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_TEST_VISITORS_H

#include "check.h"
#include "irregular_sphere.h"

#include <cstddef>
#include <functional>
#include <vector>

// A visitor as a user writes it: it need not derive from the default one, and cannot be copied.
struct Counting_visitor
{
  explicit Counting_visitor(std::size_t max_phases = 1000) : max_phases(max_phases) {}
  Counting_visitor(const Counting_visitor&) = delete;

  void start_phase(PMP::Vertex_location_optimization_phase phase) { phases.push_back(phase); }
  void end_iteration(const Report& report) { reports.push_back(report); }
  bool go_further() { return phases.size() < max_phases; }

  std::size_t max_phases;
  std::vector<PMP::Vertex_location_optimization_phase> phases;
  std::vector<Report> reports;
};

using Phase = PMP::Vertex_location_optimization_phase;

constexpr Phase phases_of_iteration[] = { Phase::SAMPLE_REFERENCE, Phase::PLACE_VERTICES, Phase::RELAX_VERTICES,
                                          Phase::CORRECT_FLIPS };

inline void test_visitor(const Input& input)
{
  start_topic("visitor");
  Mesh mesh = input.mesh;
  Counting_visitor visitor;
  const Report report = PMP::optimize_vertex_locations(mesh, input.reference, parameters::visitor(std::ref(visitor)));
  CHECK(points_of(mesh) == optimized(input.mesh, input.reference, parameters::default_values()));
  CHECK_EQUAL(visitor.reports.size(), report.iterations);
  for(std::size_t i = 0; i < visitor.reports.size(); ++i)
    CHECK_EQUAL(visitor.reports[i].iterations, i + 1);
  CHECK_EQUAL(visitor.reports.back().displacement, report.displacement);
  CHECK_LESS(0u, visitor.reports[0].displacement);
  CHECK_AT_MOST(visitor.reports.back().corrected_vertices, report.corrected_vertices);
  CHECK_EQUAL(visitor.phases.size(), 4 * report.iterations + 1);
  for(std::size_t i = 0; i + 1 < visitor.phases.size(); ++i)
    CHECK(visitor.phases[i] == phases_of_iteration[i % 4]);
  CHECK(visitor.phases.back() == Phase::ENFORCE_GUARANTEE);
}

inline void test_cancelling(const Input& input)
{
  start_topic("A visitor can stop the run in any phase, with the result of the last complete iteration");
  std::vector<Point> result;
  for(std::size_t number_of_phases = 0; number_of_phases <= 12; ++number_of_phases)
  {
    const std::size_t iterations = number_of_phases / 4;
    Mesh mesh = input.mesh;
    Counting_visitor visitor(number_of_phases);
    const Report report = PMP::optimize_vertex_locations(mesh, input.reference, parameters::visitor(std::ref(visitor)));
    CHECK_EQUAL(report.iterations, iterations);
    CHECK(!report.converged);
    CHECK_EQUAL(visitor.reports.size(), iterations);
    CHECK_EQUAL(visitor.phases.size(), number_of_phases + (iterations > 0));
    if(number_of_phases % 4 == 0)
    {
      // only the last iteration of a run that is not stopped has the closest points themselves
      result = points_of(mesh);
      const std::vector<Point> run = optimized(input.mesh, input.reference, parameters::number_of_iterations(iterations));
      CHECK_AT_MOST(largest_distance(result, run), 1e-3);
    }
    else
      CHECK(points_of(mesh) == result);
  }
}

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_TEST_VISITORS_H
