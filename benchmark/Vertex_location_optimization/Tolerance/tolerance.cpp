// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What remesh_within_tolerance() finds, how many vertices fewer the next edge lengths would have, and how many more
// isotropic_remeshing() alone needs:
//
//   tolerance [DIRECTORY]
//
// With a directory, the results are written there. Prints a table of Markdown.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/approximation_error.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/remesh_within_tolerance.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using Crease_map = Mesh::Property_map<Mesh::Edge_index, bool>;
using Concurrency = CGAL::Parallel_if_available_tag;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::parameters;

struct Model
{
  std::string name;
  double crease_angle;
  Mesh input;
  Crease_map is_crease;
  double side;
};

Model read_model(const std::string& name, double crease_angle)
{
  Model model{ name, crease_angle, {}, {}, 0 };
  const std::string file = CGAL::data_file_path("meshes/" + name + ".off");
  if(!PMP::IO::read_polygon_mesh(file, model.input) || is_empty(model.input))
  {
    std::cerr << file << " cannot be read" << std::endl;
    std::exit(EXIT_FAILURE);
  }
  model.is_crease = model.input.add_property_map<Mesh::Edge_index, bool>("e:is_crease", false).first;
  if(crease_angle < 180)
    PMP::detect_sharp_edges(model.input, crease_angle, model.is_crease);
  const CGAL::Bbox_3 box = PMP::bbox(model.input);
  model.side = (std::max)({ box.x_span(), box.y_span(), box.z_span() });
  return model;
}

template <typename EdgeMap, typename VertexMap>
void remesh_isotropically(Mesh& mesh, double edge_length, const EdgeMap& is_constrained, const VertexMap& is_corner)
{
  PMP::isotropic_remeshing(faces(mesh), edge_length, mesh,
                           params::number_of_iterations(10)
                             .number_of_relaxation_steps(3)
                             .edge_is_constrained_map(is_constrained)
                             .vertex_is_constrained_map(is_corner));
}

struct Seen : PMP::Tolerance_default_visitor
{
  void end_remeshing(const PMP::Tolerance_report& report)
  {
    std::fprintf(stderr, "  %zu: edge length %g, %zu vertices, %s\n", report.number_of_remeshings, report.edge_length,
                 report.number_of_vertices, report.is_within_tolerance ? "within" : "beyond");
  }
};

// one remeshing with a given edge length
PMP::Tolerance_report try_length(const Model& model, double tolerance, double edge_length)
{
  Mesh result;
  const auto remesh = [&](Mesh& mesh, double, const auto& edges, const auto& vertices) {
    remesh_isotropically(mesh, edge_length, edges, vertices);
  };
  return PMP::remesh_within_tolerance<Concurrency>(
    model.input, tolerance, result, remesh,
    params::maximum_number_of_remeshings(1).edge_is_constrained_map(model.is_crease));
}

// The fewest vertices with one of the next edge lengths, in steps of 1.5%.
std::size_t try_next_lengths(const Model& model, double tolerance, const PMP::Tolerance_report& found)
{
  std::size_t fewest = found.number_of_vertices;
  for(int step = 1; step <= 6; ++step)
  {
    const PMP::Tolerance_report report = try_length(model, tolerance, found.edge_length * std::pow(1.015, step));
    std::fprintf(stderr, "  next %d: %zu vertices, %s\n", step, report.number_of_vertices,
                 report.is_within_tolerance ? "within" : "beyond");
    if(report.is_within_tolerance)
      fewest = (std::min)(fewest, report.number_of_vertices);
  }
  return fewest;
}

// How many vertices isotropic_remeshing() alone needs: by bisection, to 3% of the edge length.
std::size_t isotropic_alone(const Model& model, double tolerance, double edge_length)
{
  const PMP::Flat_triangle_surface<Mesh> reference(model.input);
  std::size_t number = 0;
  const auto is_within = [&](double length) {
    Mesh mesh = model.input;
    // the one that is there: what `property_map()` returns depends on the version of CGAL
    auto is_crease = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_crease").first;
    PMP::isotropic_remeshing(
      faces(mesh), length, mesh,
      params::number_of_iterations(10).number_of_relaxation_steps(3).edge_is_constrained_map(is_crease));
    const bool is_within =
      PMP::approximation_error<Concurrency>(mesh, reference).max <= tolerance &&
      PMP::approximation_error<Concurrency>(model.input, PMP::Flat_triangle_surface<Mesh>(mesh)).max <= tolerance;
    std::fprintf(stderr, "  alone, edge length %g: %zu vertices, %s\n", length, std::size_t(mesh.number_of_vertices()),
                 is_within ? "within" : "beyond");
    if(is_within)
      number = mesh.number_of_vertices();
    return is_within;
  };
  double beyond = edge_length, within = edge_length;
  for(int step = 0; step < 12 && number == 0; ++step)
    if(within /= 1.7; !is_within(within))
      beyond = within;
  while(number > 0 && beyond > within * 1.03)
    (is_within(std::sqrt(beyond * within)) ? within : beyond) = std::sqrt(beyond * within);
  return number;
}

void print_row(const Model& model, double relative_tolerance, const std::string& directory)
{
  const double tolerance = relative_tolerance * model.side, unit = 1e-4 * model.side;
  std::fprintf(stderr, "%s, %g\n", model.name.c_str(), relative_tolerance);
  Mesh result;
  Seen visitor;
  const PMP::Tolerance_report report = PMP::remesh_within_tolerance<Concurrency>(
    model.input, tolerance, result, params::edge_is_constrained_map(model.is_crease).visitor(std::ref(visitor)));
  if(!directory.empty())
  {
    result.collect_garbage();
    CGAL::IO::write_polygon_mesh(directory + "/" + model.name + "_" + std::to_string(int(1e4 * relative_tolerance)) + ".off",
                                 result, params::stream_precision(17));
  }
  const std::size_t fewest = try_next_lengths(model, tolerance, report);
  const std::size_t alone = isotropic_alone(model, tolerance, report.edge_length);
  std::printf("| %s | %.1f%% | %zu%s | %.1f, %.1f | %.4f | %zu | %.1f%% | %zu | %.0f%% |\n", model.name.c_str(),
              100 * relative_tolerance, report.number_of_vertices, report.is_within_tolerance ? "" : " (beyond)",
              report.to_reference.max / unit, report.from_reference.max / unit, report.edge_length / model.side,
              report.number_of_remeshings, 100. - 100. * fewest / report.number_of_vertices, alone,
              alone > 0 ? 100 - 100. * report.number_of_vertices / alone : 0);
  std::fflush(stdout);
}

int main(int argc, char* argv[])
{
  std::printf("| model | tolerance | vertices | maximum, back | edge length | remeshings | fewer with the next lengths | "
              "`isotropic_remeshing()` alone | saved |\n|---|---|---|---|---|---|---|---|---|\n");
  for(const double tolerance : { 0.01, 0.003 })
    for(const auto& [name, crease_angle] : std::vector<std::pair<std::string, double>>{
          { "knot1", 180 }, { "hand", 180 }, { "fandisk", 40 }, { "rotor", 40 }, { "bunny00", 180 }, { "armadillo", 180 } })
      print_row(read_model(name, crease_angle), tolerance, argc > 1 ? argv[1] : "");
  return EXIT_SUCCESS;
}
