// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Attributes that are known, and what attributes must be on any input.

#include "add_attributes.h"
#include "check.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/attribute_error.h>
#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_attributes.h>
#include <CGAL/Polygon_mesh_processing/PN_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/transfer_face_attributes.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

// the signal of a map at the closest point to p
template <typename AnySurface>
double sample(const Mesh& mesh, const AnySurface& surface, const Vertex_map<double>& map, const Point& p)
{
  const auto [f, x] = surface.location(surface.project(p));
  const Halfedge h = mesh.halfedge(f);
  return x[0] * map[mesh.source(h)] + x[1] * map[mesh.target(h)] + x[2] * map[mesh.target(mesh.next(h))];
}

template <typename AnySurface>
Vertex_map<double> add_samples(Mesh& mesh, const Mesh& reference, const AnySurface& surface, const Vertex_map<double>& map)
{
  return add_map_of(mesh, [&](const Point& p) { return sample(reference, surface, map, p); });
}

// Any piecewise linear signal is reproduced by its own mesh, whatever its size.
void test_own_mesh()
{
  for(const double scale : { 1., 1e-6, 1e6 })
  {
    start_topic("a mesh as its own reference, scaled by " + std::to_string(scale));
    Mesh mesh =
      make_mesh(transformed(icosphere(2), [&](const Point& p) { return CGAL::ORIGIN + scale * (p - CGAL::ORIGIN); }));
    CGAL::Random random(2);
    const auto map = add_map_of(mesh, [&](const Point&) { return random.get_double(-1, 1); });
    const auto result = add_vertex_map<double>(mesh);
    PMP::optimize_vertex_attributes(mesh, Flat_surface(mesh), map, result);
    for(Vertex v : mesh.vertices())
      CHECK_NEAR(result[v], map[v], 1e-10);
    CHECK_NEAR(PMP::attribute_error(mesh, Flat_surface(mesh), map, result).max, 0., 1e-10);
  }
}

void test_fit()
{
  start_topic("a smooth signal on a sphere");
  Mesh mesh = make_mesh(transformed(icosphere(3), rotated)), reference = make_mesh(icosphere(5));
  const Surface surface(reference);
  const auto signal = add_map_of(reference, wave);
  const auto sampled = add_samples(mesh, reference, surface, signal);
  const auto fitted = add_vertex_map<double>(mesh);
  PMP::optimize_vertex_attributes(mesh, surface, signal, fitted, parameters::clamp_to_samples(false));
  const auto error = PMP::attribute_error(mesh, surface, signal, fitted);
  CHECK_LESS(error.mean, 0.6 * PMP::attribute_error(mesh, surface, signal, sampled).mean);

  start_topic("no change of a value makes the mean square smaller");
  for(const unsigned int v : { 0u, 17u, 100u, 333u })
    for(const double step : { -0.5, 0.5 })
    {
      const double value = fitted[Vertex(v)];
      fitted[Vertex(v)] += step * error.rms;
      CHECK_LESS(error.rms, PMP::attribute_error(mesh, surface, signal, fitted).rms);
      fitted[Vertex(v)] = value;
    }

  start_topic("a signal that is finer than the faces is averaged");
  // +1 and -1 at the vertices of a fine grid in turn, of which the coarse mesh has only such with +1
  Mesh coarse =
    make_mesh(transformed(triangle_grid(6, 6, false, 0), [](const Point& p) { return Point(8 * p.x(), 8 * p.y(), 0); }));
  Mesh fine = make_mesh(triangle_grid(48, 48, false, 0));
  const auto board = add_map_of(fine, [](const Point& p) { return std::lround(p.x() + p.y()) % 2 == 0 ? 1. : -1.; });
  const auto averages = add_vertex_map<double>(coarse);
  PMP::optimize_vertex_attributes(coarse, Flat_surface(fine), board, averages);
  for(Vertex v : coarse.vertices())
  {
    CHECK_NEAR(sample(fine, Flat_surface(fine), board, coarse.point(v)), 1., 1e-12);
    CHECK_AT_MOST(std::abs(averages[v]), 0.5);
  }
}

