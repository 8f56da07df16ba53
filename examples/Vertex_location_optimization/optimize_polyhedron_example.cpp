// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The remesh is a Polyhedron_3 and the input a Surface_mesh: the two can be of different types.

#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/approximation_error.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;

namespace PMP = CGAL::Polygon_mesh_processing;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/knot1.off");
  const double target_edge_length = argc > 2 ? std::atof(argv[2]) : 0.05;

  Mesh input;
  if(!PMP::IO::read_polygon_mesh(filename, input) || !CGAL::is_triangle_mesh(input))
  {
    std::cerr << "error: " << filename << " is not a triangle mesh" << std::endl;
    return EXIT_FAILURE;
  }

  Polyhedron remesh;
  CGAL::copy_face_graph(input, remesh);
  PMP::isotropic_remeshing(faces(remesh), target_edge_length, remesh, CGAL::parameters::number_of_iterations(5));
  std::cout << "before: " << PMP::approximation_error(remesh, input).mean << std::endl;

  const auto report = PMP::optimize_vertex_locations<CGAL::Parallel_if_available_tag>(
    remesh, input, CGAL::parameters::number_of_free_iterations(10).number_of_iterations(20));
  std::cout << "after " << report.iterations << " iterations: " << PMP::approximation_error(remesh, input).mean << std::endl;
  return EXIT_SUCCESS;
}
