// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_CREASES_OF_SURFACES_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_CREASES_OF_SURFACES_H

// Creases of the PN surface: cubes, and walks across the creases of a model.

#include "check.h"
#include "Distance_to_mesh.h"
#include "Independent_PN_mesh.h"
#include "tessellate_patches.h"
#include "mesh_quality.h"
#include "read_model.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/PN_triangle_surface.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Random.h>

#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
using PN_surface = PMP::PN_triangle_surface<Mesh>;

inline CGAL::Random generator(1);

Vector random_vector(double size)
{
  return size * Vector(generator.get_double(-1, 1), generator.get_double(-1, 1), generator.get_double(-1, 1));
}

template <typename Surface>
double distance_to(const Surface& surface, const Point& query)
{
  return std::sqrt(CGAL::squared_distance(query, surface.point(surface.project(query))));
}

inline double distance_to_cube(const Point& p)
{
  const double x = std::abs(p.x()), y = std::abs(p.y()), z = std::abs(p.z());
  const double largest = (std::max)({ x, y, z });
  if(largest <= 1)
    return 1 - largest;
  return norm(Vector((std::max)(x - 1, 0.), (std::max)(y - 1, 0.), (std::max)(z - 1, 0.)));
}

// the largest difference between the distances to the surface and to the cube
inline double deviation_from_cube(const PN_surface& surface)
{
  double deviation = 0;
  for(int i = 0; i < 1000; ++i)
  {
    const Point query = CGAL::ORIGIN + random_vector(1.3);
    deviation = (std::max)(deviation, std::abs(distance_to(surface, query) - distance_to_cube(query)));
  }
  return deviation;
}

inline void test_creases()
{
  using CGAL::parameters::edge_is_constrained_map;
  using CGAL::parameters::sharpness_angle;

  start_topic("A cube stays a cube, unless its edges are no creases");
  for(int level : { 0, 2 })
  {
    Mesh mesh = make_mesh(cube(level));
    auto none = mesh.add_property_map<Mesh::Edge_index, bool>("none", false).first;
    auto all = mesh.add_property_map<Mesh::Edge_index, bool>("all", true).first;
    CHECK_AT_MOST(deviation_from_cube(PN_surface(mesh)), 1e-12);
    CHECK_AT_MOST(deviation_from_cube(PN_surface(mesh, sharpness_angle(89))), 1e-12);
    CHECK_AT_LEAST(deviation_from_cube(PN_surface(mesh, sharpness_angle(91))), 0.01);
    CHECK_AT_LEAST(deviation_from_cube(PN_surface(mesh, edge_is_constrained_map(none))), 0.01);
    CHECK_AT_MOST(deviation_from_cube(PN_surface(mesh, edge_is_constrained_map(all))), 1e-12);
    CHECK_AT_MOST(deviation_from_cube(PN_surface(mesh, sharpness_angle(89).edge_is_constrained_map(none))), 1e-12);
    CHECK_AT_MOST(deviation_from_cube(PN_surface(mesh, edge_is_constrained_map(all).sharpness_angle(91))), 1e-12);
  }

  start_topic("The default of sharpness_angle is 40 degrees");
  for(std::size_t segments : { 8, 10 })
  {
    // a prism whose edges turn by 45 or 36 degrees
    const PN_surface surface(make_mesh(cylinder(segments, 1, 0)));
    const double angle = CGAL_PI / segments; // between two edges
    const double deviation = std::abs(distance_to(surface, Point(std::cos(angle), std::sin(angle), 0.1)));
    if(segments == 8)
      CHECK_NEAR(deviation, 1 - std::cos(angle), 1e-9);
    else
      CHECK_AT_MOST(deviation, 0.1 * (1 - std::cos(angle)));
  }
}

