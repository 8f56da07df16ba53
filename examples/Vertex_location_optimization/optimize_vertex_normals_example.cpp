// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes an optimized remesh with its own normals and one with those that are fitted to the input.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/approximation_error.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_normals.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace PMP = CGAL::Polygon_mesh_processing;
using Concurrency = CGAL::Parallel_if_available_tag;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/bunny00.off");
  const double target_edge_length = argc > 2 ? std::atof(argv[2]) : 0.04;
  const std::string prefix = argc > 3 ? argv[3] : "";

  Mesh input;
  if(!PMP::IO::read_polygon_mesh(filename, input) || !CGAL::is_triangle_mesh(input))
  {
    std::cerr << "error: " << filename << " is no triangle mesh" << std::endl;
    return EXIT_FAILURE;
  }

  const PMP::PN_triangle_surface<Mesh> reference(input);
  Mesh remesh = input;
  PMP::isotropic_remeshing(faces(remesh), target_edge_length, remesh, CGAL::parameters::number_of_iterations(5));
  remesh.collect_garbage();
  PMP::optimize_vertex_locations<Concurrency>(remesh, reference);

  auto write = [&](const std::string& name)
  {
    std::ofstream out(prefix + name + ".ply", std::ios::binary);
    CGAL::IO::set_binary_mode(out);
    return CGAL::IO::write_PLY(out, remesh); // with the property "v:normal"
  };
  auto normals = remesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
  std::cout << "mean angle to the normals of the input, in degrees\n"
            << "  normals of the faces: " << PMP::normal_deviation<Concurrency>(remesh, reference) << std::endl;

  PMP::compute_vertex_normals(remesh, normals);
  std::cout << "  own vertex normals:   " << PMP::normal_deviation<Concurrency>(remesh, reference, normals) << std::endl;
  const bool is_written = write("own_normals");

  PMP::optimize_vertex_normals<Concurrency>(remesh, reference, normals);
  std::cout << "  optimized normals:    " << PMP::normal_deviation<Concurrency>(remesh, reference, normals) << std::endl;
  return is_written && write("optimized_normals") ? EXIT_SUCCESS : EXIT_FAILURE;
}
