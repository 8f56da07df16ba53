// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_MODELS_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_MODELS_H

#include <CGAL/boost/graph/generators.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/subdivision_method_3.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Concurrency_tag = CGAL::Parallel_if_available_tag;

// by how much the paper reduces the errors of a model, in percent; empty where that is not known
struct Paper
{
  std::string mean, max;
};

// what is remeshed, and how
struct Model
{
  std::string name;
  Mesh input;
  double edge_length; // relative to the longest side of the bounding box
  Paper paper = {};
  bool is_flat = false;      // the reference: the faces of the input, or its PN triangles
  double crease_angle = 180; // sharper edges are constrained
};

inline double longest_side(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  return (std::max)({ box.x_span(), box.y_span(), box.z_span() });
}

// the mesh in a file; an empty one, and a message, if it cannot be read
inline Mesh read_model(const std::string& file)
{
  Mesh mesh;
  if(PMP::IO::read_polygon_mesh(file, mesh) && CGAL::is_triangle_mesh(mesh) && longest_side(mesh) > 0)
    return mesh;
  std::cerr << file << ": it is no triangle mesh that can be read; left out" << std::endl;
  return Mesh();
}

// the unit sphere
inline Mesh make_sphere(unsigned int number_of_subdivisions)
{
  Mesh mesh;
  CGAL::make_icosahedron<Mesh, Point>(mesh);
  CGAL::Subdivision_method_3::PTQ(mesh, CGAL::Linear_mask_3<Mesh>(&mesh, mesh.points()),
                                  CGAL::parameters::number_of_iterations(number_of_subdivisions));
  for(Point& p : mesh.points())
    p = CGAL::ORIGIN + (p - CGAL::ORIGIN) / std::sqrt(CGAL::squared_distance(p, Point(CGAL::ORIGIN)));
  return mesh;
}

inline std::string data_file(const std::string& name) { return CGAL::data_file_path("meshes/" + name + ".off"); }

// the file of a model that CGAL does not have, in one of the directories; an empty name if there is none
inline std::string find_file(const std::vector<std::string>& directories, const std::string& name)
{
  for(const std::string& directory : directories)
    if(const auto file = std::filesystem::path(directory) / name; std::filesystem::is_regular_file(file))
      return file.string();
  return "";
}

// the files that hold a mesh, in alphabetical order
inline std::vector<std::filesystem::path> mesh_files(const std::string& directory)
{
  std::vector<std::filesystem::path> files;
  for(const auto& entry : std::filesystem::directory_iterator(directory))
    for(const char* extension : { ".off", ".obj", ".ply", ".stl" })
      if(entry.path().extension() == extension)
        files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// the edge length of a remesh of equilateral triangles with a quarter of the vertices
inline double edge_length_for_a_quarter(const Mesh& mesh)
{
  return std::sqrt(8 / std::sqrt(3.) * PMP::area(mesh) / mesh.number_of_vertices()) / longest_side(mesh);
}

// The rows of Table 1. The paper's remeshes cannot be repeated: the edge lengths are ours.
inline std::vector<Model> models_of_table_1(const std::vector<std::string>& directories)
{
  std::vector<Model> models;
  auto add = [&](const std::string& name, const std::string& file, double edge_length, Paper paper = {},
                 bool is_flat = false, double crease_angle = 180) {
    if(Mesh mesh = read_model(file); !mesh.is_empty())
    {
      const double length = edge_length > 0 ? edge_length : edge_length_for_a_quarter(mesh);
      models.push_back({ name, std::move(mesh), length, paper, is_flat, crease_angle });
    }
  };

  models.push_back({ "sphere", make_sphere(6), 0.062, { "74.5", "41.1" } });
  add("armadillo", data_file("armadillo"), 0.012, { "51.4", "32.4" });
  add("fandisk", data_file("fandisk"), 0.04, { "25.0", "15.1" }, true);
  add("fandisk, creases", data_file("fandisk"), 0.04, { "25.0", "15.1" }, true, 40);
  add("bunny00", data_file("bunny00"), 0.02);
  add("refined_elephant", data_file("refined_elephant"), 0.025);
  add("elephant", data_file("elephant"), 0.03);
  add("knot1", data_file("knot1"), 0.04);
  add("hand", data_file("hand"), 0.05);
  add("ChineseDragon-10kv", data_file("ChineseDragon-10kv"), 0.025);
  for(const std::string& directory : directories)
    for(const std::filesystem::path& file : mesh_files(directory))
      if(file.stem() != "lucy") // see Table 2
        add(file.stem().string(), file.string(), 0, file.stem() == "david" ? Paper{ "44", "" } : Paper{});
  return models;
}

// a model with edge lengths, longest first
struct Series
{
  Model model;
  std::vector<double> edge_lengths;
};

// Table 2 and Figure 6: Lucy, as in the paper, where a directory has it, and CGAL's armadillo.
inline std::vector<Series> models_of_table_2(const std::vector<std::string>& directories)
{
  std::vector<Series> series;
  auto add = [&](const std::string& name, const std::string& file, std::vector<double> edge_lengths, Paper paper) {
    if(Mesh mesh = read_model(file); !mesh.is_empty())
      series.push_back({ { name, std::move(mesh), 0, paper }, std::move(edge_lengths) });
  };
  if(const std::string file = find_file(directories, "lucy.off"); !file.empty())
    add("lucy", file, { 0.0277, 0.0196, 0.0139, 0.0098, 0.0069 }, { "42.9-48.1", "" });
  add("armadillo", data_file("armadillo"), { 0.034, 0.024, 0.017, 0.012, 0.0085 }, {});
  return series;
}

// the models whose normals are compared; the paper does so with David
inline std::vector<Model> models_of_normals(const std::vector<std::string>& directories)
{
  std::vector<Model> models;
  auto add = [&](const std::string& name, const std::string& file, double edge_length) {
    if(Mesh mesh = read_model(file); !mesh.is_empty())
      models.push_back({ name, std::move(mesh), edge_length });
  };
  for(const char* name : { "david", "lucy" })
    if(const std::string file = find_file(directories, name + std::string(".off")); !file.empty())
      add(name, file, 0.0098);
  add("armadillo", data_file("armadillo"), 0.012);
  add("bunny00", data_file("bunny00"), 0.02);
  add("knot1", data_file("knot1"), 0.04);
  add("refined_elephant", data_file("refined_elephant"), 0.025);
  return models;
}

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_MODELS_H
