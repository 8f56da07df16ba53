// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_CHECK_VIOLATION_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_CHECK_VIOLATION_H

#include "check.h"

#include <CGAL/exceptions.h>

// whether f() ends with a violated precondition, which says what is wrong
template <typename F>
bool violates_precondition(const F& f)
{
  try
  {
    f();
  }
  catch(const CGAL::Precondition_exception& e)
  {
    CHECK(!e.message().empty());
    return true;
  }
  return false;
}

#ifdef NDEBUG
constexpr bool checks_are_on = false;
#else
constexpr bool checks_are_on = true;
#endif

// Checks that f() violates a precondition, where that is checked.
template <typename F>
void check_violation(const F& f)
{
  CHECK_EQUAL(violates_precondition(f), checks_are_on);
}

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_CHECK_VIOLATION_H
