// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes an optimized remesh without normals, with its own normals, and with normals fitted to those of the input; and the
// input.

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

// as text, with the normals if it has the property "v:normal"
bool write(const std::string& name, const Mesh& mesh)
{
  std::ofstream out(name);
  out.precision(17);
  return out && CGAL::IO::write_PLY(out, mesh);
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/bunny00.off");
  const double target_edge_length = argc > 2 ? std::atof(argv[2]) : 0.04;
  const std::string prefix = argc > 3 ? argv[3] : "";

  Mesh input;
  if(!PMP::IO::read_polygon_mesh(filename, input) || !CGAL::is_triangle_mesh(input))
  {
    std::cerr << "error: " << filename << " is not a triangle mesh" << std::endl;
    return EXIT_FAILURE;
  }

  const PMP::PN_triangle_surface<Mesh> reference(input);
  Mesh remesh = input;
  PMP::isotropic_remeshing(faces(remesh), target_edge_length, remesh, CGAL::parameters::number_of_iterations(5));
  remesh.collect_garbage();
  PMP::optimize_vertex_locations<Concurrency>(remesh, reference);

  std::cout << "mean angle to the normals of the input, in degrees\n"
            << "  normals of the faces: " << PMP::normal_deviation<Concurrency>(remesh, reference) << std::endl;
  bool is_written = write(prefix + "face_normals.ply", remesh);

  auto normals = remesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
  PMP::compute_vertex_normals(remesh, normals);
  std::cout << "  own vertex normals:   " << PMP::normal_deviation<Concurrency>(remesh, reference, normals) << std::endl;
  is_written = is_written && write(prefix + "own_normals.ply", remesh);

  PMP::optimize_vertex_normals<Concurrency>(remesh, reference, normals);
  std::cout << "  optimized normals:    " << PMP::normal_deviation<Concurrency>(remesh, reference, normals) << std::endl;
  is_written = is_written && write(prefix + "optimized_normals.ply", remesh);

  auto input_normals = input.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
  PMP::compute_vertex_normals(input, input_normals);
  is_written = is_written && write(prefix + "input_normals.ply", input);
  if(!is_written)
    std::cerr << "error: a mesh cannot be written" << std::endl;
  return is_written ? EXIT_SUCCESS : EXIT_FAILURE;
}
