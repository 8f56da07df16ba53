// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_EXAMPLES_MESH_INPUT_H
#define VERTEX_LOCATION_OPTIMIZATION_EXAMPLES_MESH_INPUT_H

#include "mesh_attributes.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

inline void require_of_file(const bool condition, const std::string& name, const std::string& message)
{
  if(!condition)
    throw std::runtime_error(name + ": " + message);
}

// Whether a word of a text file is a number that is not finite.
inline bool is_infinite_number(const std::string& word)
{
  char* end = nullptr;
  const double x = std::strtod(word.c_str(), &end);
  return end != word.c_str() && *end == 0 && !std::isfinite(x);
}

// The words of a text file, without comments.
inline std::vector<std::string> read_words(const std::string& name)
{
  std::ifstream in(name);
  std::vector<std::string> words;
  for(std::string line, word; std::getline(in, line);)
    for(std::istringstream rest(line.substr(0, line.find('#'))); rest >> word;)
      words.push_back(word);
  return words;
}

// Says what is wrong with an OFF file that could not be read; empty if nothing was found.
inline std::string find_error_of_OFF(const std::vector<std::string>& words)
{
  if(words.empty() || words[0].size() < 3 || words[0].substr(words[0].size() - 3) != "OFF")
    return "it does not begin with OFF";
  if(words.size() < 4)
    return "it ends before the numbers of its vertices and faces";
  const std::size_t vertices = std::strtoul(words[1].c_str(), nullptr, 10);
  const std::size_t faces = std::strtoul(words[2].c_str(), nullptr, 10);
  const std::size_t least_number_of_words = 3 * vertices + 4 * faces; // of triangles without colors
  if(words.size() < 4 + least_number_of_words)
    return "it is truncated: it says that it has " + words[1] + " vertices and " + words[2] + " faces";
  return "";
}

// Says what is wrong with a file that could not be read.
inline std::string find_error(const std::string& name, const std::string& extension)
{
  const std::vector<std::string> words = read_words(name);
  if(std::any_of(words.begin(), words.end(), is_infinite_number))
    return "a coordinate is not finite";
  const std::string error = extension == ".off" ? find_error_of_OFF(words) : "";
  return error.empty() ? "it is truncated or malformed" : error;
}

// Throws if a file cannot be a readable mesh.
inline void check_file(const std::string& name, const std::string& extension)
{
  require_of_file(std::filesystem::exists(name), name, "there is no such file");
  require_of_file(std::filesystem::is_regular_file(name), name, "it is no file");
  const std::vector<std::string> known{ ".off", ".obj", ".ply", ".stl", ".ts", ".vtp" };
  require_of_file(std::find(known.begin(), known.end(), extension) != known.end(), name,
                  "its extension is none of .off, .obj, .ply, .stl, .ts, .vtp");
  require_of_file(std::filesystem::file_size(name) > 0, name, "it is empty");
  std::ifstream in(name);
  require_of_file(bool(in), name, "it cannot be opened");
  std::string first_line;
  std::getline(in, first_line);
  require_of_file(extension != ".off" || first_line.find("BINARY") == std::string::npos, name,
                  "it is a binary OFF file, which is not read; write it as text");
}

// Reads a file that is not a manifold mesh, as a polygon soup from which a mesh is made. Its attributes are lost.
template <typename Point>
void read_and_repair(const std::string& name, const std::string& extension, CGAL::Surface_mesh<Point>& mesh)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  if(!CGAL::IO::read_polygon_soup(name, points, polygons))
    throw std::runtime_error(name + ": " + find_error(name, extension));
  PMP::repair_polygon_soup(points, polygons);
  const std::size_t number_of_points = points.size();
  PMP::orient_polygon_soup(points, polygons);
  require_of_file(PMP::is_polygon_soup_a_polygon_mesh(polygons), name, "its faces make no manifold mesh");
  PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  if(points.size() > number_of_points)
    std::printf("%s: %zu vertices were duplicated to make the mesh manifold\n", name.c_str(),
                points.size() - number_of_points);
}

// Reads a mesh with its attributes, and throws if that is not possible.
template <typename Point>
CGAL::Surface_mesh<Point> read_mesh(const std::string& name)
{
  std::string extension = std::filesystem::path(name).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return std::tolower(c); });
  check_file(name, extension);
  CGAL::Surface_mesh<Point> mesh;
  bool is_read = false;
  try
  {
    is_read = read_mesh_with_attributes(name, mesh);
  }
  catch(const std::bad_alloc&)
  {
    throw std::runtime_error(name + ": it announces more elements than there is memory for");
  }
  if(!is_read)
    read_and_repair(name, extension, mesh);
  require_of_file(mesh.number_of_faces() > 0, name, "it has no face");
  for(const Point& p : mesh.points())
    require_of_file(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()), name,
                    "a coordinate is not finite");
  return mesh;
}

// The same for a mesh that must consist of triangles, into which its faces are split on request.
template <typename Point>
CGAL::Surface_mesh<Point> read_triangle_mesh(const std::string& name, const bool is_triangulated)
{
  CGAL::Surface_mesh<Point> mesh = read_mesh<Point>(name);
  if(CGAL::is_triangle_mesh(mesh))
    return mesh;
  require_of_file(is_triangulated, name, "its faces are not all triangles; --triangulate makes triangles of them");
  if(Mesh_attributes<Point> attributes(mesh); attributes.has_texture)
  {
    std::printf("texture coordinates are not kept with --triangulate\n");
    mesh.remove_property_map(attributes.texture);
  }
  require_of_file(CGAL::Polygon_mesh_processing::triangulate_faces(mesh), name, "a face cannot be triangulated");
  return mesh;
}

#endif // VERTEX_LOCATION_OPTIMIZATION_EXAMPLES_MESH_INPUT_H
