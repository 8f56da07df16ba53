// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Remeshes a surface, optimizes the locations of the vertices, and reports and shows the gain.

#include "mesh_attributes.h"
#include "mesh_input.h"
#include "mesh_output.h"
#include "optimize_remesh_report.h"
#include "optimize_remesh_settings.h"
#include "Progress_bar.h"
#include "Table_of_attempts.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/approximation_error.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Polygon_mesh_processing/PN_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/remesh_within_tolerance.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Constrained_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Crease_map = Mesh::Property_map<Mesh::Edge_index, bool>;
using Error_map = Mesh::Property_map<Mesh::Vertex_index, double>;

using Concurrency = CGAL::Parallel_if_available_tag;

namespace PMP = CGAL::Polygon_mesh_processing;

// how far a mesh and the input are from each other
struct Distances
{
  PMP::Approximation_error there;
  PMP::Approximation_error back; // from the input, refined, to the mesh
};

template <typename Surface>
Distances measure(const Mesh& mesh, const Mesh& refined_input, const Surface& reference)
{
  return { PMP::approximation_error<Concurrency>(mesh, reference),
           PMP::approximation_error<Concurrency>(refined_input, PMP::Flat_triangle_surface<Mesh>(mesh)) };
}

template <typename Surface>
void print_measured(const Mesh& before, const Mesh& after, const Mesh& input, const Surface& reference, double side)
{
  const Mesh refined_input = refine(input, reference);
  const Distances a = measure(before, refined_input, reference);
  const Distances b = measure(after, refined_input, reference);
  print_heading("measured densely");
  print_errors(a.there, b.there, "", side);
  print_errors(a.back, b.back, " from the input", side);
}

// The errors at the vertices, for the colors.
template <typename Surface>
Error_map measure_vertex_errors(Mesh& mesh, const Surface& reference)
{
  constexpr std::size_t points_per_face = 9; // more would make no visible difference
  const Error_map errors = mesh.add_property_map<Mesh::Vertex_index, double>("v:error").first;
  PMP::approximation_error<Concurrency>(
    mesh, reference, CGAL::parameters::vertex_error_map(errors).number_of_points_per_face(points_per_face));
  return errors;
}

// the sharp edges, and the seams of the texture
Crease_map mark_creases(Mesh& mesh, double angle)
{
  Crease_map is_crease = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_crease", false).first;
  if(angle < 180)
    PMP::detect_sharp_edges(mesh, angle, is_crease);
  const Mesh_attributes<Point> attributes(mesh);
  if(attributes.has_texture)
    for(Mesh::Edge_index e : mesh.edges())
      if(is_texture_seam(mesh, attributes.texture, e))
        is_crease[e] = true;
  return is_crease;
}

template <typename Surface>
PMP::Vertex_location_optimization_report
optimize(const Settings& s, Mesh& mesh, Crease_map is_crease, const Surface& reference)
{
  Progress_bar progress(s.iterations);
  return PMP::optimize_vertex_locations<Concurrency>(
    mesh, reference,
    CGAL::parameters::number_of_free_iterations(s.free_iterations)
      .placement_method(s.is_least_squares ? PMP::LEAST_SQUARES : PMP::PIECEWISE_LINEAR)
      .regularity_weight(s.regularity_weight)
      .guarantee_both_directions(s.guarantee_both_directions)
      .preserve_volume(s.preserve_volume)
      .number_of_iterations(s.iterations)
      .number_of_relaxation_steps(s.relaxation_steps)
      .edge_is_constrained_map(is_crease)
      .relax_constraints(s.relax_constraints)
      .do_self_intersection_tests(s.test_self_intersections || s.is_least_squares)
      .visitor(std::ref(progress)));
}

// Writes a mesh, and its errors in two formats.
template <typename Surface>
void write_with_errors(
  const Settings& s, const std::string& name, Mesh& mesh, const Surface& reference, double largest_color)
{
  const Error_map errors = measure_vertex_errors(mesh, reference);
  write_mesh_with_attributes(s.output + name + "." + s.format, mesh);
  write_colored_PLY(s.output + name + "_error.ply", mesh, errors, largest_color);
  write_VTP(s.output + name + "_error.vtp", mesh, "error", errors);
}

