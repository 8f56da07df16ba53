// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Remeshes a surface, optimizes the locations of the vertices, and tells and shows what it gained.

#include "mesh_attributes.h"
#include "mesh_output.h"
#include "optimize_remesh_settings.h"
#include "Progress_bar.h"
#include "Table_of_attempts.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/approximation_error.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Polygon_mesh_processing/PN_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/remesh_within_tolerance.h>
#include <CGAL/Real_timer.h>
#include <CGAL/subdivision_method_3.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Crease_map = Mesh::Property_map<Mesh::Edge_index, bool>;
using Error_map = Mesh::Property_map<Mesh::Vertex_index, double>;

namespace PMP = CGAL::Polygon_mesh_processing;

Mesh read_mesh(const std::string& name, const bool may_have_polygons)
{
  auto require = [&](bool condition, const std::string& message) {
    if(!condition)
      throw std::runtime_error(name + ": " + message);
  };
  require(std::filesystem::is_regular_file(name), "there is no such file");
  Mesh mesh;
  // what must be repaired loses its attributes
  require(read_mesh_with_attributes(name, mesh) || PMP::IO::read_polygon_mesh(name, mesh),
          "it is unreadable or no manifold mesh");
  require(mesh.number_of_faces() > 0, "it has no face");
  require(may_have_polygons || CGAL::is_triangle_mesh(mesh), "its faces are not all triangles");
  for(const Point& p : mesh.points())
    require(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()), "a coordinate is not finite");
  return mesh;
}

double longest_side(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  return (std::max)({ box.x_span(), box.y_span(), box.z_span() });
}

// how regular the faces are: smallest angles in degrees
struct Regularity
{
  double mean = 0;
  double min = 180;
};

Regularity measure_regularity(const Mesh& mesh)
{
  Regularity regularity;
  for(Mesh::Face_index f : mesh.faces())
  {
    double smallest = 180;
    for(Mesh::Halfedge_index h : halfedges_around_face(mesh.halfedge(f), mesh))
      smallest = (std::min)(smallest, CGAL::approximate_angle(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                                              mesh.point(mesh.target(mesh.next(h)))));
    regularity.mean += smallest / mesh.number_of_faces();
    regularity.min = (std::min)(regularity.min, smallest);
  }
  return regularity;
}

// The input with four faces in the place of one, on the surface that it stands for.
template <typename Surface>
Mesh refine(const Mesh& mesh, const Surface& reference)
{
  Mesh refined = mesh;
  CGAL::Subdivision_method_3::PTQ(refined, CGAL::Linear_mask_3<Mesh>(&refined, refined.points()));
  for(Mesh::Vertex_index v : refined.vertices())
    refined.point(v) = mesh.has_valid_index(v) ? mesh.point(v) : reference.point(reference.project(refined.point(v)));
  return refined;
}

// what the table says of a mesh
struct Measures
{
  PMP::Approximation_error error;
  PMP::Approximation_error back; // from the input, refined, to the mesh
  Regularity regularity;
};

template <typename Concurrency, typename Surface>
Measures measure(const Mesh& mesh, const Mesh& refined_input, const Surface& reference, Error_map errors)
{
  return { PMP::approximation_error<Concurrency>(mesh, reference, CGAL::parameters::vertex_error_map(errors)),
           PMP::approximation_error<Concurrency>(refined_input, PMP::Flat_triangle_surface<Mesh>(mesh)),
           measure_regularity(mesh) };
}

