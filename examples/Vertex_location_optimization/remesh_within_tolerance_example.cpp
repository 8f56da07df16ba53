// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Finds the coarsest remesh of a mechanical part that is nowhere farther from the part than a tolerance. The remesher
// preserves the sharp edges and the corners of the part, which it receives in two maps.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/remesh_within_tolerance.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace PMP = CGAL::Polygon_mesh_processing;

// prints each attempt
struct Print_attempts : PMP::Tolerance_default_visitor
{
  void end_remeshing(const PMP::Tolerance_report& report)
  {
    std::cout << "edge length " << report.edge_length << ": " << report.number_of_vertices << " vertices, error "
              << (std::max)(report.to_reference.max, report.from_reference.max) << std::endl;
  }
};

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");

  Mesh input;
  if(!PMP::IO::read_polygon_mesh(filename, input) || !CGAL::is_triangle_mesh(input))
  {
    std::cerr << "error: " << filename << " is not a triangle mesh" << std::endl;
    return EXIT_FAILURE;
  }
  const CGAL::Bbox_3 box = PMP::bbox(input);
  const double side = (std::max)({ box.x_span(), box.y_span(), box.z_span() });
  const double tolerance = argc > 2 ? std::atof(argv[2]) : 0.01 * side;

  const double sharp = 40; // degrees
  auto is_crease = input.add_property_map<Mesh::Edge_index, bool>("e:is_crease", false).first;
  PMP::detect_sharp_edges(input, sharp, is_crease);

  const auto remesh = [](Mesh& mesh, double edge_length, const auto& is_constrained, const auto& is_corner) {
    PMP::isotropic_remeshing(faces(mesh), edge_length, mesh,
                             CGAL::parameters::edge_is_constrained_map(is_constrained)
                               .vertex_is_constrained_map(is_corner)
                               .number_of_iterations(5));
  };
  Print_attempts visitor;
  Mesh result;
  const PMP::Tolerance_report report = PMP::remesh_within_tolerance<CGAL::Parallel_if_available_tag>(
    input, tolerance, result, remesh, CGAL::parameters::edge_is_constrained_map(is_crease).visitor(std::ref(visitor)));

  std::cout << (report.is_within_tolerance ? "within" : "NOT within") << " the tolerance of " << tolerance << ": "
            << report.number_of_vertices << " of " << input.number_of_vertices() << " vertices" << std::endl;
  return report.is_within_tolerance ? EXIT_SUCCESS : EXIT_FAILURE;
}
