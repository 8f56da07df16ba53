// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// For libFuzzer: makes a small remesh, a reference and parameters of the bytes, and checks what must hold whatever they
// are. The target `fuzz_optimize_vertex_locations` is built with clang if CGAL_VERTEX_LOCATION_OPTIMIZATION_FUZZING is on;
// replay.cpp runs the seeds as a test. A check that fails aborts.

#include "Byte_reader.h"
#include "../invariants.h"

#include <CGAL/Polygon_mesh_processing/approximation_error.h>
#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_normals.h>

#include <CGAL/assertions_behaviour.h>

#include <cstdlib>
#include <functional>
#include <limits>
#include <set>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::parameters;
using Report = PMP::Vertex_location_optimization_report;
using Vertex = Mesh::Vertex_index;
using Edge = Mesh::Edge_index;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// triangles between some points, as the bytes have it
Soup read_soup(Byte_reader& bytes)
{
  Soup soup;
  const std::size_t n = 3 + bytes.below(10), m = 1 + bytes.below(16);
  for(std::size_t i = 0; i < n; ++i)
  {
    const double x = bytes.coordinate(), y = bytes.coordinate();
    soup.points.emplace_back(x, y, bytes.coordinate());
  }
  for(std::size_t j = 0; j < m; ++j)
  {
    const std::size_t a = bytes.below(n), b = (a + 1 + bytes.below(n - 1)) % n, c = bytes.below(n);
    if(c != a && c != b)
      soup.triangles.push_back({ a, b, c });
  }
  return soup;
}

Soup read_shape(Byte_reader& bytes)
{
  switch(bytes.below(8))
  {
  case 0:
    return icosphere(0);
  case 1:
    return transformed(icosphere(0), rotated);
  case 2:
    return cube(0);
  case 3:
    return cylinder(5, 2);
  case 4:
    return planar_patch(2);
  case 5:
    return cube(1);
  default:
    return read_soup(bytes);
  }
}

// makes some points coincide, or be between others, or have coordinates that are none
void spoil_points(Byte_reader& bytes, std::vector<Point>& points)
{
  constexpr double specials[] = { 0, -1, 1e-300, 1e300, 1e150, 1e-17, 1e5, not_a_number, infinity, -infinity };
  const std::size_t n = points.size();
  for(std::size_t i = bytes.below(6); i > 0; --i)
  {
    Point& p = points[bytes.below(n)];
    switch(bytes.below(3))
    {
    case 0:
      p = points[bytes.below(n)];
      break;
    case 1:
      p = CGAL::midpoint(points[bytes.below(n)], points[bytes.below(n)]);
      break;
    default:
    {
      const std::size_t k = bytes.below(3);
      const double x = bytes.one_of(specials);
      p = Point(k == 0 ? x : p.x(), k == 1 ? x : p.y(), k == 2 ? x : p.z());
    }
    }
  }
}

Mesh read_mesh(Byte_reader& bytes, double scale)
{
  constexpr double amplitudes[] = { 0, 0.01, 0.1, 0.5, 3 };
  Soup soup = read_shape(bytes);
  if(const double amplitude = bytes.one_of(amplitudes); amplitude > 0)
    soup = transformed(soup, [&](const Point& p) {
      const double x = bytes.coordinate(), y = bytes.coordinate();
      return p + amplitude * Vector(x, y, bytes.coordinate());
    });
  spoil_points(bytes, soup.points);
  return make_mesh(transformed(soup, [&](const Point& p) { return CGAL::ORIGIN + scale * (p - CGAL::ORIGIN); }));
}

double largest_coordinate(const Mesh& mesh)
{
  double largest = 0;
  for(const Point& p : mesh.points())
    largest = (std::max)({ largest, std::abs(p.x()), std::abs(p.y()), std::abs(p.z()) });
  return largest;
}