void print_table(const Measures& before, const Measures& after, double side)
{
  auto print_row = [&](const char* name, double a, double b, bool is_error) {
    const double unit = is_error ? side * 1e-4 : 1;
    std::printf("  %-32s %10.3f %10.3f", name, a / unit, b / unit);
    constexpr double nothing = 1e-9; // relative to the longest side: rounding
    if(is_error && a > nothing * side)
      std::printf(" %+9.1f%%", 100 * (b - a) / a);
    else if(is_error)
      std::printf(" %10s", "-");
    std::printf("\n");
  };
  std::printf("\n  %-32s %10s %10s\n", "", "before", "after");
  print_row("mean error", before.error.mean, after.error.mean, true);
  print_row("root mean square", before.error.rms, after.error.rms, true);
  print_row("maximum", before.error.max, after.error.max, true);
  print_row("mean from the input", before.back.mean, after.back.mean, true);
  print_row("maximum from the input", before.back.max, after.back.max, true);
  print_row("mean smallest angle (degrees)", before.regularity.mean, after.regularity.mean, false);
  print_row("smallest angle (degrees)", before.regularity.min, after.regularity.min, false);
  std::printf("  Errors in 1/10000 of the longest side of the bounding box.\n\n");
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

void print_reference(const PMP::Reference_surface_summary& reference, double side)
{
  if(reference.kind == PMP::Reference_surface_kind::FLAT)
    std::printf("reference: the faces of the input\n");
  else
    std::printf("reference: PN triangles, off the faces of the input by %.3g in the mean, by %.3g at most "
                "(1e-4 of the longest side)\n",
                reference.mean_deviation / side * 1e4, reference.maximum_deviation / side * 1e4);
}

template <typename Concurrency, typename Surface>
void optimize(const Settings& s, const Mesh& input, Mesh& mesh, Crease_map is_crease, const Surface& reference)
{
  const double side = longest_side(input);
  const Mesh refined_input = refine(input, reference);
  Mesh remesh = mesh;
  Error_map errors_before = remesh.add_property_map<Mesh::Vertex_index, double>("v:error").first;
  Error_map errors = mesh.add_property_map<Mesh::Vertex_index, double>("v:error").first;
  const Measures before = measure<Concurrency>(remesh, refined_input, reference, errors_before);

  CGAL::Real_timer timer;
  timer.start();
  PMP::Vertex_location_optimization_report report;
  {
    Progress_bar progress(s.iterations);
    report = PMP::optimize_vertex_locations<Concurrency>(
      mesh, reference,
      CGAL::parameters::number_of_free_iterations(s.free_iterations)
        .placement_method(s.is_least_squares ? PMP::LEAST_SQUARES : PMP::PIECEWISE_LINEAR)
        .regularity_weight(s.regularity_weight)
        .number_of_iterations(s.iterations)
        .number_of_relaxation_steps(s.relaxation_steps)
        .edge_is_constrained_map(is_crease)
        .relax_constraints(s.relax_constraints)
        .do_self_intersection_tests(s.test_self_intersections || s.is_least_squares)
        .visitor(std::ref(progress)));
  }
  std::printf("optimized: %zu iterations, %.2f s\n", report.iterations, timer.time());
  print_reference(report.reference, side);

  const Measures after = measure<Concurrency>(mesh, refined_input, reference, errors);
  print_table(before, after, side);

  const double largest_color = s.largest_color > 0 ? s.largest_color : 3 * before.error.mean;
  for(Mesh* m : { &remesh, &mesh })
    transfer_attributes<Concurrency>(input, reference, *m, is_crease);
  write_mesh_with_attributes(s.output + "remesh." + s.format, remesh);
  write_mesh_with_attributes(s.output + "optimized." + s.format, mesh);
  write_colored_PLY(s.output + "remesh_error.ply", remesh, errors_before, largest_color);
  write_colored_PLY(s.output + "optimized_error.ply", mesh, errors, largest_color);
  write_VTP(s.output + "remesh_error.vtp", remesh, "error", errors_before);
  write_VTP(s.output + "optimized_error.vtp", mesh, "error", errors);
  std::printf("written: %sremesh*, %soptimized*\ncolors from 0 (violet) to %.3g (yellow), %.3g/10000 of the longest side\n",
              s.output.c_str(), s.output.c_str(), largest_color, largest_color / side * 1e4);
}

// Finds the coarsest remesh within the tolerance, and writes it. Returns whether there is one.
template <typename Concurrency, typename Surface>
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
  Error_map errors = mesh.add_property_map<Mesh::Vertex_index, double>("v:error").first;
  PMP::approximation_error<Concurrency>(mesh, reference, CGAL::parameters::vertex_error_map(errors));
  const double largest_color = s.largest_color > 0 ? s.largest_color : 3 * report.to_reference.mean;
  transfer_attributes<Concurrency>(input, reference, mesh, CGAL::Static_boolean_property_map<Mesh::Edge_index, false>());
  write_mesh_with_attributes(s.output + "optimized." + s.format, mesh);
  write_colored_PLY(s.output + "optimized_error.ply", mesh, errors, largest_color);
  write_VTP(s.output + "optimized_error.vtp", mesh, "error", errors);
  std::printf("written: %soptimized*\n", s.output.c_str());
  return report.is_within_tolerance;
}

template <typename Concurrency>
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
    return remesh_within_tolerance<Concurrency>(s, input, is_crease, PMP::Flat_triangle_surface<Mesh>(input, creases));
  return remesh_within_tolerance<Concurrency>(s, input, is_crease, PMP::PN_triangle_surface<Mesh>(input, creases));
}

// Returns whether the result is as good as was asked for.
template <typename Concurrency>
bool run(const Settings& s)
{
  Mesh input = read_mesh(s.input, false);
  const double side = longest_side(input);
  if(!(side > 0))
    throw std::runtime_error(s.input + ": all its points are the same");
  std::printf("%s: %u vertices\n", std::filesystem::path(s.input).filename().string().c_str(), input.number_of_vertices());
  if(s.tolerance > 0)
    return remesh_within_tolerance<Concurrency>(s, input);

  CGAL::Real_timer timer;
  timer.start();
  Mesh mesh = s.remesh.empty() ? input : read_mesh(s.remesh, true);
  Crease_map is_crease = mark_creases(mesh, s.crease_angle);
  if(s.remesh.empty())
  {
    PMP::isotropic_remeshing(faces(mesh), s.is_absolute ? s.edge_length : s.edge_length * side, mesh,
                             CGAL::parameters::number_of_iterations(s.remeshing_iterations)
                               .number_of_relaxation_steps(3)
                               .edge_is_constrained_map(is_crease));
    mesh.collect_garbage();
  }
  if(mesh.number_of_faces() == 0)
    throw std::runtime_error("nothing is left of the mesh: the edge length is too large");
  std::printf("remesh: %u vertices, %.2f s\n", mesh.number_of_vertices(), timer.time());

  if(s.reference == "flat")
    optimize<Concurrency>(s, input, mesh, is_crease, PMP::Flat_triangle_surface<Mesh>(input));
  else
    optimize<Concurrency>(s, input, mesh, is_crease,
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
    const bool is_good =
      settings.is_sequential ? run<CGAL::Sequential_tag>(settings) : run<CGAL::Parallel_if_available_tag>(settings);
    return is_good ? EXIT_SUCCESS : 2;
  }
  catch(const std::exception& e)
  {
    std::cerr << "optimize_remesh: " << e.what() << std::endl;
    return EXIT_FAILURE;
  }
}
