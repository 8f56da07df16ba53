// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_INVALID_INPUT_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_INVALID_INPUT_H

// Meshes with degenerate and with invalid faces, and checks of what is made of them.

#include "check.h"
#include "check_violation.h"
#include "mesh_quality.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/attribute_error.h>
#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_attributes.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Polygon_mesh_processing/remesh_within_tolerance.h>
#include <CGAL/Polygon_mesh_processing/transfer_face_attributes.h>

#include <CGAL/assertions_behaviour.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace PMP = CGAL::Polygon_mesh_processing;
using Report = PMP::Vertex_location_optimization_report;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;

// bit by bit, so that a NaN is the same as itself
inline bool are_same(const std::vector<Point>& a, const std::vector<Point>& b)
{
  bool same = a.size() == b.size();
  for(std::size_t i = 0; same && i < a.size(); ++i)
    for(int k = 0; k < 3; ++k)
    {
      const double x = a[i][k], y = b[i][k];
      same = same && std::memcmp(&x, &y, sizeof(double)) == 0;
    }
  return same;
}

template <typename Reference>
void check_refused(const Mesh& input, const Reference& reference)
{
  Mesh mesh = input;
  Report report;
  const bool has_thrown = violates_precondition([&] { report = PMP::optimize_vertex_locations(mesh, reference); });
  CHECK_EQUAL(has_thrown, checks_are_on);
  CHECK_EQUAL(report.iterations, 0u);
  CHECK(are_same(points_of(mesh), points_of(input)));
}

// the result, which is finite
template <typename Reference>
std::vector<Point> check_finite(const Mesh& input, const Reference& reference)
{
  Mesh mesh = input;
  const Report report = PMP::optimize_vertex_locations<CGAL::Parallel_if_available_tag>(mesh, reference);
  for(const Point& p : mesh.points())
    CHECK(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()));
  CHECK(std::isfinite(report.displacement));
  CHECK_AT_MOST(report.iterations, 30u);
  CHECK_EQUAL(mesh.number_of_faces(), input.number_of_faces());
  return points_of(mesh);
}

// the result, which is finite and stays near the input, whose extent is about 1
template <typename Reference>
std::vector<Point> check_sane(const Mesh& input, const Reference& reference)
{
  const std::vector<Point> points = check_finite(input, reference);
  CHECK_AT_MOST(largest_distance(points, points_of(input)), 0.5);
  return points;
}

inline Mesh scaled(Mesh mesh, double scale)
{
  for(Point& p : mesh.points())
    p = CGAL::ORIGIN + scale * (p - CGAL::ORIGIN);
  return mesh;
}

// faces of no area: edges of length 0, corners on the opposite edge, and needles
inline Mesh with_degenerate_faces(Mesh mesh)
{
  for(unsigned int i = 0; i < mesh.number_of_halfedges(); i += 97)
    mesh.point(mesh.target(Halfedge(i))) = mesh.point(mesh.source(Halfedge(i)));
  for(unsigned int i = 40; i < mesh.number_of_halfedges(); i += 97)
    mesh.point(mesh.target(mesh.next(Halfedge(i)))) =
      CGAL::midpoint(mesh.point(mesh.source(Halfedge(i))), mesh.point(mesh.target(Halfedge(i))));
  for(unsigned int i = 70; i < mesh.number_of_halfedges(); i += 97)
  {
    const Point &p = mesh.point(mesh.source(Halfedge(i))), &q = mesh.point(mesh.target(Halfedge(i)));
    mesh.point(mesh.target(Halfedge(i))) = p + 1e-15 * (q - p);
  }
  return mesh;
}

// a face with two corners, or a dead end of an edge in a face, which goes there and back
inline std::vector<Mesh> with_invalid_faces(const Mesh& mesh)
{
  std::vector<Mesh> results(2, mesh);
  const Halfedge h(5);
  CGAL::Euler::split_face(h, mesh.next(h), results[0]);

  Mesh& other = results[1];
  const Halfedge there = other.add_edge(other.target(h), other.add_vertex(CGAL::ORIGIN)), back = other.opposite(there);
  other.set_halfedge(other.target(there), there);
  for(Halfedge end : { there, back })
    other.set_face(end, other.face(h));
  other.set_next(back, other.next(h));
  other.set_next(there, back);
  other.set_next(h, there);
  return results;
}

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_INVALID_INPUT_H
