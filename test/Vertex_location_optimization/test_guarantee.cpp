// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the report says of the errors is what brute force measures, on remeshes, on simplified meshes, and on results that
// are optimized again; neither direction gets worse; the volume is preserved if that is asked for; and a call that throws
// leaves the mesh as it was.

#include "check.h"
#include "Distance_to_mesh.h"
#include "mesh_quality.h"
#include "remeshes.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Polygon_mesh_processing/PN_triangle_surface.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_count_stop_predicate.h>
#else
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#endif

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMS = CGAL::Surface_mesh_simplification;
namespace params = CGAL::parameters;

using Vertex = Mesh::Vertex_index;
using Flat_surface = PMP::Flat_triangle_surface<Mesh>;

#if CGAL_VERSION_NR >= 1060000000
using Stop_predicate = SMS::Edge_count_stop_predicate<Mesh>;
#else
using Stop_predicate = SMS::Count_stop_predicate<Mesh>;
#endif

Mesh simplified(Mesh mesh, std::size_t number_of_edges)
{
  SMS::edge_collapse(mesh, Stop_predicate(number_of_edges));
  mesh.collect_garbage();
  return mesh;
}

Mesh simplified_by_quadrics(Mesh mesh, std::size_t number_of_edges)
{
  const SMS::GarlandHeckbert_plane_policies<Mesh, Kernel> policies(mesh);
  SMS::edge_collapse(mesh, Stop_predicate(number_of_edges),
                     params::get_cost(policies.get_cost())
                       .get_placement(policies.get_placement())
                       .filter(SMS::Bounded_normal_change_filter<>()));
  mesh.collect_garbage();
  return mesh;
}

Errors measure(const Mesh& from, const Distance_to_mesh& to, int splits)
{
  Point hint = *from.points().begin();
  return measure_errors(from, splits, [&](const Point& p) { return to(p, hint); });
}

// the largest distance from the faces of one mesh to another, of which `estimate` is the order of magnitude
double largest_distance(const Mesh& from, const Mesh& to, const double estimate)
{
  constexpr double precision = 1e-3;
  return PMP::bounded_error_Hausdorff_distance<CGAL::Sequential_tag>(from, to, precision * estimate);
}

void check_report(const Mesh& remesh, const Mesh& reference)
{
  constexpr int splits = 40; // where the distance changes its sign, 16 are half a percent too low
  constexpr int splits_of_reference = 4;
  constexpr double of_mean = 0.0075; // twice the standard deviation of as many samples as the report has
  constexpr double of_maximum = 0.01;
  constexpr double of_mean_back = 0.03; // that way there are fewer samples
  constexpr double of_maximum_back = 0.005;
  const Distance_to_mesh to_reference(reference);
  const Errors before = measure(remesh, to_reference, splits);
  Errors back_before = measure(reference, Distance_to_mesh(remesh), splits_of_reference);
  back_before.max = largest_distance(reference, remesh, back_before.max);
  for(PMP::Placement_method method : { PMP::PIECEWISE_LINEAR, PMP::LEAST_SQUARES })
  {
    Mesh mesh = remesh;
    const auto report = PMP::optimize_vertex_locations(mesh, Flat_surface(reference),
                                                       params::guarantee_both_directions(true).placement_method(method));
    const Errors after = measure(mesh, to_reference, splits);
    CHECK_NEAR(report.initial_error.mean, before.mean, of_mean * before.mean);
    CHECK_NEAR(report.final_error.mean, after.mean, of_mean * after.mean);
    CHECK_AT_LEAST(report.initial_error.max, (1 - of_maximum) * before.max);
    CHECK_AT_LEAST(report.final_error.max, (1 - of_maximum) * after.max);
    CHECK_AT_MOST(after.mean, before.mean);
    CHECK_AT_MOST(after.max, (1 + of_maximum) * before.max);

    Errors back_after = measure(reference, Distance_to_mesh(mesh), splits_of_reference);
    back_after.max = largest_distance(reference, mesh, back_after.max);
    CHECK_NEAR(report.initial_error_from_reference.mean, back_before.mean, of_mean_back * back_before.mean);
    CHECK_NEAR(report.final_error_from_reference.mean, back_after.mean, of_mean_back * back_after.mean);
    CHECK_NEAR(report.initial_error_from_reference.max, back_before.max, of_maximum_back * back_before.max);
    CHECK_NEAR(report.final_error_from_reference.max, back_after.max, of_maximum_back * back_after.max);
    CHECK_AT_MOST(back_after.mean, back_before.mean);
    CHECK_AT_MOST(back_after.max, (1 + of_maximum_back) * back_before.max);
    CHECK_AT_MOST(report.final_error_from_reference.mean, report.initial_error_from_reference.mean);

    std::size_t moved = 0;
    for(Vertex v : mesh.vertices())
      moved += mesh.point(v) != remesh.point(v);
    CHECK_EQUAL(report.moved_vertices, moved);
    CHECK_AT_MOST(report.corrected_for_error, report.corrected_vertices);
    const double before_volume = PMP::volume(remesh), after_volume = PMP::volume(mesh);
    CHECK_NEAR(report.volume_change, after_volume / before_volume - 1, 1e-9);
  }
}

