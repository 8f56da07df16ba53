// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>

#include <CGAL/boost/graph/generators.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#ifdef CGAL_LINKED_WITH_TBB
static_assert(EXPECT_TBB, "TBB is there although it is not wanted");
#else
static_assert(!EXPECT_TBB, "TBB is missing");
#endif

int main()
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  CGAL::Surface_mesh<Point> mesh;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1.);
  const auto reference = mesh;
  const auto report = CGAL::Polygon_mesh_processing::optimize_vertex_locations<CGAL::Parallel_if_available_tag>(
    mesh, reference, CGAL::parameters::number_of_iterations(20).number_of_free_iterations(10)); // in any order
  return report.iterations > 0 ? 0 : 1;
}
