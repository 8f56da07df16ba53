// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_OPTIMIZE_PARTS_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_OPTIMIZE_PARTS_H

// Parts as a CAD kernel tessellates them, beside the exact surfaces, and remeshes along their creases.

#include "check.h"
#include "mesh_quality.h"
#include "parts.h"
#include "tessellate_patches.h"

#include <CGAL/bounding_box.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Polygon_mesh_processing/PN_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
using PN_surface = PMP::PN_triangle_surface<Mesh>;
using Edge_map = Mesh::Property_map<Mesh::Edge_index, bool>;

inline CGAL::Random generator(1);

Vector random_vector(double size)
{
  return size * Vector(generator.get_double(-1, 1), generator.get_double(-1, 1), generator.get_double(-1, 1));
}

// Calls f(weight, point) for points spread over the faces, whose weights sum up to the area.
template <typename F>
void for_each_face_sample(const Mesh& mesh, const int level, const F& f)
{
  for(Mesh::Face_index face : mesh.faces())
  {
    const std::array<Point, 3> t = corners(mesh, face);
    const double weight = norm(area_vector(t)) / (level * level);
    for(int i = 0; i < level; ++i)
      for(int j = 0; j < level - i; ++j)
        for(int half = 0; half < (j < level - i - 1 ? 2 : 1); ++half)
        {
          const double u = (i + (1 + half) / 3.) / level, v = (j + (1 + half) / 3.) / level;
          f(weight, t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]));
        }
  }
}

// the mean over the faces of g(point)
template <typename G>
double mean_over_faces(const Mesh& mesh, const G& g)
{
  double sum = 0, area = 0;
  for_each_face_sample(mesh, 8, [&](double weight, const Point& p) {
    sum += weight * g(p);
    area += weight;
  });
  return sum / area;
}

inline double size_of(const Mesh& mesh)
{
  const auto box = CGAL::bounding_box(mesh.points().begin(), mesh.points().end());
  return std::sqrt(CGAL::squared_distance((box.min)(), (box.max)()));
}

// A part, and how large the mean distance from the exact surface may be: that of the PN surface relative to the flat mesh,
// and that of a remesh after the optimization relative to before.
struct Case
{
  Part part;
  double surface_limit;
  double remesh_limit;
};

Profile fillet(double radius, int steps)
{
  return Profile({ 0, 0 }).line_to({ 10, 0 }).arc({ 10, radius }, CGAL_PI / 2, steps).line_to({ 10 + radius, radius + 10 });
}

Profile chamfer(double angle, double height)
{
  const double x = 5 + std::cos(angle), y = std::sin(angle);
  return Profile({ 0, 0 }).line_to({ 5, 0 }).line_to({ x, y }).line_to({ x, y + height });
}