template <typename Surface>
void optimize_and_write(const Settings& s, const Mesh& input, Mesh& mesh, Crease_map is_crease, const Surface& reference)
{
  const double side = longest_side(input);
  Mesh remesh = mesh;
  CGAL::Real_timer timer;
  timer.start();
  const PMP::Vertex_location_optimization_report report = optimize(s, mesh, is_crease, reference);
  std::printf("optimized: %zu iterations, %.2f s\n", report.iterations, timer.time());
  print_reference(report.reference, side);
  print_moves(report, mesh.number_of_vertices());
  if(CGAL::is_closed(mesh))
    print_volume(report, s.preserve_volume);
  print_table(report, measure_regularity(remesh), measure_regularity(mesh), s.guarantee_both_directions, side);
  if(s.is_measured)
    print_measured(remesh, mesh, input, reference, side);

  const double largest_color = s.largest_color > 0 ? s.largest_color : 3 * report.initial_error.mean;
  for(Mesh* m : { &remesh, &mesh })
    transfer_attributes<Concurrency>(input, reference, *m, is_crease);
  write_with_errors(s, "remesh", remesh, reference, largest_color);
  write_with_errors(s, "optimized", mesh, reference, largest_color);
  std::printf(
    "\nwritten: %sremesh*, %soptimized*\ncolors from 0 (violet) to %.3g (yellow), %.3g/10000 of the longest side\n",
    s.output.c_str(), s.output.c_str(), largest_color, largest_color / side * 1e4);
}

// Finds the coarsest remesh within the tolerance, and writes it. Returns whether there is one.
template <typename Surface>
bool remesh_within_tolerance(const Settings& s, const Mesh& input, Crease_map is_crease, const Surface& reference)
{
  const double side = longest_side(input), tolerance = s.is_tolerance_relative ? s.tolerance * side : s.tolerance;
  const auto remesh = [&](Mesh& mesh, double edge_length, const auto& is_constrained, const auto& is_corner) {
    PMP::isotropic_remeshing(faces(mesh), edge_length, mesh,
                             CGAL::parameters::number_of_iterations(s.remeshing_iterations)
                               .number_of_relaxation_steps(3)
                               .edge_is_constrained_map(is_constrained)
                               .vertex_is_constrained_map(is_corner));
  };
  Mesh mesh;
  Table_of_attempts table(side);
  CGAL::Real_timer timer;
  timer.start();
  const PMP::Tolerance_report report =
    PMP::remesh_within_tolerance<Concurrency>(input, tolerance, mesh, remesh,
                                              CGAL::parameters::tolerated_error(s.tolerated_error)
                                                .reference_surface(std::cref(reference))
                                                .regularity_weight(s.regularity_weight)
                                                .guarantee_both_directions(s.guarantee_both_directions)
                                                .preserve_volume(s.preserve_volume)
                                                .number_of_iterations(s.iterations)
                                                .edge_is_constrained_map(is_crease)
                                                .visitor(std::ref(table)));
  std::printf("  Errors in 1/10000 of the longest side of the bounding box; the tolerance is %.3f.\n\n",
              tolerance / side * 1e4);
  if(report.number_of_vertices == 0)
    throw std::runtime_error("nothing is left of the mesh, whatever the edge length");
  std::printf("%s: %zu vertices, edge length %.6g, %zu remeshings, %.2f s\n",
              report.is_within_tolerance ? "within the tolerance" : "the smallest error, but NOT within the tolerance",
              report.number_of_vertices, report.edge_length, report.number_of_remeshings, timer.time());

  mesh.collect_garbage();
  const double largest_color = s.largest_color > 0 ? s.largest_color : 3 * report.to_reference.mean;
  transfer_attributes<Concurrency>(input, reference, mesh, CGAL::Static_boolean_property_map<Mesh::Edge_index, false>());
  write_with_errors(s, "optimized", mesh, reference, largest_color);
  std::printf("written: %soptimized*\n", s.output.c_str());
  return report.is_within_tolerance;
}

