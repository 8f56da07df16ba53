// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Optimizes whatever it finds, and checks that nothing gets worse:
//
//   robustness [MESH...]
//
// Without arguments the meshes are all those of CGAL's data. Each is repaired as far as reading does that, remeshed, and
// optimized, with both placement methods; then it is optimized as it is, with its creases, slivers and folds. The program
// prints a table and fails if a check does.

#include "invariants.h"
#include "remeshes.h"

#include <CGAL/Polygon_mesh_processing/approximation_error.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

using Surface = PMP::PN_triangle_surface<Mesh>;
using Tag = CGAL::Parallel_if_available_tag;

std::vector<std::string> all_meshes()
{
  std::vector<std::string> files;
  const std::filesystem::path some_mesh = CGAL::data_file_path("meshes/armadillo.off");
  if(!std::filesystem::exists(some_mesh))
    fail_without(some_mesh.string());
  for(const auto& entry : std::filesystem::directory_iterator(some_mesh.parent_path()))
    files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

// whether there is a triangle mesh in the file
bool read_triangle_mesh(const std::string& file, Mesh& mesh)
{
  if(!PMP::IO::read_polygon_mesh(file, mesh) || mesh.number_of_faces() == 0)
    return false;
  PMP::triangulate_faces(mesh);
  mesh.collect_garbage();
  return CGAL::is_triangle_mesh(mesh);
}

// Coarse enough to have something to optimize, and so that no mesh has more than some ten thousand faces.
Mesh make_coarse_remesh(const Mesh& mesh)
{
  constexpr double relative_length = 0.03, max_number_of_faces = 2e4;
  const double area_of_face = PMP::area(mesh) / max_number_of_faces;
  return make_remesh(mesh, (std::max)(relative_length, std::sqrt(area_of_face * 4 / std::sqrt(3.)) / longest_side(mesh)));
}

// Neither error is larger than before; that is measured closely where it is not obvious.
void check_errors(const Mesh& before, const Mesh& after, const Surface& surface, double rounding)
{
  PMP::Approximation_error error_before, error_after;
  for(unsigned int points_per_face : { 64, 1024 })
  {
    const auto np = CGAL::parameters::number_of_points_per_face(points_per_face);
    error_before = PMP::approximation_error<Tag>(before, surface, np);
    error_after = PMP::approximation_error<Tag>(after, surface, np);
    if(error_after.mean <= error_before.mean && error_after.max <= error_before.max)
      return;
  }
  CHECK_AT_MOST(error_after.mean, error_before.mean + rounding);
  CHECK_AT_MOST(error_after.max, 1.01 * error_before.max + rounding); // what lies between the samples
}

void test(const std::string& name, const Mesh& remesh, const Surface& surface)
{
  const double unit = 1e-4 * longest_side(remesh), rounding = 1e-8 * unit;
  const PMP::Approximation_error before = PMP::approximation_error<Tag>(remesh, surface);
  const Face_pairs intersections = self_intersections_of(remesh);
  std::printf("%-40s %7zu %7.2f %7.1f", name.c_str(), std::size_t(remesh.number_of_vertices()), before.mean / unit,
              before.max / unit);
  std::fflush(stdout);
  CGAL::Real_timer timer;
  timer.start();
  for(PMP::Placement_method method : { PMP::PIECEWISE_LINEAR, PMP::LEAST_SQUARES })
  {
    check::topic() = name + (method == PMP::PIECEWISE_LINEAR ? ", piecewise linear" : ", least squares");
    Mesh mesh = remesh;
    PMP::optimize_vertex_locations<Tag>(mesh, surface,
                                        CGAL::parameters::placement_method(method).do_self_intersection_tests(true));
    check_invariants(remesh, mesh);

    check_errors(remesh, mesh, surface, rounding);
    const Face_pairs intersections_after = self_intersections_of(mesh);
    CHECK(std::includes(intersections.begin(), intersections.end(), intersections_after.begin(), intersections_after.end()));
    const PMP::Approximation_error after = PMP::approximation_error<Tag>(mesh, surface);
    std::printf(" | %7.2f %7.1f", after.mean / unit, after.max / unit);
    std::fflush(stdout);
  }
  std::printf(" %7.1f\n", timer.time());
}

void test(const std::string& file)
{
  const std::string name = std::filesystem::path(file).filename().string();
  check::topic() = name;
  Mesh mesh;
  if(!read_triangle_mesh(file, mesh))
  {
    std::printf("%-40s is no triangle mesh\n", name.c_str());
    return;
  }
  const Surface surface(mesh);
  Mesh remesh;
  try
  {
    remesh = make_coarse_remesh(mesh);
  }
  catch(const std::exception&)
  {
    std::printf("%-40s cannot be remeshed\n", name.c_str());
  }
  if(remesh.number_of_faces() > 0)
    test(name + ", remeshed", remesh, surface);
  test(name, mesh, surface);
}

int main(int argc, char** argv)
{
  std::printf("Errors in 1e-4 of the longest side of the bounding box; the time is for both methods.\n\n"
              "%-40s %7s %15s | %15s | %15s %7s\n%-40s %7s %7s %7s | %7s %7s | %7s %7s\n",
              "", "", "before", "piecewise l.", "least squares", "seconds", "mesh", "vertices", "mean", "max", "mean", "max",
              "mean", "max");
  const std::vector<std::string> files = argc > 1 ? std::vector<std::string>(argv + 1, argv + argc) : all_meshes();
  for(const std::string& file : files)
  {
    try
    {
      test(file);
    }
    catch(const std::exception& e)
    {
      CHECK_EQUAL(std::string(e.what()), "");
    }
  }
  return test_result();
}