inline std::vector<Case> make_cases()
{
  const double pi = CGAL_PI;
  const auto capsule = [&](int n) {
    return Profile({ 0, -1 }).arc({ 0, 0 }, pi / 2, n / 4).line_to({ 1, 3 }).arc({ 0, 3 }, pi / 2, n / 4);
  };
  const auto circle = [&](int steps) { return Profile({ 3, 0 }).arc({ 2, 0 }, 2 * pi, steps); };
  const auto half_circle = [&](int steps) { return Profile({ 0, -1 }).arc({ 0, 0 }, pi, steps); };
  const auto cylinder = Profile({ 1, 0 }).line_to({ 1, 4 });
  const auto cone = Profile({ 1, 0 }).line_to({ 0, 2 });

  std::vector<Case> cases;
  cases.push_back({ revolved("cylinder, 12 segments", cylinder, 12), 0.05, 0.2 });
  cases.push_back({ revolved("cylinder, 32 segments", cylinder, 32), 0.01, 0.2 });
  for(double radius : { 0.2, 1. })
    for(int steps : { 2, 4, 8 })
      cases.push_back({ extruded("fillet, radius " + std::to_string(radius) + ", " + std::to_string(steps) + " steps",
                                 fillet(radius, steps), 5),
                        steps == 2 ? 1.05 : 0.05, steps == 2 ? 1.05 : 0.7 });
  cases.push_back({ extruded("fillet with alternating diagonals", fillet(1, 4), 5, Diagonals::ALTERNATING), 0.05, 0.4 });
  cases.push_back({ revolved("cone, 12 segments", cone, 12), 0.35, 0.4 });
  cases.push_back({ revolved("cone, 32 segments", cone, 32), 0.35, 0.4 });
  cases.push_back({ revolved("torus, 12 x 6", circle(6), 12), 0.9, 0.95 });
  cases.push_back({ revolved("torus, 32 x 16", circle(16), 32), 0.05, 0.2 });
  cases.push_back({ revolved("capsule, 12 segments", capsule(12), 12), 0.15, 0.2 });
  cases.push_back({ revolved("capsule, 24 segments", capsule(24), 24), 0.06, 0.2 });
  cases.push_back({ revolved("sphere, 16 x 8", half_circle(8), 16), 0.06, 0.1 });
  cases.push_back(
    { revolved("boss with a fillet", Profile({ 5, 0 }).line_to({ 2, 0 }).arc({ 2, 1 }, -pi / 2, 6).line_to({ 1, 3 }), 24),
      0.1, 0.6 });
  cases.push_back(
    { revolved("plate with a rounded rim", Profile({ 0, 0 }).line_to({ 4, 0 }).arc({ 4, 0.5 }, pi, 6).line_to({ 0, 1 }), 24),
      0.1, 0.35 });
  cases.push_back(
    { extruded("slot", Profile({ 0, 0 }).line_to({ 2, 0 }).arc({ 2, 0.5 }, pi, 8).line_to({ 0, 1 }).arc({ 0, 0.5 }, pi, 8),
               1),
      0.15, 0.4 });
  cases.push_back({ revolved("countersink of 120 degrees",
                             Profile({ 5, 0 }).line_to({ 2, 0 }).line_to({ 1, -1 / std::sqrt(3.) }).line_to({ 1, -3 }), 24),
                    0.35, 0.5 });
  cases.push_back(
    { revolved("countersink of 90 degrees", Profile({ 5, 0 }).line_to({ 2, 0 }).line_to({ 1, -1 }).line_to({ 1, -3 }), 24),
      0.05, 0.5 });
  cases.push_back(
    { revolved("plate with a hole", Profile({ 5, 0 }).line_to({ 1, 0 }).line_to({ 1, -2 }).line_to({ 5, -2 }), 24), 0.05,
      0.5 });
  return cases;
}

// a remesh along the creases, which are marked
inline Mesh remesh_along_creases(Mesh mesh, const double length, Edge_map& is_crease)
{
  is_crease = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_crease", false).first;
  PMP::detect_sharp_edges(mesh, 40, is_crease);
  std::vector<Mesh::Edge_index> features;
  for(Mesh::Edge_index e : mesh.edges())
  {
    is_crease[e] = is_crease[e] || mesh.is_border(e);
    if(is_crease[e])
      features.push_back(e);
  }
  PMP::split_long_edges(features, length, mesh, CGAL::parameters::edge_is_constrained_map(is_crease));
  PMP::isotropic_remeshing(faces(mesh), length, mesh,
                           CGAL::parameters::number_of_iterations(5)
                             .number_of_relaxation_steps(3)
                             .edge_is_constrained_map(is_crease)
                             .protect_constraints(true));
  mesh.collect_garbage();
  return mesh;
}

inline void test_exact_surfaces()
{
  for(const Case& c : make_cases())
  {
    start_topic(c.part.name);
    const Mesh& mesh = c.part.mesh;
    const PN_surface surface(mesh);
    const double of_mesh = mean_over_faces(mesh, c.part.distance);
    const double of_surface =
      mean_over_faces(mesh, [&](const Point& p) { return c.part.distance(surface.point(surface.project(p))); });
    std::cout << "  surface " << of_surface / of_mesh << " of the flat mesh; after / before the optimization";
    CHECK_AT_MOST(of_surface / of_mesh, c.surface_limit);

    Edge_map is_crease;
    const Mesh remesh = remesh_along_creases(mesh, 0.04 * size_of(mesh), is_crease);
    const double before = mean_over_faces(remesh, c.part.distance);
    for(PMP::Placement_method method : { PMP::PIECEWISE_LINEAR, PMP::LEAST_SQUARES })
    {
      Mesh optimized = remesh;
      PMP::optimize_vertex_locations(optimized, mesh,
                                     CGAL::parameters::placement_method(method).edge_is_constrained_map(is_crease));
      const double after = mean_over_faces(optimized, c.part.distance);
      std::cout << " " << after / before;
      CHECK_AT_MOST(after / before, c.remesh_limit);
    }
    std::cout << std::endl;
  }
}

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_OPTIMIZE_PARTS_H