void test_clamping()
{
  start_topic("values in the range of the samples");
  Mesh mesh = make_mesh(planar_patch(12)),
       reference =
         make_mesh(transformed(triangle_grid(60, 60), [](const Point&p) { return Point(p.x() / 5, p.y() / 5, 0); }));
  const auto step = add_map_of(reference, [](const Point& p) { return p.x() < 6 ? 0. : 1.; });
  const auto waves = add_map_of(reference, [](const Point& p) { return std::cos(CGAL_PI * p.x() / 2); });
  const auto values = add_vertex_map<double>(mesh);
  const Flat_surface surface(reference);
  const auto largest = [&] {
    double largest = 0;
    for(Vertex v : mesh.vertices())
      largest = (std::max)(largest, std::abs(values[v]));
    return largest;
  };
  PMP::optimize_vertex_attributes(mesh, surface, waves, values);
  CHECK_AT_MOST(largest(), 1);
  PMP::optimize_vertex_attributes(mesh, surface, waves, values,
                                  parameters::clamp_to_samples(false).vertex_point_map(mesh.points()));
  CHECK_LESS(1.1, largest());

  PMP::optimize_vertex_attributes(mesh, surface, step, values);
  for(Vertex v : mesh.vertices())
  {
    CHECK(values[v] >= 0 && values[v] <= 1);
    if(mesh.point(v).x() < 4.5) // all faces around it are left of the step
      CHECK_EQUAL(values[v], 0.);
  }

  start_topic("never worse than the samples at the vertices, in the mean");
  for(const bool clamp : { true, false })
    for(const auto& signal : { step, waves })
    {
      PMP::optimize_vertex_attributes(mesh, surface, signal, values, parameters::clamp_to_samples(clamp));
      const auto sampled = add_samples(mesh, reference, surface, signal);
      // but for the samples of the measurement, which are others
      CHECK_AT_MOST(PMP::attribute_error(mesh, surface, signal, values).mean,
                    1.02 * PMP::attribute_error(mesh, surface, signal, sampled).mean);
    }
}

void test_error()
{
  start_topic("the error of an attribute");
  Mesh mesh = make_mesh(triangle_grid(5, 5, false, 0)), reference = make_mesh(triangle_grid(9, 9));
  for(Point& p : reference.points())
    p = Point(p.x() - 2, p.y() - 2, 0);
  const auto linear = [](const Point& p) { return Vector(1 + p.x(), p.y() - p.x(), 2); };
  const auto signal = add_map_of(reference, linear);
  const auto shifted = add_map_of(mesh, [&](const Point& p) { return linear(p) + Vector(3, 0, -4); });
  auto error = PMP::attribute_error(mesh, reference, signal, shifted);
  CHECK_NEAR(error.mean, 5, 1e-12);
  CHECK_NEAR(error.rms, 5, 1e-12);
  CHECK_NEAR(error.max, 5, 1e-12);

  // x over [0, 5]: the mean is 5 / 2, the root mean square 5 / sqrt(3), the maximum 5
  const auto sheared = add_map_of(mesh, [&](const Point& p) { return linear(p) + Vector(0, 0.6 * p.x(), 0.8 * p.x()); });
  for(const unsigned int n : { 6u, 64u, 200u })
  {
    error = PMP::attribute_error(mesh, reference, signal, sheared, parameters::number_of_points_per_face(n));
    CHECK_NEAR(error.mean, 2.5, 1e-10);
    CHECK_NEAR(error.rms, 5 / std::sqrt(3.), 1e-10);
    CHECK_NEAR(error.max, 5, 1e-10);
  }
  const Mesh nothing;
  CHECK_EQUAL(PMP::attribute_error(nothing, reference, signal, Vertex_map<Vector>()).max, 0);
}

void test_threads()
{
  start_topic("any number of threads");
  const auto squashed = [](const Point& p) { return rigid_motion(Point(p.x(), p.y(), 0.6 * p.z())); };
  Mesh mesh = make_mesh(transformed(icosphere(2), squashed)), reference = make_mesh(transformed(icosphere(4), squashed));
  const auto signal = add_corner_map<double>(reference); // with a seam along the equator
  for(Halfedge h : reference.halfedges())
  {
    const auto center = reference.point(reference.source(h)).x() + reference.point(reference.target(reference.next(h))).x();
    signal[h] = wave(reference.point(reference.target(h))) + (center > 1 ? 1 : 0);
  }
  const auto expected = add_corner_map<double>(mesh), other = add_corner_map<double>(mesh);
  PMP::optimize_vertex_attributes(mesh, reference, signal, expected);
  const auto is_same = [&] {
    return std::all_of(mesh.halfedges().begin(), mesh.halfedges().end(),
                       [&](Halfedge h) { return expected[h] == other[h]; });
  };
#ifdef CGAL_LINKED_WITH_TBB
  for(const int threads : { 1, 2, 5 })
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    PMP::optimize_vertex_attributes<CGAL::Parallel_tag>(mesh, reference, signal, other);
    CHECK(is_same());
  }