bool remesh_within_tolerance(const Settings& s, Mesh& input)
{
  const Crease_map is_crease = mark_creases(input, s.crease_angle);
  if(Mesh_attributes<Point> attributes(input); attributes.has_texture)
  {
    std::printf("texture coordinates are not kept with --tolerance\n");
    input.remove_property_map(attributes.texture);
  }
  const auto creases = CGAL::parameters::sharpness_angle((std::min)(s.sharpness_angle, s.crease_angle));
  if(s.reference == "flat")
    return remesh_within_tolerance(s, input, is_crease, PMP::Flat_triangle_surface<Mesh>(input, creases));
  return remesh_within_tolerance(s, input, is_crease, PMP::PN_triangle_surface<Mesh>(input, creases));
}

// Simplifies or remeshes a mesh.
void remesh(const Settings& s, Crease_map is_crease, Mesh& mesh)
{
  namespace SMS = CGAL::Surface_mesh_simplification;
  const auto is_simple = [&](const auto&, const auto&, std::size_t, std::size_t) {
    return mesh.number_of_vertices() <= static_cast<std::size_t>(*s.simplify);
  };
  if(s.simplify)
    SMS::edge_collapse(mesh, is_simple,
                       CGAL::parameters::edge_is_constrained_map(is_crease).get_placement(
                         SMS::Constrained_placement<SMS::LindstromTurk_placement<Mesh>, Crease_map>(is_crease)));
  else
    PMP::isotropic_remeshing(faces(mesh), s.is_absolute ? s.edge_length : s.edge_length * longest_side(mesh), mesh,
                             CGAL::parameters::number_of_iterations(s.remeshing_iterations)
                               .number_of_relaxation_steps(3)
                               .edge_is_constrained_map(is_crease));
  mesh.collect_garbage();
}

// Returns whether the result is as good as requested.
bool run(const Settings& s)
{
  Mesh input = read_triangle_mesh<Point>(s.input, s.is_triangulated);
  const double side = longest_side(input);
  if(!(side > 0))
    throw std::runtime_error(s.input + ": all its points are the same");
  std::printf("%s: %u vertices\n", std::filesystem::path(s.input).filename().string().c_str(), input.number_of_vertices());
  if(s.tolerance > 0)
    return remesh_within_tolerance(s, input);

  CGAL::Real_timer timer;
  timer.start();
  Mesh mesh = s.remesh.empty() ? input : read_mesh<Point>(s.remesh);
  const Crease_map is_crease = mark_creases(mesh, s.crease_angle);
  if(s.remesh.empty())
    remesh(s, is_crease, mesh);
  if(mesh.number_of_faces() == 0)
    throw std::runtime_error("nothing is left of the mesh: the edge length is too large");
  std::printf("remesh: %u vertices, %.2f s\n", mesh.number_of_vertices(), timer.time());

  if(s.reference == "flat")
    optimize_and_write(s, input, mesh, is_crease, PMP::Flat_triangle_surface<Mesh>(input));
  else
    optimize_and_write(s, input, mesh, is_crease,
                       PMP::PN_triangle_surface<Mesh>(input, CGAL::parameters::sharpness_angle(s.sharpness_angle)));
  return true;
}

int main(int argc, char* argv[])
{
  try
  {
    Settings settings;
    if(!read_settings(argc, argv, settings))
      return EXIT_SUCCESS;
#ifdef CGAL_LINKED_WITH_TBB
    std::optional<tbb::global_control> one_thread;
    if(settings.is_sequential)
      one_thread.emplace(tbb::global_control::max_allowed_parallelism, 1);
#endif
    return run(settings) ? EXIT_SUCCESS : 2;
  }
  catch(const std::exception& e)
  {
    std::cerr << "optimize_remesh: " << e.what() << std::endl;
    return EXIT_FAILURE;
  }
}
