// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Moves the vertices of a quad mesh off a subdivision surface to approximate it better, first for the whole mesh, then for a
// part of it.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/approximation_error.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/subdivision_method_3.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace PMP = CGAL::Polygon_mesh_processing;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/double-torus-example.off");

  Mesh control_mesh;
  if(!PMP::IO::read_polygon_mesh(filename, control_mesh) || control_mesh.is_empty())
  {
    std::cerr << "error: " << filename << " is not a polygon mesh" << std::endl;
    return EXIT_FAILURE;
  }

  // The quads of a coarse step of the subdivision, with their vertices moved to their positions after further steps.
  Mesh quads = control_mesh;
  CGAL::Subdivision_method_3::CatmullClark_subdivision(quads);
  Mesh surface = quads;
  CGAL::Subdivision_method_3::CatmullClark_subdivision(surface, CGAL::parameters::number_of_iterations(3));
  for(Mesh::Vertex_index v : quads.vertices())
    quads.point(v) = surface.point(v); // vertices keep their indices

  const PMP::PN_triangle_surface<Mesh> reference(surface);
  Mesh optimized = quads;
  PMP::optimize_vertex_locations<CGAL::Parallel_if_available_tag>(optimized, reference);

  // Only some of the faces: the rest does not change.
  std::vector<Mesh::Face_index> selection;
  for(Mesh::Face_index f : quads.faces())
    if(quads.point(quads.target(quads.halfedge(f))).x() > 0)
      selection.push_back(f);
  Mesh half = quads;
  PMP::optimize_vertex_locations<CGAL::Parallel_if_available_tag>(selection, half, reference);

  std::cout << quads.number_of_faces() << " quads\nmean error " << PMP::approximation_error(quads, reference).mean
            << " before, " << PMP::approximation_error(optimized, reference).mean << " after\nof " << selection.size()
            << " of them " << PMP::approximation_error(selection, quads, reference).mean << " before, "
            << PMP::approximation_error(selection, half, reference).mean << " after" << std::endl;

  if(argc > 2) // the prefix of the names of the files
  {
    const std::string prefix = argv[2];
    PMP::triangulate_faces(surface);
    CGAL::IO::write_polygon_mesh(prefix + "surface.off", surface, CGAL::parameters::stream_precision(17));
    CGAL::IO::write_polygon_mesh(prefix + "quads.off", quads, CGAL::parameters::stream_precision(17));
  }
  return EXIT_SUCCESS;
}
