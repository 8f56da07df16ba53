// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_HEAP_USE_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_HEAP_USE_H

// To be included by one translation unit of a program: it replaces the global operators new and delete.

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <new>
#include <string>

#if defined(__GLIBC__)
#include <malloc.h>
#define VERTEX_LOCATION_OPTIMIZATION_COUNTS_HEAP
#endif

// The bytes that have been allocated and not freed since `start_counting()`, by one thread.
class Heap_use
{
public:
  static bool is_known()
  {
#ifdef VERTEX_LOCATION_OPTIMIZATION_COUNTS_HEAP
    return true;
#else
    return false;
#endif
  }

  static void start_counting()
  {
    s_live = s_peak = 0;
    s_is_counting = true;
  }
  static void stop_counting() { s_is_counting = false; }

  static double live() { return static_cast<double>(s_live); }
  static double peak() { return static_cast<double>(s_peak); }

  static void add(void* memory, int sign)
  {
#ifdef VERTEX_LOCATION_OPTIMIZATION_COUNTS_HEAP
    if(!s_is_counting)
      return;
    s_live += sign * static_cast<std::ptrdiff_t>(malloc_usable_size(memory));
    s_peak = (std::max)(s_peak, s_live);
#else
    (void)memory;
    (void)sign;
#endif
  }

private:
  inline static thread_local bool s_is_counting = false;
  inline static thread_local std::ptrdiff_t s_live = 0;
  inline static thread_local std::ptrdiff_t s_peak = 0;
};

#ifdef VERTEX_LOCATION_OPTIMIZATION_COUNTS_HEAP
inline void* count_allocated(void* memory)
{
  if(memory == nullptr)
    throw std::bad_alloc();
  Heap_use::add(memory, 1);
  return memory;
}

inline void free_counted(void* memory)
{
  if(memory != nullptr)
    Heap_use::add(memory, -1);
  std::free(memory);
}

// the other forms call these
void* operator new(std::size_t size) { return count_allocated(std::malloc((std::max)(size, std::size_t(1)))); }
void operator delete(void* memory) noexcept { free_counted(memory); }
void operator delete(void* memory, std::size_t) noexcept { free_counted(memory); }

void* operator new(std::size_t size, std::align_val_t alignment)
{
  const std::size_t a = static_cast<std::size_t>(alignment);
  return count_allocated(std::aligned_alloc(a, (size + a) / a * a));
}
void operator delete(void* memory, std::align_val_t) noexcept { free_counted(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { free_counted(memory); }
#endif

// The largest memory that the process has had, in bytes; 0 if the system does not tell.
inline double peak_of_process()
{
  std::ifstream status("/proc/self/status");
  for(std::string word; status >> word;)
    if(word == "VmHWM:")
    {
      double kibibytes = 0;
      status >> kibibytes;
      return 1024 * kibibytes;
    }
  return 0;
}

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_HEAP_USE_H