#endif
  PMP::optimize_vertex_attributes<CGAL::Parallel_if_available_tag>(mesh, Surface(reference), signal, other);
  CHECK(is_same());
}

void test_any_input()
{
  start_topic("finite values on any input");
  // an isolated vertex, a face without an area with vertices of its own, and one that shares two
  Mesh mesh = make_mesh(planar_patch(3));
  const Vertex isolated = mesh.add_vertex(Point(1, 1, 1));
  mesh.add_face(mesh.add_vertex(Point(0, 0, 2)), mesh.add_vertex(Point(1, 0, 2)), mesh.add_vertex(Point(2, 0, 2)));
  for(Halfedge h : mesh.halfedges())
    if(mesh.is_border(h))
    {
      const auto v = mesh.add_vertex(CGAL::midpoint(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
      mesh.add_face(mesh.source(h), mesh.target(h), v);
      break;
    }
  Mesh plane = make_mesh(triangle_grid(3, 3));
  Mesh needle;
  needle.add_face(needle.add_vertex(Point(0, 0, 0)), needle.add_vertex(Point(1, 0, 0)), needle.add_vertex(Point(2, 0, 0)));

  const auto result = add_vertex_map<double>(mesh);
  const auto corner_result = add_corner_map<double>(mesh);
  for(Mesh* reference : { &mesh, &plane, &needle })
  {
    const auto linear = add_map_of(*reference, [](const Point& p) { return 5 + p.x(); });
    PMP::optimize_vertex_attributes(mesh, *reference, linear, result);
    PMP::optimize_vertex_attributes(mesh, *reference, linear, corner_result, parameters::clamp_to_samples(false));
    for(Vertex v : mesh.vertices())
      CHECK(result[v] >= 5 && result[v] <= 9);
    for(Halfedge h : mesh.halfedges())
      CHECK(mesh.is_border(h) || std::isfinite(corner_result[h]));
    CHECK(std::isfinite(PMP::attribute_error(mesh, *reference, linear, result).rms));
    const auto label = add_face_map<int>(*reference), labels = add_face_map<int>(mesh);
    for(Face f : reference->faces())
      label[f] = 3;
    PMP::transfer_face_attributes(mesh, *reference, label, labels);
    for(Face f : mesh.faces())
      CHECK_EQUAL(labels[f], 3);
  }
  PMP::optimize_vertex_attributes(mesh, plane, add_map_of(plane, [](const Point& p) { return p.x(); }), result);
  CHECK_NEAR(result[isolated], 1., 1e-12);
}

void test_scales()
{
  start_topic("huge and tiny coordinates and values");
  for(const double scale : { 1e-300, 1e-160, 1e-100, 1e100, 1e160, 1e300 })
    for(const double height : { 1e-300, 1., 1e300 })
    {
      const auto scaled = [&](const Point& p) { return CGAL::ORIGIN + scale * (p - CGAL::ORIGIN); };
      Mesh sphere = make_mesh(transformed(icosphere(1), scaled)), reference = make_mesh(transformed(icosphere(2), scaled));
      CGAL::Random random(4);
      const auto signal = add_map_of(reference, [&](const Point&) { return random.get_double(-height, height); });
      const auto values = add_vertex_map<double>(sphere);
      PMP::optimize_vertex_attributes(sphere, reference, signal, values);
      for(Vertex v : sphere.vertices())
        CHECK(std::abs(values[v]) <= height);
      PMP::optimize_vertex_attributes(sphere, reference, signal, values, parameters::clamp_to_samples(false));
      for(Vertex v : sphere.vertices())
        CHECK(std::isfinite(values[v]));
      CHECK(!std::isnan(PMP::attribute_error(sphere, reference, signal, values).rms));
    }
  Mesh empty, plane = make_mesh(triangle_grid(3, 3));
  PMP::optimize_vertex_attributes(empty, plane, add_map_of(plane, wave), add_vertex_map<double>(empty));
}

int main()
{
  test_own_mesh();
  test_fit();
  test_clamping();
  test_error();
  test_threads();
  test_any_input();
  test_scales();
  return test_result();
}
