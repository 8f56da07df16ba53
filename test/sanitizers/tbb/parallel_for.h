// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_PARALLEL_FOR_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_PARALLEL_FOR_H

// In the place of TBB's for ThreadSanitizer, with plain threads. TBB's scheduler is in a library that is not instrumented:
// ThreadSanitizer does not see how one thread hands over to another, and takes each loop for a race with the one before.
// The threads of the standard library it understands, so that what it finds in a loop is a race indeed.

#include <tbb/blocked_range.h>

#include <algorithm>
#include <thread>
#include <vector>

namespace tbb {

template <typename Body>
void parallel_for(const blocked_range<std::size_t>& range, const Body& body)
{
  constexpr std::size_t number_of_threads = 4;
  const std::size_t step = range.size() / number_of_threads + 1;
  std::vector<std::thread> threads;
  for(std::size_t begin = range.begin(); begin < range.end(); begin += step)
    threads.emplace_back(
      [&body, begin, end = (std::min)(begin + step, range.end())]() { body(blocked_range<std::size_t>(begin, end)); });
  for(std::thread& thread : threads)
    thread.join();
}

} // namespace tbb

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_PARALLEL_FOR_H
