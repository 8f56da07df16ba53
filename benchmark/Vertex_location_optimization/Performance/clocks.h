// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_CLOCKS_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_CLOCKS_H

#include <chrono>
#include <ctime>

inline double wall_time()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// The time that this thread has worked: other programs hardly change it.
inline double thread_time()
{
#ifdef CLOCK_THREAD_CPUTIME_ID
  timespec time;
  if(clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time) == 0)
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
#endif
  return wall_time();
}

template <typename Function>
double thread_time_of(const Function& function)
{
  const double start = thread_time();
  function();
  return thread_time() - start;
}

template <typename Function>
double wall_time_of(const Function& function)
{
  const double start = wall_time();
  function();
  return wall_time() - start;
}

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_CLOCKS_H
