// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Keeps the colors of a mesh in a remesh. Writes the mesh, the remesh with the colors at the closest points of its vertices,
// and the remesh with fitted colors.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/Color.h>
#include <CGAL/Polygon_mesh_processing/attribute_error.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_attributes.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Color = CGAL::IO::Color;
using Color_map = Mesh::Property_map<Mesh::Vertex_index, Color>;
using Surface = CGAL::Polygon_mesh_processing::PN_triangle_surface<Mesh>;

namespace PMP = CGAL::Polygon_mesh_processing;
using Concurrency = CGAL::Parallel_if_available_tag;

unsigned char channel(double x) { return static_cast<unsigned char>(std::lround(x)); }

// Rings around the z-axis that become finer outwards, in the end finer than the faces of the remesh.
Color_map add_rings(Mesh& mesh)
{
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  auto colors = mesh.add_property_map<Mesh::Vertex_index, Color>("v:color").first;
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    const double x = (mesh.point(v).x() - box.xmin()) / box.x_span() - 0.5,
                 y = (mesh.point(v).y() - box.ymin()) / box.x_span() - 0.5;
    const double ring = std::cos(120 * (x * x + y * y));
    colors[v] = Color(channel(155 + 95 * ring), channel(130 + 60 * ring), channel(130 - 90 * ring));
  }
  return colors;
}

// the color at the closest point of the surface
Color sample(const Mesh& input, const Surface& surface, const Color_map& colors, const Point& p)
{
  const auto [face, coordinates] = surface.location(surface.project(p));
  const Mesh::Halfedge_index h = input.halfedge(face);
  double red = 0, green = 0, blue = 0;
  int i = 0;
  for(Mesh::Vertex_index v : { input.source(h), input.target(h), input.target(input.next(h)) })
  {
    red += coordinates[i] * colors[v].red();
    green += coordinates[i] * colors[v].green();
    blue += coordinates[i] * colors[v].blue();
    ++i;
  }
  return Color(channel(red), channel(green), channel(blue));
}

// with its property "v:color"
bool write(const std::string& name, const Mesh& mesh)
{
  std::ofstream out(name);
  out.precision(17);
  return out && CGAL::IO::write_PLY(out, mesh);
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/bunny00.off");
  const double target_edge_length = argc > 2 ? std::atof(argv[2]) : 0.03;
  const std::string prefix = argc > 3 ? argv[3] : "";

  Mesh input;
  if(!PMP::IO::read_polygon_mesh(filename, input) || !CGAL::is_triangle_mesh(input))
  {
    std::cerr << "error: " << filename << " is not a triangle mesh" << std::endl;
    return EXIT_FAILURE;
  }
  const Color_map input_colors = add_rings(input);
  bool is_written = write(prefix + "input_colors.ply", input);

  const Surface reference(input);
  Mesh remesh = input;
  PMP::isotropic_remeshing(faces(remesh), target_edge_length, remesh, CGAL::parameters::number_of_iterations(5));
  remesh.collect_garbage();
  PMP::optimize_vertex_locations<Concurrency>(remesh, reference);

  auto colors = remesh.add_property_map<Mesh::Vertex_index, Color>("v:color").first;
  for(Mesh::Vertex_index v : remesh.vertices())
    colors[v] = sample(input, reference, input_colors, remesh.point(v));
  std::cout << "mean difference to the colors of the input\n"
            << "  at the closest points: " << PMP::attribute_error<Concurrency>(remesh, reference, input_colors, colors).mean
            << std::endl;
  is_written = is_written && write(prefix + "sampled_colors.ply", remesh);

  PMP::optimize_vertex_attributes<Concurrency>(remesh, reference, input_colors, colors);
  std::cout << "  optimized:             " << PMP::attribute_error<Concurrency>(remesh, reference, input_colors, colors).mean
            << std::endl;
  is_written = is_written && write(prefix + "optimized_colors.ply", remesh);
  if(!is_written)
    std::cerr << "error: a mesh cannot be written" << std::endl;
  return is_written ? EXIT_SUCCESS : EXIT_FAILURE;
}
