// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The PN surface of tessellated parts beside the exact surfaces, and what an optimization makes of remeshes of them.

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

CGAL::Random generator(1);

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

double size_of(const Mesh& mesh)
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

std::vector<Case> make_cases()
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
Mesh remesh_along_creases(Mesh mesh, const double length, Edge_map& is_crease)
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

void test_exact_surfaces()
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

// A chamfer is a plane, whatever its angle, and a remesh in these planes stays where it is.
void test_chamfers()
{
  for(double angle : { 15., 20., 30., 45., 60. })
  {
    start_topic("Chamfer of " + std::to_string(angle) + " degrees");
    const double a = angle * CGAL_PI / 180;
    const auto straight = extruded("", chamfer(a, 5), 3);
    const auto symmetric = extruded("",
                                    Profile({ 0, 0 })
                                      .line_to({ 5, 0 })
                                      .line_to({ 5 + std::cos(a), std::sin(a) })
                                      .line_to({ 5 + std::cos(a) + 5 * std::cos(2 * a), std::sin(a) + 5 * std::sin(2 * a) }),
                                    3);
    for(const Part& part : { straight, symmetric })
    {
      const PN_surface surface(part.mesh);
      double largest = 0;
      for_each_face_sample(part.mesh, 8, [&](double, const Point& p) {
        largest = (std::max)(largest, part.distance(surface.point(surface.project(p))));
      });
      CHECK_AT_MOST(largest, 1e-12 * size_of(part.mesh));
    }
  }
}

// How a planar facet is triangulated makes no difference to the normals at its vertices.
void test_diagonals()
{
  const auto check = [](const auto& make) {
    const Part part = make(Diagonals::ONE_WAY);
    start_topic("Diagonals of the " + part.name);
    const PN_surface surface(part.mesh);
    for(Diagonals diagonals : { Diagonals::OTHER_WAY, Diagonals::ALTERNATING })
    {
      const Part other = make(diagonals);
      const PN_surface other_surface(other.mesh);
      for(Mesh::Vertex_index v : part.mesh.vertices())
      {
        const Point& p = part.mesh.point(v);
        CHECK_AT_MOST(norm(surface.normal(surface.project(p)) - other_surface.normal(other_surface.project(p))), 1e-9);
      }
    }
  };
  check([](Diagonals d) { return revolved("torus", Profile({ 3, 0 }).arc({ 2, 0 }, 2 * CGAL_PI, 16), 32, d); });
  check([](Diagonals d) { return revolved("cylinder", Profile({ 1, 0 }).line_to({ 1, 4 }), 24, d); });
  check([](Diagonals d) { return extruded("fillet", fillet(1, 5), 5, d); });
}

void test_flat_sheet()
{
  start_topic("A flat sheet with a curved border stays flat");
  const Part disc = revolved("", Profile({ 0, 0 }).line_to({ 1, 0 }).line_to({ 2, 0 }), 24);
  const PN_surface surface(disc.mesh);
  for_each_face_sample(
    disc.mesh, 8, [&](double, const Point& p) { CHECK_AT_MOST(std::abs(surface.point(surface.project(p)).z()), 1e-15); });
}

// The averages of the normals of the faces, weighted by angles, are 0.0073 off here.
void test_irregular_triangles()
{
  start_topic("Normals of irregular triangles on a sphere");
  Soup sphere = icosphere(3);
  for(Point& p : sphere.points)
    p = CGAL::ORIGIN + unit(p - CGAL::ORIGIN + random_vector(0.02));
  const Mesh mesh = make_mesh(sphere);
  const PN_surface surface(mesh);
  double sum = 0;
  for(const Point& p : mesh.points())
    sum += norm(surface.normal(surface.project(p)) - unit(p - CGAL::ORIGIN));
  CHECK_AT_MOST(sum / mesh.number_of_vertices(), 0.005);
}

