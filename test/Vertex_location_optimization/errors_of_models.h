// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_ERRORS_OF_MODELS_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_ERRORS_OF_MODELS_H

// Errors of models and maxima between the samples, against an independent program, closed forms and brute force.

#include "check.h"
#include "Distance_to_mesh.h"
#include "remeshes.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/approximation_error.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>

namespace PMP = CGAL::Polygon_mesh_processing;
using Flat_surface = PMP::Flat_triangle_surface<Mesh>;

// a unit sphere with no more than the concept has
struct Exact_sphere
{
  using Point_3 = Point;
  using Vector_3 = Vector;
  struct Foot
  {
    Vector direction;
  };

  Foot project(const Point& p) const
  {
    const Vector v = p - CGAL::ORIGIN;
    return { v / std::sqrt(v.squared_length()) };
  }
  Foot project(const Point& p, const Foot&) const { return project(p); }
  Point point(const Foot& foot) const { return CGAL::ORIGIN + foot.direction; }
  Vector normal(const Foot& foot) const { return foot.direction; }
};

template <typename F>
Mesh moved(const Soup& soup, const F& f)
{
  return make_mesh(transformed(soup, f));
}

inline double area(const Mesh& mesh, Mesh::Face_index f)
{
  const Mesh::Halfedge_index h = mesh.halfedge(f);
  return std::sqrt(
    CGAL::squared_area(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h)))));
}

// Models of CGAL, moved by a formula, against what an independent program says of them. The figures are relative to the
// longest side of the bounding box.
inline void test_models()
{
  start_topic("models of CGAL");
  struct Figures
  {
    const char* name;
    double mean, rms, max;
  };
  for(const Figures& figures :
      { Figures{ "armadillo", 57.0221e-4, 67.4302e-4, 169.259e-4 }, Figures{ "knot1", 54.3765e-4, 64.6299e-4, 165.232e-4 },
        Figures{ "fandisk", 58.2218e-4, 66.2516e-4, 156.001e-4 } })
  {
    const Mesh reference = read_model(figures.name);
    CGAL::Bbox_3 box;
    for(const Point& p : reference.points())
      box += p.bbox();
    const double side = (std::max)({ box.x_span(), box.y_span(), box.z_span() });

    Mesh mesh = reference;
    for(Point& p : mesh.points())
    {
      const double x = p.x() / side, y = p.y() / side, z = p.z() / side;
      p = p + 0.01 * side * Vector(std::sin(37 * y), std::sin(41 * z), std::sin(43 * x));
    }
    const PMP::Approximation_error e =
      PMP::approximation_error<CGAL::Parallel_if_available_tag>(mesh, Flat_surface(reference));
    CHECK_NEAR(e.mean / side, figures.mean, 0.01 * figures.mean);
    CHECK_NEAR(e.rms / side, figures.rms, 0.01 * figures.rms);
    CHECK_NEAR(e.max / side, figures.max, 0.01 * figures.max);
  }
}

inline void test_maximum_between_samples()
{
  start_topic("a maximum at the midpoint of an edge");
  // a slab without two of its sides, and two triangles across it, whose common edge is farthest in the middle of the slab
  const Mesh slab = make_mesh(Soup{ { Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(1, 1, 0), Point(0, 0, .1),
                                      Point(1, 0, .1), Point(0, 1, .1), Point(1, 1, .1) },
                                    { { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 } } });
  const Mesh mesh = make_mesh(
    Soup{ { Point(.2, .5, 0), Point(.8, .5, .1), Point(.5, .2, .1), Point(.5, .8, .1) }, { { 0, 2, 1 }, { 0, 1, 3 } } });
  using CGAL::parameters::number_of_points_per_face;
  CHECK_NEAR(PMP::approximation_error(mesh, Flat_surface(slab)).max, 0.05, 1e-4);
  CHECK_NEAR(PMP::approximation_error(mesh, Flat_surface(slab), number_of_points_per_face(1)).max, 0.05, 1e-4);
}