// The mean distance, and the largest, at the barycenters of the parts of the faces, each of which is cut into 16 x 16.
template <typename Surface>
Errors errors_at_samples(const Mesh& mesh, const Surface& surface)
{
  constexpr int level = 16;
  Errors errors;
  double sum_of_areas = 0;
  for(Mesh::Face_index f : mesh.faces())
  {
    const std::array<Point, 3> t = corners(mesh, f);
    const double area = norm(area_vector(t));
    double sum = 0;
    auto add_distance_at = [&](int i, int j) { // in thirds of a part
      const Point p = CGAL::barycenter(t[0], 3 * level - i - j, t[1], i, t[2], j);
      const double d = norm(surface.point(surface.project(p)) - p);
      errors.max = (std::max)(errors.max, d);
      sum += d;
    };
    for(int i = 0; i < level; ++i)
      for(int j = 0; j < level - i; ++j)
      {
        add_distance_at(3 * i + 1, 3 * j + 1);
        if(i + j < level - 1)
          add_distance_at(3 * i + 2, 3 * j + 2);
      }
    errors.mean += area * sum / (level * level);
    sum_of_areas += area;
  }
  errors.mean = sum_of_areas > 0 ? errors.mean / sum_of_areas : 0;
  return errors;
}

// Between the samples the largest distance before was larger than at them. Those that are `enough` need not be exceeded.
template <typename Surface>
double largest_distance_on_lattice(const Mesh& mesh, const Surface& surface, double enough)
{
  constexpr int level = 120;
  double largest = 0;
  for(Mesh::Face_index face : mesh.faces())
  {
    const std::array<Point, 3> t = corners(mesh, face);
    for(int i = 0; i <= level; ++i)
      for(int j = 0; j <= level - i; ++j)
      {
        const Point p = CGAL::barycenter(t[0], level - i - j, t[1], i, t[2], j);
        largest = (std::max)(largest, norm(surface.point(surface.project(p)) - p));
        if(largest >= enough)
          return largest;
      }
  }
  return largest;
}

template <typename Surface>
void check_errors(const Mesh& remesh, const Mesh& mesh, const Surface& surface, double rounding)
{
  constexpr double accuracy = 2e-3; // of the means of single faces, which are larger than the reference
  const Errors before = errors_at_samples(remesh, surface), after = errors_at_samples(mesh, surface);
  if(std::isfinite(before.mean))
    CHECK_AT_MOST(after.mean, before.mean * (1 + accuracy) + rounding);
  if(std::isfinite(before.max) && !(after.max <= before.max + rounding))
    CHECK_AT_MOST(after.max, largest_distance_on_lattice(remesh, surface, after.max) * 1.001 + rounding);
}

// Ends the run in some phase, refuses the moves of some vertices, and marks some edges and vertices.
struct Choices
{
  explicit Choices(Byte_reader& bytes) : bits(bytes.byte() | bytes.byte() << 8), number_of_phases(bytes.byte()) {}

  // of 1 in 4, or none or all
  bool of(std::size_t i, int shift) const
  {
    const unsigned int kind = bits >> shift & 7;
    return kind >= 6 && (kind == 7 || (i * 2654435761u >> 7) % 4 == 0);
  }

  unsigned int bits;
  std::size_t number_of_phases; // 0: all of them
};

struct Stopping_visitor : PMP::Vertex_location_optimization_default_visitor
{
  explicit Stopping_visitor(std::size_t n) : phases_left(n == 0 ? 10000 : n) {}
  bool go_further() { return phases_left-- > 0; }

  std::size_t phases_left;
};