void test_reports()
{
  const Mesh elephant = read_model("elephant");
  start_topic("A remesh, and its result put in again");
  Mesh remesh = make_remesh(elephant, 0.05);
  check_report(remesh, elephant);
  PMP::optimize_vertex_locations(remesh, Flat_surface(elephant), params::placement_method(PMP::LEAST_SQUARES));
  check_report(remesh, elephant);
  start_topic("A simplified mesh");
  check_report(simplified(elephant, 2400), elephant);
}

// Of so many faces, each has a single sample of the distance, which is far from the mean over the face: the distance changes
// its sign in most faces.
void test_fine_faces()
{
  start_topic("A mesh of many small faces");
  const double a = -10, b = 120;
  const Mesh plane = make_mesh({ { { a, a, 0 }, { b, a, 0 }, { b, b, 0 }, { a, b, 0 } }, { { 0, 1, 2 }, { 0, 2, 3 } } });
  CGAL::Random random(1);
  Mesh mesh = make_mesh(
    transformed(triangle_grid(100, 100), [&](const Point& p) { return Point(p.x(), p.y(), random.get_double(-0.3, 0.3)); }));
  const auto errors_of = [](const Mesh& m) { return measure_errors(m, 16, [](const Point& p) { return std::abs(p.z()); }); };
  const Errors before = errors_of(mesh);
  const auto report =
    PMP::optimize_vertex_locations(mesh, Flat_surface(plane), params::number_of_iterations(1).number_of_relaxation_steps(0));
  const Errors after = errors_of(mesh);
  CHECK_AT_LEAST(num_faces(mesh), 15000u);
  CHECK_AT_LEAST(after.mean, 0.01 * before.mean);
  CHECK_NEAR(report.initial_error.mean, before.mean, 0.003 * before.mean);
  CHECK_NEAR(report.final_error.mean, after.mean, 0.006 * after.mean);
}

// The gain of repeated calls falls below what the samples are exact to: then they must not be taken at their word.
void test_repeated_calls()
{
  start_topic("A coarse remesh, put in again and again");
  constexpr int splits_of_reference = 4;
  const Mesh elephant = read_model("elephant");
  Mesh mesh = make_remesh(elephant, 0.074);
  double before = measure(elephant, Distance_to_mesh(mesh), splits_of_reference).mean;
  for(int call = 0; call < 4; ++call)
  {
    const auto np = params::placement_method(PMP::LEAST_SQUARES).do_self_intersection_tests(false);
    PMP::optimize_vertex_locations(mesh, Flat_surface(elephant), np);
    const double after = measure(elephant, Distance_to_mesh(mesh), splits_of_reference).mean;
    CHECK_AT_MOST(after, before);
    before = after;
  }
}

// A height field that edge collapses have made coarse: its large faces span bumps of the reference.
void test_height_field()
{
  start_topic("A height field");
  const Mesh field = make_mesh(transformed(triangle_grid(40, 40), [](const Point& p) {
    return Point(p.x(), p.y(),
                 0.7 * std::sin(1.1 * p.x()) * std::cos(0.8 * p.y()) + 0.3 * std::sin(2.3 * p.x() + 1.7 * p.y()));
  }));
  const Mesh coarse = simplified(field, 240);
  const Distance_to_mesh to_field(field);
  const Errors before = measure(coarse, to_field, 24);
  for(PMP::Placement_method method : { PMP::PIECEWISE_LINEAR, PMP::LEAST_SQUARES })
  {
    Mesh mesh = coarse;
    PMP::optimize_vertex_locations(mesh, Flat_surface(field), params::placement_method(method));
    const Errors after = measure(mesh, to_field, 24);
    CHECK_AT_MOST(after.mean, before.mean);
    CHECK_AT_MOST(after.max, 1.01 * before.max);
  }
}

