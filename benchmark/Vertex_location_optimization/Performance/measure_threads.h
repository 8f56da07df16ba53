// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_MEASURE_THREADS_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_MEASURE_THREADS_H

#include "meshes.h"
#include "Table.h"

#if defined(CGAL_LINKED_WITH_TBB)
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#if defined(CGAL_LINKED_WITH_TBB)

// The smallest wall clock time of three calls; `result` is the optimized mesh.
template <typename ConcurrencyTag>
double wall_time_of_optimization(const Mesh& mesh, const Surface& surface, PMP::Placement_method method, Mesh& result)
{
  std::vector<double> times;
  for(int i = 0; i < 3; ++i)
  {
    result = mesh;
    times.push_back(wall_time_of(
      [&] { PMP::optimize_vertex_locations<ConcurrencyTag>(result, surface, CGAL::parameters::placement_method(method)); }));
  }
  return *std::min_element(times.begin(), times.end());
}

inline bool have_same_points(const Mesh& a, const Mesh& b)
{
  const auto vertices = a.vertices();
  return std::all_of(vertices.begin(), vertices.end(), [&](Mesh::Vertex_index v) { return a.point(v) == b.point(v); });
}

// 1, 2, 4, ..., and the number of cores
inline std::vector<std::size_t> numbers_of_threads()
{
  const std::size_t cores = (std::max)(1u, std::thread::hardware_concurrency());
  std::vector<std::size_t> numbers;
  for(std::size_t n = 1; n < cores; n *= 2)
    numbers.push_back(n);
  numbers.push_back(cores);
  return numbers;
}

inline void measure_construction(Table& table, const Mesh& reference)
{
  const auto defaults = CGAL::parameters::default_values();
  const double sequential = wall_time_of([&] { Surface(reference, defaults, CGAL::Sequential_tag()); });
  table.add_row("PN surface, sequential", { sequential });
  for(std::size_t n : numbers_of_threads())
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, n);
    const double parallel = wall_time_of([&] { Surface(reference, defaults, CGAL::Parallel_tag()); });
    table.add_row("PN surface, threads: " + std::to_string(n), { parallel, sequential / parallel });
  }
}

// Returns false if the result depends on the number of threads.
inline bool measure_threads(std::ofstream& csv, const Mesh& reference, const Mesh& mesh)
{
  Table table(csv, "threads: wall clock, speed-up over the sequential version, and whether the points are the same",
              { "seconds", "speed-up", "same" });
  measure_construction(table, reference);

  const Surface surface(reference);
  bool all_same = true;
  for(PMP::Placement_method method : placement_methods)
  {
    Mesh expected, result;
    const double sequential = wall_time_of_optimization<CGAL::Sequential_tag>(mesh, surface, method, expected);
    table.add_row(name_of(method) + std::string(", sequential"), { sequential });
    for(std::size_t n : numbers_of_threads())
    {
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, n);
      const double parallel = wall_time_of_optimization<CGAL::Parallel_tag>(mesh, surface, method, result);
      const bool same = have_same_points(expected, result);
      all_same = all_same && same;
      table.add_row(name_of(method) + std::string(", threads: ") + std::to_string(n),
                    { parallel, sequential / parallel, double(same) });
    }
  }
  return all_same;
}

#else

inline bool measure_threads(std::ofstream&, const Mesh&, const Mesh&)
{
  std::printf("\nthreads: not measured, since this program was built without TBB\n");
  return true;
}

#endif

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_MEASURE_THREADS_H