template <typename Surface>
void test_optimization(Byte_reader& bytes, const Mesh& remesh, const Surface& surface, double extent)
{
  constexpr double thresholds[] = { 1e-6, 0, 0.1, infinity, not_a_number, -1 };
  constexpr double weights[] = { 0.1, 0, 1, 1e10, 1e-10, infinity, not_a_number, -1 };
  Mesh mesh = remesh;
  auto vertex_is_constrained = mesh.add_property_map<Vertex, bool>("v:constrained", false).first;
  auto edge_is_constrained = mesh.add_property_map<Edge, bool>("e:constrained", false).first;
  const Choices choices(bytes);
  std::set<Vertex> fixed;
  const bool relax_constraints = bytes.boolean();
  for(Edge e : mesh.edges())
    if((edge_is_constrained[e] = choices.of(e, 0)) && !relax_constraints)
      fixed.insert({ mesh.vertex(e, 0), mesh.vertex(e, 1) });
  for(Vertex v : mesh.vertices())
  {
    vertex_is_constrained[v] = choices.of(v, 3);
    if(vertex_is_constrained[v] || choices.of(v, 6) || (!relax_constraints && mesh.is_border(v)))
      fixed.insert(v);
  }
  const auto allow_move = [&](Vertex v, const Point&, const Point&) { return !choices.of(v, 6); };
  Stopping_visitor visitor(choices.number_of_phases);

  const std::size_t number_of_iterations = 1 + bytes.below(6), number_of_free_iterations = bytes.below(4);
  const std::size_t number_of_relaxation_steps = bytes.below(4);
  const PMP::Placement_method method = bytes.boolean() ? PMP::LEAST_SQUARES : PMP::PIECEWISE_LINEAR;
  const bool do_self_intersection_tests = bytes.below(4) == 1;
  const double threshold = bytes.one_of(thresholds), weight = bytes.one_of(weights);
  const bool guarantee_both_directions = bytes.boolean() != (method == PMP::LEAST_SQUARES);
  const bool preserve_volume = bytes.below(4) == 1;
  Report report;
  try
  {
    report = PMP::optimize_vertex_locations(mesh, surface,
                                            parameters::number_of_free_iterations(number_of_free_iterations)
                                              .convergence_threshold(threshold)
                                              .placement_method(method)
                                              .regularity_weight(weight)
                                              .number_of_iterations(number_of_iterations)
                                              .number_of_relaxation_steps(number_of_relaxation_steps)
                                              .vertex_is_constrained_map(vertex_is_constrained)
                                              .edge_is_constrained_map(edge_is_constrained)
                                              .relax_constraints(relax_constraints)
                                              .do_self_intersection_tests(do_self_intersection_tests)
                                              .guarantee_both_directions(guarantee_both_directions)
                                              .preserve_volume(preserve_volume)
                                              .allow_move_functor(allow_move)
                                              .visitor(std::ref(visitor)));
  }
  catch(const CGAL::Precondition_exception&)
  {}

  check_connectivity(remesh, mesh);
  CHECK_AT_MOST(report.iterations, number_of_iterations);
  if(report.iterations == 0)
    return;
  check_finite(mesh);
  check_fixed(remesh, mesh, [&](Vertex v) { return fixed.count(v) > 0; });
  check_faces(remesh, mesh);
  check_errors(remesh, mesh, surface, 1e-13 * extent);
}

template <typename Surface>
void test_measures(Mesh mesh, const Surface& surface)
{
  auto normals = mesh.add_property_map<Vertex, Vector>("v:normal", CGAL::NULL_VECTOR).first;
  try
  {
    PMP::optimize_vertex_normals(mesh, surface, normals);
    const PMP::Approximation_error error = PMP::approximation_error(mesh, surface, parameters::number_of_points_per_face(4));
    CHECK(error.mean >= 0 && error.rms >= 0 && error.max >= 0);
    const double deviation = PMP::normal_deviation(mesh, surface, normals);
    CHECK(deviation >= 0 && deviation <= 180);
    for(Vertex v : mesh.vertices())
      CHECK_NEAR(norm(normals[v]), 1, 1e-12);
  }
  catch(const CGAL::Precondition_exception&)
  {}
}

template <typename Surface>
void test(Byte_reader& bytes, const Mesh& remesh, const Mesh& reference)
{
  constexpr double angles[] = { 45, 0, 180, -1, not_a_number, infinity };
  try
  {
    const Surface surface(reference, parameters::sharpness_angle(bytes.one_of(angles)));
    if(bytes.below(4) != 3)
      test_optimization(bytes, remesh, surface, (std::max)(largest_coordinate(remesh), largest_coordinate(reference)));
    else
      test_measures(remesh, surface);
  }
  catch(const CGAL::Precondition_exception&)
  {} // of the surface
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  constexpr double scales[] = { 1, 1e-6, 1e6, 1e-140, 1e140, 1e160, 1e300 };
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {}); // no words, only exceptions
  Byte_reader bytes(data, size);
  const double scale = bytes.one_of(scales);
  const Mesh remesh = read_mesh(bytes, scale), reference = bytes.boolean() ? remesh : read_mesh(bytes, scale);
  if(bytes.boolean())
    test<PMP::Flat_triangle_surface<Mesh>>(bytes, remesh, reference);
  else
    test<PMP::PN_triangle_surface<Mesh>>(bytes, remesh, reference);
  if(check::counts().failures > 0)
    std::abort();
  return 0;
}