// the largest distance near to the corners of the faces, and in the whole of them
double largest_distance(const Mesh& mesh, const Distance_to_mesh& surface)
{
  constexpr int n = 8;
  Point hint = *mesh.points().begin();
  double largest = 0;
  for(auto h : mesh.halfedges())
  {
    if(mesh.is_border(h))
      continue;
    const Point p = mesh.point(mesh.target(h)), q = mesh.point(mesh.source(h)), r = mesh.point(mesh.target(mesh.next(h)));
    for(double size : { 1., 0.1, 0.01 })
      for(int i = 0; i <= n; ++i)
        for(int j = 0; i + j <= n; ++j)
          largest = (std::max)(largest, surface(p + size / n * (i * (q - p) + j * (r - p)), hint));
  }
  return largest;
}

// A vertex that leaves a crease is next to a peak of the distance, which may be a hundredth of an edge away.
void test_peaks_beside_creases()
{
  start_topic("Peaks beside creases");
  const Mesh fandisk = read_model("fandisk");
  const Mesh coarse = simplified_by_quadrics(fandisk, 3 * 1295);
  const Distance_to_mesh to_fandisk(fandisk);
  for(PMP::Placement_method method : { PMP::PIECEWISE_LINEAR, PMP::LEAST_SQUARES })
  {
    Mesh mesh = coarse;
    const auto report = PMP::optimize_vertex_locations(mesh, Flat_surface(fandisk), params::placement_method(method));
    const double before = largest_distance(coarse, to_fandisk), after = largest_distance(mesh, to_fandisk);
    CHECK_AT_LEAST(report.initial_error.max, 0.99 * before); // it is searched for between these samples, too
    CHECK_AT_MOST(report.initial_error.max, 1.1 * before);
    CHECK_AT_MOST(after, report.initial_error.max);
    CHECK_AT_LEAST(report.final_error.max, 0.97 * after);
  }
}

// The point of a large triangle that is farthest from the mesh may be anywhere in it, where no sample is near.
void test_peaks_inside_reference_faces()
{
  start_topic("Peaks inside faces of the reference");
  struct Field
  {
    double phase, stretch;
  };
  for(const auto& [phase, stretch] : { Field{ 3, 8.773060 }, Field{ 5, 3.455689 }, Field{ 6, 9.797003 } })
  {
    const Mesh field = make_mesh(transformed(icosphere(5), [phase = phase, stretch = stretch](const Point& p) {
      const double r = 1 + 0.1 * std::sin(5 * p.x() + phase) * std::sin(7 * p.y()) * std::sin(6 * p.z() + phase);
      return Point(r * p.x(), r * p.y(), stretch * r * p.z());
    }));
    const Mesh coarse = simplified(field, num_edges(field) / 10);
    constexpr double margin = 5e-3;
    const double before = largest_distance(field, coarse, 0.01);
    for(PMP::Placement_method method : { PMP::PIECEWISE_LINEAR, PMP::LEAST_SQUARES })
    {
      Mesh mesh = coarse;
      const auto report = PMP::optimize_vertex_locations(mesh, Flat_surface(field),
                                                         params::guarantee_both_directions(true).placement_method(method));
      const double after = largest_distance(field, mesh, before);
      CHECK_AT_MOST(after, (1 + margin) * before);
      CHECK_NEAR(report.initial_error_from_reference.max, before, margin * before);
      CHECK_NEAR(report.final_error_from_reference.max, after, margin * after);
    }
  }
}

void test_volume()
{
  start_topic("The volume of the reference");
  const Mesh sphere = make_mesh(icosphere(4)), elephant = read_model("elephant");
  const auto relative_volume = [](const Mesh& mesh, double volume) { return PMP::volume(mesh) / volume - 1; };
  for(PMP::Placement_method method : { PMP::PIECEWISE_LINEAR, PMP::LEAST_SQUARES })
  {
    const auto np = params::preserve_volume(true).placement_method(method);
    Mesh mesh = make_remesh(elephant, 0.05);
    CHECK(PMP::optimize_vertex_locations(mesh, Flat_surface(elephant), np).is_volume_preserved);
    CHECK_NEAR(relative_volume(mesh, PMP::volume(elephant)), 0, 1e-9);

    // that of PN triangles is nearly that of the ball
    Mesh coarse = make_mesh(icosphere(2));
    CHECK(PMP::optimize_vertex_locations(coarse, PMP::PN_triangle_surface<Mesh>(sphere), np).is_volume_preserved);
    CHECK_NEAR(relative_volume(coarse, 4 * CGAL_PI / 3), 0, 1e-4);

    Mesh open = make_mesh(triangle_grid(4, 4));
    const auto report = PMP::optimize_vertex_locations(open, Flat_surface(sphere), np);
    CHECK(!report.is_volume_preserved);
    CHECK_EQUAL(report.volume_change, 0);
  }
}

