// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

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
  const double before = PMP::approximation_error(remesh, input).mean;

  PMP::optimize_vertex_locations<CGAL::Parallel_if_available_tag>(remesh, input);
  const double after = PMP::approximation_error(remesh, input).mean;

  std::cout << "mean error " << before << " before, " << after << " after the optimization" << std::endl;
  remesh.collect_garbage();
  CGAL::IO::write_polygon_mesh("optimized.off", remesh, CGAL::parameters::stream_precision(17));
  return EXIT_SUCCESS;
}
