// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Down-samples and optimizes a geometry image: optimize_geometry_image_example [INPUT [STEP [PREFIX]]]
//
// INPUT is an image, .gim or .pfm, or a mesh with one border, from which an image is made. Every STEP-th row and column is
// kept. PREFIX is that of the names of the written files.

#include "mesh_output.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geometry_image.h>
#include <CGAL/make_geometry_image.h>
#include <CGAL/Polygon_mesh_processing/approximation_error.h>
#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/optimize_geometry_image.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Image = CGAL::Geometry_image<Kernel::Point_3>;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::parameters;

bool read_image(const std::string& filename, Image& image)
{
  const std::string extension = filename.substr(filename.find_last_of('.') + 1);
  if(extension == "gim" || extension == "pfm")
    return CGAL::IO::read_geometry_image(filename, image, params::verbose(true));

  Mesh mesh;
  image = Image(257, 257);
  return PMP::IO::read_polygon_mesh(filename, mesh, params::verbose(true)) &&
         CGAL::make_geometry_image(mesh, image, params::verbose(true));
}

// the image as a picture, with x, y and z as red, green and blue
void write_picture(const std::string& name, const Image& image)
{
  const CGAL::Bbox_3 box = CGAL::bbox_3(image.begin(), image.end());
  write_file(name, [&](const std::string& partial) {
    std::ofstream out(partial, std::ios::binary);
    out << "P6\n" << image.width() << " " << image.height() << "\n255\n";
    for(const Kernel::Point_3& p : image)
      for(int k = 0; k < 3; ++k)
      {
        const double extent = box.max(k) - box.min(k);
        out.put(static_cast<char>(extent > 0 ? 255 * (p[k] - box.min(k)) / extent : 0));
      }
    return bool(out.flush());
  });
}

// returns the error of a mesh, and writes the mesh with the errors around its vertices
PMP::Approximation_error show_error(const std::string& name, Mesh mesh, const PMP::Flat_triangle_surface<Mesh>& reference)
{
  auto errors = mesh.add_property_map<Mesh::Vertex_index, double>("v:error", 0).first;
  const auto error = PMP::approximation_error(mesh, reference, params::vertex_error_map(errors));
  write_VTP(name, mesh, "error", errors);
  return error;
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/lion-head.off");
  const int step = argc > 2 ? std::atoi(argv[2]) : 4;
  const std::string prefix = argc > 3 ? argv[3] : "";

  Image full;
  if(step < 1 || !read_image(filename, full))
  {
    std::cerr << "usage: " << argv[0] << " [INPUT [STEP [PREFIX]]]" << std::endl;
    return EXIT_FAILURE;
  }
  Mesh full_mesh;
  CGAL::geometry_image_to_polygon_mesh(full, full_mesh);
  const PMP::Flat_triangle_surface<Mesh> reference(full_mesh);

  const CGAL::Bbox_3 box = CGAL::bbox_3(full.begin(), full.end());
  const double side = (std::max)({ box.x_span(), box.y_span(), box.z_span() });

  const Image image = full.downsampled(step);
  Mesh mesh;
  CGAL::geometry_image_to_polygon_mesh(image, mesh);

  Image optimized = image;
  PMP::optimize_geometry_image<CGAL::Parallel_if_available_tag>(optimized, reference);
  Mesh optimized_mesh;
  CGAL::geometry_image_to_polygon_mesh(optimized, optimized_mesh, image); // the same triangles

  try
  {
    const auto before = show_error(prefix + "image_error.vtp", mesh, reference);
    const auto after = show_error(prefix + "optimized_error.vtp", optimized_mesh, reference);
    std::cout.precision(3);
    std::cout << full.width() << " x " << full.height() << " -> " << image.width() << " x " << image.height() << " samples\n"
              << "mean error " << before.mean << " before, " << after.mean << " after the optimization\n"
              << "maximum    " << before.max << " before, " << after.max << " after the optimization\n"
              << "colors from 0 (violet) to " << 3 * before.mean << " (yellow), " << 3e4 * before.mean / side
              << "/10000 of the longest side" << std::endl;
    write_picture(prefix + "full.ppm", full);
    write_picture(prefix + "image.ppm", image);
    write_picture(prefix + "optimized.ppm", optimized);
  }
  catch(const std::exception& e)
  {
    std::cerr << "error: " << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return CGAL::IO::write_geometry_image(prefix + "optimized.gim", optimized, params::verbose(true)) ? EXIT_SUCCESS
                                                                                                    : EXIT_FAILURE;
}
