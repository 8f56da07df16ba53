// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_CHECK_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_CHECK_H

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

// Checks that are on in every build. A check that fails is printed with its place, its expression and its values; the
// test goes on. A main ends with `return test_result();`. Boost's lightweight_test has no topics and passes if nothing is
// checked.

namespace check {

struct Counts
{
  int checks = 0;
  int failures = 0;
};

inline Counts& counts()
{
  static Counts counts;
  return counts;
}

// what is being checked, printed with a failure
inline std::string& topic()
{
  static std::string topic;
  return topic;
}

template <typename... Values>
bool check(bool ok, const char* file, int line, const char* expression, const Values&... values)
{
  ++counts().checks;
  if(ok)
    return true;
  ++counts().failures;
  std::cerr.precision(10);
  std::cerr << file << ":" << line << ": " << (topic().empty() ? "" : topic() + ": ") << expression;
  if constexpr(sizeof...(values) > 0)
    ((std::cerr << "   with "), ..., (std::cerr << " " << values));
  std::cerr << std::endl;
  return false;
}

} // namespace check

inline void start_topic(const std::string& topic)
{
  check::topic() = topic;
  std::cout << topic << std::endl;
}

inline int test_result()
{
  const check::Counts& counts = check::counts();
  std::cout << counts.checks << " checks, " << counts.failures << " failed" << std::endl;
  return counts.checks > 0 && counts.failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

#define CHECK(condition) check::check(bool(condition), __FILE__, __LINE__, #condition)
#define CHECK_EQUAL(a, b) check::check((a) == (b), __FILE__, __LINE__, #a " == " #b, a, b)
#define CHECK_LESS(a, b) check::check((a) < (b), __FILE__, __LINE__, #a " < " #b, a, b)
#define CHECK_AT_MOST(a, b) check::check((a) <= (b), __FILE__, __LINE__, #a " <= " #b, a, b)
#define CHECK_AT_LEAST(a, b) check::check((a) >= (b), __FILE__, __LINE__, #a " >= " #b, a, b)
// |a - b| <= tolerance; false for a NaN
#define CHECK_NEAR(a, b, tolerance)                                                                                         \
  check::check(std::abs((a) - (b)) <= (tolerance), __FILE__, __LINE__, #a " == " #b " +- " #tolerance, a, b, tolerance)

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_CHECK_H
