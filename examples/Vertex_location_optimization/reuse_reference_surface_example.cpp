// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The reference surface is constructed once and used for remeshes of several resolutions.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/approximation_error.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Polygon_mesh_processing/PN_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace PMP = CGAL::Polygon_mesh_processing;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");

  Mesh input;
  if(!PMP::IO::read_polygon_mesh(filename, input) || !CGAL::is_triangle_mesh(input))
  {
    std::cerr << "error: " << filename << " is not a triangle mesh" << std::endl;
    return EXIT_FAILURE;
  }
  const CGAL::Bbox_3 box = PMP::bbox(input);
  const double side = (std::max)({ box.x_span(), box.y_span(), box.z_span() });

  const PMP::PN_triangle_surface<Mesh> reference(input);
  for(const double relative_edge_length : { 0.1, 0.07, 0.05, 0.035 })
  {
    Mesh remesh = input;
    PMP::isotropic_remeshing(faces(remesh), relative_edge_length * side, remesh, CGAL::parameters::number_of_iterations(5));
    const double before = PMP::approximation_error(remesh, reference).mean;
    PMP::optimize_vertex_locations<CGAL::Parallel_if_available_tag>(remesh, reference);
    const double after = PMP::approximation_error(remesh, reference).mean;
    std::cout << remesh.number_of_vertices() << " vertices: mean error " << before / side << " -> " << after / side
              << " of the longest side" << std::endl;
  }
  return EXIT_SUCCESS;
}
