// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Compiled without TBB: `Parallel_if_available_tag` is sequential. With FORCE_PARALLEL_TAG it must not compile.

#include "check.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>

#ifdef CGAL_LINKED_WITH_TBB
#error "This test is one without TBB."
#endif

namespace PMP = CGAL::Polygon_mesh_processing;

int main()
{
  const Mesh reference = make_mesh(icosphere(2));
  Mesh sequential = make_mesh(icosphere(1));
#ifdef FORCE_PARALLEL_TAG
  PMP::optimize_vertex_locations<CGAL::Parallel_tag>(sequential, reference);
#else
  Mesh parallel = sequential;
  CHECK_LESS(0u, PMP::optimize_vertex_locations(sequential, reference).iterations);
  CHECK_LESS(0u, PMP::optimize_vertex_locations<CGAL::Parallel_if_available_tag>(parallel, reference).iterations);
  CHECK(points_of(sequential) == points_of(parallel));
#endif
  return test_result();
}
