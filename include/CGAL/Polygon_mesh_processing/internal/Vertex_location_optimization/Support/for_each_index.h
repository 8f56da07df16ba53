// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
//
// Author(s)     : The Vertex_location_optimization authors

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FOR_EACH_INDEX_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FOR_EACH_INDEX_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#endif

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Calls f(i) for each i in [0, n). Calls for different i may run at the same time: f(i) must write nothing that another
// call reads or writes.
template <typename ConcurrencyTag, typename F>
void for_each_index(std::size_t n, const F& f)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr(std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
  {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n), [&](const tbb::blocked_range<std::size_t>& range) {
      for(std::size_t i = range.begin(); i != range.end(); ++i)
        f(i);
    });
    return;
  }
#else
  static_assert(!std::is_convertible<ConcurrencyTag, Parallel_tag>::value,
                "Parallel_tag is enabled but TBB is unavailable: link with TBB (the CMake target CGAL::TBB_support) "
                "or use Parallel_if_available_tag.");
#endif
  for(std::size_t i = 0; i < n; ++i)
    f(i);
}

// Calls f() and g(), which may run at the same time: neither may write what the other one reads or writes.
template <typename ConcurrencyTag, typename F, typename G>
void call_both(const F& f, const G& g)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr(std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
  {
    tbb::parallel_invoke(f, g);
    return;
  }
#endif
  f();
  g();
}

// Calls f(begin, end) for blocks of indices [begin, end) that make [0, n), all of the same size but for the last, whatever
// the number of threads.
template <typename ConcurrencyTag, typename F>
void for_each_block(std::size_t n, std::size_t block_size, const F& f)
{
  for_each_index<ConcurrencyTag>((n + block_size - 1) / block_size, [&](std::size_t block) {
    const std::size_t begin = block * block_size;
    f(begin, (std::min)(n, begin + block_size));
  });
}

// the i in [0, n) for which predicate(i) holds, in increasing order
template <typename ConcurrencyTag, typename Predicate>
std::vector<Index> find_indices(std::size_t n, const Predicate& predicate)
{
  constexpr std::size_t block_size = 2048;
  std::vector<std::vector<Index>> found((n + block_size - 1) / block_size);
  for_each_block<ConcurrencyTag>(n, block_size, [&](std::size_t begin, std::size_t end) {
    for(std::size_t i = begin; i < end; ++i)
      if(predicate(i))
        found[begin / block_size].push_back(static_cast<Index>(i));
  });
  std::vector<Index> result;
  for(const std::vector<Index>& indices : found)
    result.insert(result.end(), indices.begin(), indices.end());
  return result;
}

// f(0) + f(1) + ... + f(n-1), summed in blocks of a fixed size, so that the rounding, and with it the result, is the
// same for any number of threads. T is initialized with T() and has the operator +=.
template <typename ConcurrencyTag, typename T, typename F>
T sum_over_indices(std::size_t n, const F& f)
{
  constexpr std::size_t block_size = 512;
  std::vector<T> sums((n + block_size - 1) / block_size, T());
  for_each_block<ConcurrencyTag>(n, block_size, [&](std::size_t begin, std::size_t end) {
    for(std::size_t i = begin; i < end; ++i)
      sums[begin / block_size] += f(i);
  });
  T sum = T();
  for(const T& s : sums)
    sum += s;
  return sum;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FOR_EACH_INDEX_H
