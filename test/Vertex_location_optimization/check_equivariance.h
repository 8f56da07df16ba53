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

// Scales and moves the mesh and the reference, a `Reference` made of that mesh: calls check(result, expected, size) with the
// points of the mesh that is then optimized, those of the one that was optimized first, and the size.
template <typename Reference, typename Check>
void for_each_transformation(const Mesh& remesh,
                             const Mesh& reference,
                             CGAL::Polygon_mesh_processing::Placement_method method,
                             const Check& check)
{
  namespace PMP = CGAL::Polygon_mesh_processing;

  auto optimized = [&](const auto& transformation) {
    Mesh mesh = remesh, moved_reference = reference;
    for(Point& p : mesh.points())
      p = transformation(p);
    for(Point& p : moved_reference.points())
      p = transformation(p);
    PMP::optimize_vertex_locations(mesh, Reference(moved_reference), CGAL::parameters::placement_method(method));
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
    check(optimized(transformation), expected, scale * size);
  };
  for(double scale : { 1e-6, 1e6 })
    check_transformation(scale, [&](const Point& p) { return CGAL::ORIGIN + scale * (p - CGAL::ORIGIN); });
  check_transformation(1, rigid_motion);
}

// Checks that the optimized mesh scales and moves with the input. Only for smooth models: where a decision hangs on the
// last bit, the results are as good as each other but not the same.
template <typename Reference = Mesh>
void check_equivariance(const Mesh& remesh, const Mesh& reference)
{
  for_each_transformation<Reference>(remesh, reference, CGAL::Polygon_mesh_processing::PIECEWISE_LINEAR,
                                     [](const std::vector<Point>& result, const std::vector<Point>& expected, double size) {
                                       CHECK_AT_MOST(largest_distance(result, expected), 1e-9 * size);
                                     });
}

// The same for least squares, which decides so often that some decisions hang on the last bit; these move few vertices.
inline void check_equivariance_of_least_squares(const Mesh& remesh, const Mesh& reference)
{
  for_each_transformation<Mesh>(remesh, reference, CGAL::Polygon_mesh_processing::LEAST_SQUARES,
                                [](const std::vector<Point>& result, const std::vector<Point>& expected, double size) {
                                  double sum = 0;
                                  for(std::size_t i = 0; i < result.size(); ++i)
                                    sum += std::sqrt(CGAL::squared_distance(result[i], expected[i]));
                                  CHECK_AT_MOST(sum / result.size(), 1e-5 * size);
                                });
}

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_CHECK_EQUIVARIANCE_H
