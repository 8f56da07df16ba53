// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The PN surface of tessellated parts beside the exact surfaces, and what an optimization makes of remeshes of them.

#include "check.h"
#include "mesh_quality.h"
#include "optimize_parts.h"
#include "parts.h"
#include "read_model.h"
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
  const std::string models = CGAL::data_file_path("meshes");
  if(!std::filesystem::is_directory(models))
    fail_without(models);
  for(const auto& file : std::filesystem::directory_iterator(models))
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
