// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_SEARCH_FOR_EDGE_LENGTH_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_SEARCH_FOR_EDGE_LENGTH_H

// The search for the edge length alone, for a given error.

#include "check.h"
#include "Distance_to_mesh.h"
#include "Exact_sphere.h"
#include "mesh_quality.h"
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
using PMP::internal::vertex_location::Edge_length_search;
using Report = PMP::Tolerance_report;

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Search_result
{
  double edge_length = 0;
  int attempts = 0;
};

// the search alone, for a given error by edge length, and lengths for which the remesh is beyond the tolerance all the same
template <typename Error, typename Is_unlucky>
Search_result search(double first, const Error& error, const Is_unlucky& is_unlucky)
{
  Edge_length_search search(first, 1e-4, 1, 0.02);
  Search_result result;
  for(; !search.is_finished() && result.attempts < 50; ++result.attempts)
  {
    const double length = search.next_length(), e = error(length);
    CHECK(length >= 1e-4 && length <= 1);
    const bool is_within = e <= 1 && !is_unlucky(length);
    if(is_within)
      result.edge_length = (std::max)(result.edge_length, length);
    search.add({ length, e, is_within, static_cast<std::size_t>(1 / (length * length)) });
  }
  return result;
}

template <typename Error>
Search_result search(double first, const Error& error)
{
  return search(first, error, [](double) { return false; });
}

inline void test_search()
{
  start_topic("The search finds where a power reaches the tolerance");
  for(double exponent : { 1., 1.5, 2., 3. })
    for(double first : { 0.01, 0.03, 0.045, 0.05, 0.055, 0.07, 0.25 })
    {
      const Search_result result = search(first, [&](double h) { return std::pow(h / 0.05, exponent); });
      CHECK_AT_MOST(result.edge_length, 0.05 * (1 + 1e-12));
      CHECK_AT_LEAST(result.edge_length, 0.05 / 1.02 * (1 - 1e-9));
      CHECK_AT_MOST(result.attempts, 7);
    }

  start_topic("Noise in the error");
  for(int seed = 0; seed < 50; ++seed)
  {
    CGAL::Random random(seed);
    const auto noisy = [&](double h) { return std::pow(h / 0.05, 2) * random.get_double(0.95, 1.05); };
    const Search_result result = search(0.08, noisy);
    CHECK_AT_LEAST(result.edge_length, 0.05 * 0.95); // the error there is 0.9 +- 0.045
    CHECK_AT_MOST(result.attempts, 8);
  }

  start_topic("Remeshes that are beyond the tolerance by bad luck");
  const auto square = [](double h) { return std::pow(h / 0.05, 2); };
  Search_result result = search(0.03, square, [](double h) { return h < 0.04; }); // longer ones have more luck
  CHECK_AT_LEAST(result.edge_length, 0.05 / 1.02 * (1 - 1e-9));
  CHECK_AT_MOST(result.attempts, 7);
  for(double first : { 0.02, 0.04, 0.1 })
  {
    result = search(first, square, [](double h) { return h > 0.03; }); // shorter ones have
    CHECK_AT_LEAST(result.edge_length, 0.015);
    CHECK_AT_MOST(result.attempts, 12);
  }

  start_topic("Errors that are no power");
  const Search_result step = search(0.2, [](double h) { return h < 0.05 ? 0.5 : infinity; });
  CHECK_LESS(step.edge_length, 0.05);
  CHECK_AT_LEAST(step.edge_length, 0.05 / 1.02 * (1 - 1e-9));
  CHECK_AT_MOST(step.attempts, 12);
  CHECK_EQUAL(search(0.2, [](double) { return infinity; }).edge_length, 0);
  CHECK_AT_MOST(search(0.2, [](double) { return infinity; }).attempts, 12);
  CHECK_EQUAL(search(0.2, [](double) { return 0.; }).edge_length, 1);
  CHECK_AT_MOST(search(0.2, [](double) { return 0.; }).attempts, 3);

  start_topic("A remesher that ignores the edge length");
  for(double error : { 0.3, 3. })
  {
    Edge_length_search search(0.1, 1e-4, 1, 0.02);
    int attempts = 0;
    for(; !search.is_finished() && attempts < 50; ++attempts)
      search.add({ search.next_length(), error, error <= 1, 100 });
    CHECK_AT_MOST(attempts, 3);
  }
}

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_SEARCH_FOR_EDGE_LENGTH_H