// One face that is as large as thousands of the reference: a plane that cuts the unit sphere at height z.
inline void test_large_face()
{
  start_topic("a large face over a sphere");
  const double z = 0.9, radius = 2;
  const auto corner = [&](int k) {
    return Point(radius * std::cos(2 * CGAL_PI * k / 3), radius * std::sin(2 * CGAL_PI * k / 3), z);
  };
  const Mesh mesh = make_mesh(Soup{ { corner(0), corner(1), corner(2) }, { { 0, 1, 2 } } });
  const auto distance = [&](const Point& p) { return std::abs(std::sqrt((p - CGAL::ORIGIN).squared_length()) - 1); };

  double sum = 0, sum_of_squares = 0;
  constexpr int level = 1000;
  for(int i = 0; i < level; ++i)
    for(int j = 0; j < level - i; ++j)
      for(const double offset : { 1 / 3., 2 / 3. })
        if(offset < 0.5 || i + j + 1 < level)
        {
          const double u = (i + offset) / level, v = (j + offset) / level;
          const double d = distance(corner(0) + (u * (corner(1) - corner(0)) + v * (corner(2) - corner(0))));
          sum += d;
          sum_of_squares += d * d;
        }
  const double mean = sum / (level * level), rms = std::sqrt(sum_of_squares / (level * level));

  const Mesh sphere = make_mesh(icosphere(6)); // up to 2e-4 inside
  for(const PMP::Approximation_error& e :
      { PMP::approximation_error(mesh, Exact_sphere()), PMP::approximation_error(mesh, Flat_surface(sphere)) })
  {
    CHECK_NEAR(e.mean, mean, 0.002 * mean);
    CHECK_NEAR(e.rms, rms, 0.002 * rms);
    CHECK_NEAR(e.max, distance(corner(0)), 1e-3);
  }
}

// A thin bump of a plane over a face that it is a hundredth of: the rest of the distance is zero.
inline void test_narrow_maximum()
{
  start_topic("a narrow maximum");
  const Point top(0.77, 0.21, 0);
  const Mesh reference = moved(planar_patch(50), [&](const Point& q) {
    const Point p(q.x() / 50, q.y() / 50, 0);
    return Point(p.x(), p.y(), 0.1 * std::exp(-CGAL::squared_distance(p, top) / CGAL::square(0.03)));
  });
  const Mesh mesh = make_mesh(
    Soup{ { Point(.1, .1, 0), Point(.9, .1, 0), Point(.9, .9, 0), Point(.1, .9, 0) }, { { 0, 1, 2 }, { 0, 2, 3 } } });
  const Distance_to_mesh distance_to(reference);
  double largest = 0;
  for(int i = -100; i <= 100; ++i)
    for(int j = -100; j <= 100; ++j)
      largest = (std::max)(largest, distance_to(top + 1e-3 * Vector(i, j, 0)));
  CHECK_LESS(0.01, largest);
  CHECK_NEAR(PMP::approximation_error(mesh, Flat_surface(reference)).max, largest, 0.01 * largest);
}

// `mesh` to `reference`, on a dense lattice on each face
inline PMP::Approximation_error measure_by_brute_force(const Mesh& mesh, const Mesh& reference)
{
  constexpr int level = 30; // 900 points a face
  const Distance_to_mesh distance_to(reference);
  PMP::Approximation_error e;
  double sum_of_areas = 0;
  for(Mesh::Face_index f : mesh.faces())
  {
    const auto t = corners(mesh, f);
    const double weight = area(mesh, f) / (level * level);
    Point hint = reference.point(*reference.vertices().begin());
    for(int i = 0; i < level; ++i)
      for(int j = 0; j < level - i; ++j)
        for(const double offset : { 1 / 3., 2 / 3. })
          if(offset < 0.5 || i + j + 1 < level)
          {
            const double u = (i + offset) / level, v = (j + offset) / level;
            const double d = distance_to(t[0] + (u * (t[1] - t[0]) + v * (t[2] - t[0])), hint);
            e.mean += weight * d;
            e.rms += weight * d * d;
            e.max = (std::max)(e.max, d);
          }
    sum_of_areas += area(mesh, f);
  }
  e.mean /= sum_of_areas;
  e.rms = std::sqrt(e.rms / sum_of_areas);
  return e;
}

inline void test_real_models()
{
  start_topic("brute force, and CGAL's bounded distance");
  for(const auto& [name, length] : { std::pair("knot1", 0.08), std::pair("fandisk", 0.08) })
  {
    const Mesh input = read_model(name);
    const Mesh remesh = make_remesh(input, length);
    for(const auto& [from, to] : { std::pair(&remesh, &input), std::pair(&input, &remesh) })
    {
      const PMP::Approximation_error e = PMP::approximation_error<CGAL::Parallel_if_available_tag>(*from, Flat_surface(*to)),
                                     truth = measure_by_brute_force(*from, *to);
      CHECK_NEAR(e.mean, truth.mean, 0.003 * truth.mean);
      CHECK_NEAR(e.rms, truth.rms, 0.006 * truth.rms);
      CHECK_AT_LEAST(e.max, 0.999 * truth.max);
      const double bound = PMP::bounded_error_Hausdorff_distance<CGAL::Sequential_tag>(*from, *to, 0.005 * truth.max);
      CHECK_NEAR(e.max, bound, 0.02 * bound);
    }
  }
}

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_ERRORS_OF_MODELS_H