// Walks over the surface in small steps from the foot of a point to `goal`, which a crack would make impossible.
inline void check_walk(const PN_surface& surface, const Point& from, const Point& goal)
{
  constexpr int number_of_steps = 500;
  auto foot = surface.project(from);
  Point p = surface.point(foot);
  const double step = norm(goal - p) / number_of_steps;
  double longest = 0;
  for(int i = 0; i < 2 * number_of_steps && norm(goal - p) > step; ++i)
  {
    foot = surface.project(p + step * unit(goal - p), foot);
    const Point q = surface.point(foot);
    longest = (std::max)(longest, norm(q - p));
    p = q;
  }
  CHECK_AT_MOST(norm(goal - p), step);
  CHECK_AT_MOST(longest, 2 * step);
}

// walks from both sides to the middle of every `stride`th crease
template <typename Is_crease>
void check_walks(const Mesh& mesh, const PN_surface& surface, int stride, const Is_crease& is_crease)
{
  int count = 0;
  for(Mesh::Edge_index e : mesh.edges())
    if(!mesh.is_border(e) && is_crease(e) && ++count % stride == 0)
    {
      const Mesh::Halfedge_index h = mesh.halfedge(e);
      const Point &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h));
      const auto s = corners(mesh, mesh.face(h)), t = corners(mesh, mesh.face(mesh.opposite(h)));
      const Vector m = unit(area_vector(s)), n = unit(area_vector(t));
      const Point a = CGAL::centroid(s[0], s[1], s[2]), b = CGAL::centroid(t[0], t[1], t[2]);

      // a query on that side of the surface where the crease is closest
      const double side = (b - p) * m < 0 ? 0.1 : -0.1;
      const Point query = CGAL::midpoint(p, q) + side * norm(q - p) * (m + n);
      const Point goal = surface.point(surface.project(query));
      check_walk(surface, a, goal);
      check_walk(surface, b, goal);
    }
  CHECK_AT_LEAST(count, stride);
}

inline void test_watertight()
{
  start_topic("Both sides of a crease share its curve");
  auto is_sharp = [](const Mesh& mesh) {
    return [&mesh](Mesh::Edge_index e) {
      const Vector m = area_vector(corners(mesh, mesh.face(mesh.halfedge(e, 0))));
      const Vector n = area_vector(corners(mesh, mesh.face(mesh.halfedge(e, 1))));
      return unit(m) * unit(n) < std::sqrt(0.5);
    };
  };

  // a cylinder closed by two planar caps
  constexpr std::size_t columns = 12, rows = 4;
  Soup can = cylinder(columns, rows);
  const double height = can.points.back().z();
  const std::size_t bottom = can.points.size(), top = bottom + 1;
  can.points.emplace_back(0, 0, 0);
  can.points.emplace_back(0, 0, height);
  for(std::size_t i = 0; i < columns; ++i)
  {
    can.triangles.push_back({ bottom, (i + 1) % columns, i });
    can.triangles.push_back({ top, rows * columns + i, rows * columns + (i + 1) % columns });
  }
  const Mesh can_mesh = make_mesh(can);
  const PN_surface can_surface(can_mesh);
  check_walks(can_mesh, can_surface, 1, is_sharp(can_mesh));
  for(std::size_t i = 0; i < columns; ++i)
  {
    // between the rim's chord and its arc
    const double angle = 2 * CGAL_PI * (i + 0.5) / columns, radius = (1 + std::cos(CGAL_PI / columns)) / 2;
    CHECK_AT_MOST(distance_to(can_surface, Point(radius * std::cos(angle), radius * std::sin(angle), 0)), 1e-9);
    CHECK_AT_MOST(distance_to(can_surface, Point(radius * std::cos(angle), radius * std::sin(angle), height)), 1e-9);
  }

  const Mesh fandisk = read_model("fandisk");
  check_walks(fandisk, PN_surface(fandisk), 10, is_sharp(fandisk));

  // creases where there is none
  Mesh sphere = make_mesh(icosphere(1));
  auto is_crease = sphere.add_property_map<Mesh::Edge_index, bool>("crease", false).first;
  for(Mesh::Edge_index e : sphere.edges())
    is_crease[e] = generator.get_bool();
  check_walks(sphere, PN_surface(sphere, CGAL::parameters::edge_is_constrained_map(is_crease)), 1,
              [&](Mesh::Edge_index e) { return is_crease[e]; });
}

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_CREASES_OF_SURFACES_H
