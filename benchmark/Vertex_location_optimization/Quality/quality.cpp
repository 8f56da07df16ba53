// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Remeshes models, optimizes the remeshes with both placement methods, and prints the errors and the deviations of the
// normals as the two tables of RESULTS.md:
//
//   quality [DIRECTORY]
//
// The models are CGAL's data; a lucy.off in DIRECTORY is measured, too.

#include <CGAL/Polygon_mesh_processing/approximation_error.h>
#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_normals.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <tuple>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Surface = PMP::PN_triangle_surface<Mesh>;
using Tag = CGAL::Parallel_if_available_tag;

struct Model
{
  std::string name;
  std::string file;
  double edge_length; // relative to the longest side of the bounding box
};

double longest_side(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  return (std::max)({ box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin() });
}

struct Angles
{
  double mean = 0;
  double smallest = 180;
};

Angles smallest_angles(const Mesh& mesh)
{
  Angles angles;
  for(Mesh::Face_index f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    const auto &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)), &r = mesh.point(mesh.target(mesh.next(h)));
    const double angle = (std::min)({ CGAL::approximate_angle(p, q, r), CGAL::approximate_angle(q, r, p),
                                      CGAL::approximate_angle(r, p, q) });
    angles.mean += angle / mesh.number_of_faces();
    angles.smallest = (std::min)(angles.smallest, angle);
  }
  return angles;
}

void print_errors(const std::string& name, const char* what, const Mesh& mesh, const Mesh& input, const Surface& surface,
                  double unit, double seconds)
{
  const PMP::Approximation_error to = PMP::approximation_error<Tag>(mesh, surface);
  const PMP::Approximation_error back =
    PMP::approximation_error<Tag>(input, PMP::Flat_triangle_surface<Mesh>(mesh), CGAL::parameters::number_of_points_per_face(4));
  const Angles angles = smallest_angles(mesh);
  std::printf("| %s | %s | %zu | %.2f | %.1f | %.2f | %.1f | %.1f | %.1f | %.2f |\n", name.c_str(), what,
              std::size_t(mesh.number_of_vertices()), to.mean / unit, to.max / unit, back.mean / unit, back.max / unit,
              angles.mean, angles.smallest, seconds);
  std::fflush(stdout);
}

void measure(const Model& model, std::string& normals_table)
{
  Mesh input;
  if(!PMP::IO::read_polygon_mesh(model.file, input))
  {
    std::fprintf(stderr, "%s cannot be read\n", model.file.c_str());
    return;
  }
  const double unit = 1e-4 * longest_side(input);
  CGAL::Real_timer timer;

  Mesh remesh = input;
  timer.start();
  PMP::isotropic_remeshing(faces(remesh), model.edge_length * longest_side(input), remesh,
                           CGAL::parameters::number_of_iterations(10).number_of_relaxation_steps(3));
  timer.stop();
  remesh.collect_garbage();
  const Surface surface(input);
  print_errors(model.name, "remesh", remesh, input, surface, unit, timer.time());

  Mesh fitted, least_squares;
  for(auto [mesh, method, name] : { std::tuple(&fitted, PMP::PIECEWISE_LINEAR, "piecewise linear"),
                                    std::tuple(&least_squares, PMP::LEAST_SQUARES, "least squares") })
  {
    *mesh = remesh;
    timer.reset();
    timer.start();
    PMP::optimize_vertex_locations<Tag>(*mesh, surface, CGAL::parameters::placement_method(method));
    timer.stop();
    print_errors(model.name, name, *mesh, input, surface, unit, timer.time());
  }

  auto own = fitted.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:own").first;
  auto sampled = fitted.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:sampled").first;
  auto optimized = fitted.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:optimized").first;
  PMP::compute_vertex_normals(fitted, own);
  for(Mesh::Vertex_index v : fitted.vertices())
    sampled[v] = surface.normal(surface.project(fitted.point(v)));
  PMP::optimize_vertex_normals<Tag>(fitted, surface, optimized);
  char row[200];
  std::snprintf(row, sizeof row, "| %s | %.2f | %.2f | %.2f | %.2f | %.2f |\n", model.name.c_str(),
                PMP::normal_deviation<Tag>(remesh, surface), PMP::normal_deviation<Tag>(fitted, surface),
                PMP::normal_deviation<Tag>(fitted, surface, own), PMP::normal_deviation<Tag>(fitted, surface, sampled),
                PMP::normal_deviation<Tag>(fitted, surface, optimized));
  normals_table += row;
}

int main(int argc, char** argv)
{
  auto data = [](const char* name, double edge_length)
  {
    char length[20];
    std::snprintf(length, sizeof length, " %g", edge_length);
    return Model{ name + std::string(length), CGAL::data_file_path("meshes/" + std::string(name) + ".off"), edge_length };
  };
  std::vector<Model> models{ data("armadillo", 0.012), data("armadillo", 0.03), data("bunny00", 0.02),
                             data("bunny00", 0.05), data("refined_elephant", 0.025), data("elephant", 0.03),
                             data("knot1", 0.04), data("hand", 0.05), data("lion-head", 0.03),
                             data("ChineseDragon-10kv", 0.025) };
  if(argc > 1)
    models.push_back({ "lucy 0.0098", argv[1] + std::string("/lucy.off"), 0.0098 });

  std::printf("| model | mesh | vertices | mean | max | mean back | max back | mean angle | smallest | seconds |\n"
              "|---|---|---|---|---|---|---|---|---|---|\n");
  std::string normals_table;
  for(const Model& model : models)
    measure(model, normals_table);
  std::printf("\n| model | faces of the remesh | faces | own vertex normals | sampled | optimized |\n|---|---|---|---|---|---|\n%s",
              normals_table.c_str());
}
