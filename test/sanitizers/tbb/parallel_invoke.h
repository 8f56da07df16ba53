// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_PARALLEL_INVOKE_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_PARALLEL_INVOKE_H

// In the place of TBB's for ThreadSanitizer, see parallel_for.h.

#include <thread>

namespace tbb {

template <typename F, typename G>
void parallel_invoke(const F& f, const G& g)
{
  std::thread thread(f);
  g();
  thread.join();
}

} // namespace tbb

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_PARALLEL_INVOKE_H