struct Fault : std::runtime_error
{
  Fault() : std::runtime_error("a fault") {}
};

struct Throwing_visitor : PMP::Vertex_location_optimization_default_visitor
{
  void start_phase(PMP::Vertex_location_optimization_phase p)
  {
    if(p == phase && ++calls == 2 - (p == PMP::Vertex_location_optimization_phase::ENFORCE_GUARANTEE))
      throw Fault();
  }

  PMP::Vertex_location_optimization_phase phase;
  int calls = 0;
};

// the points of a mesh; the nth put() throws
struct Throwing_map
{
  using key_type = Vertex;
  using value_type = Point;
  using reference = Point;
  using category = boost::read_write_property_map_tag;

  friend Point get(const Throwing_map& map, Vertex v) { return map.mesh.get().point(v); }
  friend void put(const Throwing_map& map, Vertex v, const Point& p)
  {
    if(--map.calls.get() == 0)
      throw Fault();
    map.mesh.get().point(v) = p;
  }

  std::reference_wrapper<Mesh> mesh;
  std::reference_wrapper<int> calls;
};

template <typename NamedParameters>
void check_fault(const Mesh& remesh, const Mesh& reference, Mesh& mesh, const NamedParameters& np)
{
  bool is_caught = false;
  try
  {
    PMP::optimize_vertex_locations(mesh, Flat_surface(reference), np);
  }
  catch(const Fault&)
  {
    is_caught = true;
  }
  CHECK(is_caught);
  for(Vertex v : mesh.vertices())
    CHECK_EQUAL(mesh.point(v), remesh.point(v));
}

void test_exceptions()
{
  start_topic("Exceptions");
  using Phase = PMP::Vertex_location_optimization_phase;
  const Mesh reference = make_mesh(icosphere(3)), remesh = make_mesh(icosphere(1));
  for(Phase phase : { Phase::SAMPLE_REFERENCE, Phase::PLACE_VERTICES, Phase::RELAX_VERTICES, Phase::CORRECT_FLIPS,
                      Phase::ENFORCE_GUARANTEE })
  {
    Mesh mesh = remesh;
    Throwing_visitor visitor;
    visitor.phase = phase;
    check_fault(remesh, reference, mesh, params::visitor(std::ref(visitor)));
  }
  {
    Mesh mesh = remesh;
    const auto refuse = [](Vertex, const Point&, const Point&) -> bool { throw Fault(); };
    check_fault(remesh, reference, mesh, params::allow_move_functor(refuse));
  }
  {
    Mesh mesh = remesh;
    int calls = 20;
    const Throwing_map map{ std::ref(mesh), std::ref(calls) };
    check_fault(remesh, reference, mesh, params::vertex_point_map(map));
  }
}

// By rounding a plane may cross any number of sides of a narrow polygon.
void test_cut_of_narrow_polygon()
{
  start_topic("A narrow polygon is cut");
  using PMP::internal::vertex_location::Cut_triangle;
  for(int number_of_corners : { 3, 8, 12, 13, 16 })
  {
    Cut_triangle polygon;
    for(int k = 0; k < number_of_corners; ++k)
      polygon.add({ double(k), 0, 0 });
    const Cut_triangle outside = polygon.cut([](const auto& p) { return int(p.x()) % 2 == 0 ? 1. : -1.; });
    const auto count = [](const Cut_triangle& t) { return std::distance(t.begin(), t.end()); };
    CHECK_AT_MOST(number_of_corners, count(polygon) + count(outside));
    for(const Cut_triangle& part : { polygon, outside })
      CHECK_AT_MOST(count(part), 24);
  }
}

int main()
{
  test_cut_of_narrow_polygon();
  test_reports();
  test_repeated_calls();
  test_fine_faces();
  test_height_field();
  test_peaks_beside_creases();
  test_peaks_inside_reference_faces();
  test_volume();
  test_exceptions();
  return test_result();
}