// No patch is farther from its triangle than a third of l sin(beta), where l is the length of its longest side and beta the
// largest angle between its normal and those of the faces around its vertices.
double largest_relative_deviation(const Mesh& mesh, const PN_surface& surface)
{
  // a corner of a patch is a vertex but for rounding
  const double unit_length = 1e-8 * size_of(mesh);
  const auto key = [&](const Point& p) {
    return std::array{ std::llround(p.x() / unit_length + 0.1), std::llround(p.y() / unit_length + 0.1),
                       std::llround(p.z() / unit_length + 0.1) };
  };
  std::map<std::array<long long, 3>, std::vector<Vector>> normals_around;
  for(Mesh::Face_index f : mesh.faces())
    for(const Point& p : corners(mesh, f))
      normals_around[key(p)].push_back(unit(area_vector(corners(mesh, f))));

  double largest = 0;
  for(std::size_t i = 0; i < mesh.number_of_faces(); ++i)
  {
    const auto at = [&](double u, double v) { return patch_point(surface, i, u, v); };
    const std::array<Point, 3> t{ at(0, 0), at(1, 0), at(0, 1) };
    const Vector n = unit(area_vector(t));
    double longest = 0, largest_sine = 0, deviation = 0;
    for(int k = 0; k < 3; ++k)
    {
      longest = (std::max)(longest, norm(t[k] - t[(k + 1) % 3]));
      for(const Vector& m : normals_around[key(t[k])])
        largest_sine = (std::max)(largest_sine, m * n < 0 ? 1. : norm(CGAL::cross_product(m, n)));
    }
    constexpr int level = 6;
    for(int a = 0; a <= level; ++a)
      for(int b = 0; b <= level - a; ++b)
      {
        const double u = double(a) / level, v = double(b) / level;
        deviation = (std::max)(deviation, norm(at(u, v) - (t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]))));
      }
    if(deviation > 1e-9 * longest)
      largest = (std::max)(largest, deviation / (longest * (std::max)(largest_sine, 1e-9)));
  }
  return largest;
}

void test_bound()
{
  start_topic("Patches are near their triangles");
  const auto check = [](const Mesh& mesh) {
    CHECK_AT_MOST(largest_relative_deviation(mesh, PN_surface(mesh)), 1. / 3);
    CHECK_AT_MOST(largest_relative_deviation(mesh, PN_surface(mesh, CGAL::parameters::sharpness_angle(180))), 1. / 3);
  };
  for(int i = 0; i < 20; ++i)
  {
    Soup soup = icosphere(2);
    for(Point& p : soup.points)
      p = p + random_vector(0.02 * i);
    check(make_mesh(soup));
  }
  for(const auto& file : std::filesystem::directory_iterator(CGAL::data_file_path("meshes")))
  {
    Mesh mesh;
    if(file.path().extension() == ".off" && std::filesystem::file_size(file) < 500000 &&
       CGAL::IO::read_OFF(file.path().string(), mesh) && !mesh.is_empty() && CGAL::is_triangle_mesh(mesh))
    {
      start_topic("Patches of " + file.path().filename().string());
      check(mesh);
    }
  }
}

void test_default_reference()
{
  start_topic("The default reference surface");
  const auto kind = [](const Mesh& reference) {
    Mesh mesh = reference;
    return PMP::optimize_vertex_locations(mesh, reference, CGAL::parameters::number_of_iterations(1)).reference.kind;
  };
  CHECK(kind(make_mesh(icosphere(2))) == PMP::Reference_surface_kind::PN);
  CHECK(kind(revolved("", Profile({ 0, 0 }).line_to({ 1, 0 }).line_to({ 1, 4 }).line_to({ 0, 4 }), 12).mesh) ==
        PMP::Reference_surface_kind::PN);
  CHECK(kind(make_mesh(cube(0))) == PMP::Reference_surface_kind::FLAT);
}

int main()
{
  test_chamfers();
  test_diagonals();
  test_flat_sheet();
  test_irregular_triangles();
  test_default_reference();
  test_bound();
  test_exact_surfaces();
  return test_result();
}
