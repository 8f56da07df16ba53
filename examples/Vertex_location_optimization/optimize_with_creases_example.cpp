// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The sharp edges of a mechanical part are constrained in the remeshing, and the same map then tells the optimization
// which edges are creases.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/approximation_error.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace PMP = CGAL::Polygon_mesh_processing;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  const double target_edge_length = argc > 2 ? std::atof(argv[2]) : 0.04;

  Mesh input;
  if(!PMP::IO::read_polygon_mesh(filename, input) || !CGAL::is_triangle_mesh(input))
  {
    std::cerr << "error: " << filename << " is not a triangle mesh" << std::endl;
    return EXIT_FAILURE;
  }

  const double sharp = 40; // degrees
  Mesh remesh = input;
  auto is_crease = remesh.add_property_map<Mesh::Edge_index, bool>("e:is_crease", false).first;
  PMP::detect_sharp_edges(remesh, sharp, is_crease);
  PMP::isotropic_remeshing(faces(remesh), target_edge_length, remesh,
                           CGAL::parameters::edge_is_constrained_map(is_crease).number_of_iterations(5));

  // the reference has its creases where the remesh has them
  const auto creases_of_input = CGAL::parameters::sharpness_angle(sharp);
  const auto before = PMP::approximation_error(remesh, input, CGAL::parameters::default_values(), creases_of_input);
  PMP::optimize_vertex_locations<CGAL::Parallel_if_available_tag>(
    remesh, input, CGAL::parameters::edge_is_constrained_map(is_crease).relax_constraints(true), creases_of_input);
  const auto after = PMP::approximation_error(remesh, input, CGAL::parameters::default_values(), creases_of_input);

  std::cout << "mean error " << before.mean << " before, " << after.mean << " after the optimization\n"
            << "maximum    " << before.max << " before, " << after.max << " after" << std::endl;
  return EXIT_SUCCESS;
}
