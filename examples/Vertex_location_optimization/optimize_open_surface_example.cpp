// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The border of an open surface is fitted to that of the input, or left as it is.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/approximation_error.h>
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
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/lion-head.off");
  const double target_edge_length = argc > 2 ? std::atof(argv[2]) : 0.02;

  Mesh input;
  if(!PMP::IO::read_polygon_mesh(filename, input) || !CGAL::is_triangle_mesh(input))
  {
    std::cerr << "error: " << filename << " is not a triangle mesh" << std::endl;
    return EXIT_FAILURE;
  }

  Mesh remesh = input;
  PMP::isotropic_remeshing(faces(remesh), target_edge_length, remesh, CGAL::parameters::number_of_iterations(5));
  const PMP::PN_triangle_surface<Mesh> surface(input);
  const auto before = PMP::approximation_error(remesh, surface);

  // If another mesh shares this border, it must not move.
  Mesh with_fixed_border = remesh;
  PMP::optimize_vertex_locations<CGAL::Parallel_if_available_tag>(with_fixed_border, surface);
  const auto fixed = PMP::approximation_error(with_fixed_border, surface);

  // Otherwise, the border may follow that of the input.
  PMP::optimize_vertex_locations<CGAL::Parallel_if_available_tag>(remesh, surface,
                                                                  CGAL::parameters::relax_constraints(true));
  const auto relaxed = PMP::approximation_error(remesh, surface);

  std::cout << "mean error " << before.mean << " before, " << fixed.mean << " with the border fixed, " << relaxed.mean
            << " with the border relaxed" << std::endl;
  return EXIT_SUCCESS;
}
