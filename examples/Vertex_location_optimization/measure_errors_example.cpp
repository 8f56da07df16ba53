// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures the errors of a remesh before and after the optimization, in both directions, and writes them as colors and
// as a scalar:
//
//   measure_errors_example [MESH] [TARGET_EDGE_LENGTH]

#include "mesh_output.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/approximation_error.h>
#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Polygon_mesh_processing/PN_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Tag = CGAL::Parallel_if_available_tag;

namespace PMP = CGAL::Polygon_mesh_processing;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/hand.off");
  const double target_edge_length = argc > 2 ? std::atof(argv[2]) : 0.05;

  Mesh input;
  if(!PMP::IO::read_polygon_mesh(filename, input) || !CGAL::is_triangle_mesh(input))
  {
    std::cerr << "error: " << filename << " is not a triangle mesh" << std::endl;
    return EXIT_FAILURE;
  }

  Mesh remesh = input;
  PMP::isotropic_remeshing(faces(remesh), target_edge_length, remesh);
  remesh.collect_garbage();
  Mesh optimized = remesh;
  const PMP::PN_triangle_surface<Mesh> reference(input);
  PMP::optimize_vertex_locations<Tag>(optimized, reference);

  double largest_color = 0; // one scale for both
  for(auto [mesh, name] : { std::pair(&remesh, "remesh"), std::pair(&optimized, "optimized") })
  {
    auto errors = mesh->add_property_map<Mesh::Vertex_index, double>("v:error").first;
    const auto there = PMP::approximation_error<Tag>(*mesh, reference, CGAL::parameters::vertex_error_map(errors));
    const auto back = PMP::approximation_error<Tag>(input, PMP::Flat_triangle_surface<Mesh>(*mesh));
    std::cout << name << ": mean " << there.mean << ", root mean square " << there.rms << ", maximum " << there.max
              << ", maximum from the input " << back.max << std::endl;

    if(largest_color == 0)
      largest_color = 3 * there.mean;
    write_colored_PLY(name + std::string("_error.ply"), *mesh, errors, largest_color);
    write_VTP(name + std::string("_error.vtp"), *mesh, "error", errors);
  }
  return EXIT_SUCCESS;
}
