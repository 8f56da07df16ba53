// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_CHECK_EQUIVARIANCE_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_CHECK_EQUIVARIANCE_H

#include "check.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>

#include <CGAL/bounding_box.h>

// Checks that the optimized mesh scales and moves with the input. Only for smooth models: where a decision hangs on the
// last bit, the results are as good as each other but not the same.
inline void check_equivariance(const Mesh& remesh, const Mesh& reference)
{
  namespace PMP = CGAL::Polygon_mesh_processing;

  auto optimized = [&](const auto& transformation) {
    Mesh mesh = remesh, moved_reference = reference;
    for(Point& p : mesh.points())
      p = transformation(p);
    for(Point& p : moved_reference.points())
      p = transformation(p);
    PMP::optimize_vertex_locations(mesh, moved_reference);
    return points_of(mesh);
  };

  const auto box = CGAL::bounding_box(reference.points().begin(), reference.points().end());
  const double size = (std::max)({ box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin() });
  const std::vector<Point> result = optimized([](const Point& p) { return p; });
  CHECK_AT_LEAST(largest_distance(result, points_of(remesh)), 1e-4 * size);

  auto check_transformation = [&](double scale, const auto& transformation) {
    std::vector<Point> expected = result;
    for(Point& p : expected)
      p = transformation(p);
    CHECK_AT_MOST(largest_distance(optimized(transformation), expected), 1e-9 * scale * size);
  };
  for(double scale : { 1e-6, 1e6 })
    check_transformation(scale, [&](const Point& p) { return CGAL::ORIGIN + scale * (p - CGAL::ORIGIN); });
  check_transformation(1, rigid_motion);
}

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_CHECK_EQUIVARIANCE_H
