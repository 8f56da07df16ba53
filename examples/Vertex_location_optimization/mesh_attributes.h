// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_EXAMPLES_MESH_ATTRIBUTES_H
#define VERTEX_LOCATION_OPTIMIZATION_EXAMPLES_MESH_ATTRIBUTES_H

#include "mesh_output.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/IO/Color.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_attributes.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/version.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

// The attributes of a mesh in a file. CGAL's readers of PLY and OFF store them as "v:color" and "v:normal"; the texture
// coordinates of an OBJ file are read here, to "h:texture".
template <typename Point>
struct Mesh_attributes
{
  using Mesh = CGAL::Surface_mesh<Point>;
  using Kernel = typename CGAL::Kernel_traits<Point>::Kernel;
  using Vector = typename Kernel::Vector_3;
  using Vertex = typename Mesh::Vertex_index;
  using Halfedge = typename Mesh::Halfedge_index;
  using Color_map = typename Mesh::template Property_map<Vertex, CGAL::IO::Color>;
  using Normal_map = typename Mesh::template Property_map<Vertex, Vector>;
  using Texture_map = typename Mesh::template Property_map<Halfedge, typename Kernel::Point_2>;

  explicit Mesh_attributes(const Mesh& mesh)
  {
    std::tie(colors, has_colors) = find<Color_map>(mesh, "v:color");
    std::tie(normals, has_normals) = find<Normal_map>(mesh, "v:normal");
    std::tie(texture, has_texture) = find<Texture_map>(mesh, "h:texture");
  }

  Color_map colors;
  Normal_map normals;
  Texture_map texture; // of the corners of the faces: at the target of a halfedge
  bool has_colors, has_normals, has_texture;

private:
  // the return type of `property_map()` depends on the version of CGAL
  template <typename Map>
  static std::pair<Map, bool> find(const Mesh& mesh, const std::string& name)
  {
    const auto found = mesh.template property_map<typename Map::key_type, typename Map::value_type>(name);
#if CGAL_VERSION_MAJOR >= 6
    return found ? std::pair(Map(*found), true) : std::pair(Map(), false);
#else
    return found;
#endif
  }
};

// The texture coordinates of an OBJ file, and the corners that have them.
template <typename Point_2>
class Textured_corners
{
public:
  explicit Textured_corners(const std::string& name)
  {
    std::ifstream in(name);
    for(std::string line; std::getline(in, line);)
    {
      std::istringstream words(line);
      std::string word;
      words >> word;
      if(word == "v")
        ++m_number_of_vertices;
      else if(word == "vt")
      {
        double u = 0, v = 0;
        words >> u >> v;
        m_coordinates.emplace_back(u, v);
      }
      else if(word == "f")
        read_face(words);
    }
  }

  std::size_t number_of_vertices() const { return m_number_of_vertices; }

  // the coordinates at a vertex in the face in which it follows another one; null if there are none
  const Point_2* find(std::size_t previous, std::size_t vertex) const
  {
    const auto corner = m_corners.find({ previous, vertex });
    return corner == m_corners.end() || corner->second >= m_coordinates.size() ? nullptr : &m_coordinates[corner->second];
  }

private:
  void read_face(std::istream& words)
  {
    // numbers are from 1 on, or backwards from the last one; out of range if there is none
    const auto to_index = [](long i, std::size_t size) { return static_cast<std::size_t>(i > 0 ? i - 1 : long(size) + i); };
    std::vector<std::pair<std::size_t, std::size_t>> corners;
    for(std::string word; words >> word;)
    {
      char* end = nullptr;
      const long vertex = std::strtol(word.c_str(), &end, 10);
      const long texture = *end == '/' ? std::strtol(end + 1, nullptr, 10) : 0;
      corners.emplace_back(to_index(vertex, m_number_of_vertices),
                           texture == 0 ? std::size_t(-1) : to_index(texture, m_coordinates.size()));
    }
    for(std::size_t i = 0; i < corners.size(); ++i)
      m_corners[{ corners[(i + corners.size() - 1) % corners.size()].first, corners[i].first }] = corners[i].second;
  }

  std::size_t m_number_of_vertices = 0;
  std::vector<Point_2> m_coordinates;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> m_corners; // by the vertex before, and the vertex
};

// Reads the texture coordinates of an OBJ file to "h:texture" if each corner of the mesh has some. The vertices of the mesh
// must be those of the file.
template <typename Point>
void read_texture(const std::string& name, CGAL::Surface_mesh<Point>& mesh)
{
  using Attributes = Mesh_attributes<Point>;
  using Vertex = typename Attributes::Vertex;
  using Point_2 = typename Attributes::Kernel::Point_2;

  const Textured_corners<Point_2> corners(name);
  if(corners.number_of_vertices() != mesh.number_of_vertices())
    return;
  auto texture = mesh.template add_property_map<typename Attributes::Halfedge, Point_2>("h:texture").first;
  for(auto h : mesh.halfedges())
    if(!mesh.is_border(h))
    {
      const auto at = [](Vertex v) { return static_cast<std::size_t>(v); };
      const Point_2* coordinates = corners.find(at(mesh.source(h)), at(mesh.target(h)));
      if(coordinates == nullptr)
      {
        mesh.remove_property_map(texture);
        return;
      }
      texture[h] = *coordinates;
    }
}

// Reads a mesh with its attributes. Returns false if it is unreadable or not a valid mesh; the mesh is then empty.
template <typename Point>
bool read_mesh_with_attributes(const std::string& name, CGAL::Surface_mesh<Point>& mesh)
{
  const std::string extension = std::filesystem::path(name).extension().string();
  bool is_read = false;
  mesh.clear();
  if(extension == ".ply")
  {
    std::ifstream in(name, std::ios::binary);
    std::string comments;
    is_read = CGAL::IO::read_PLY(in, mesh, comments, false);
  }
  else if(extension == ".off")
    is_read = CGAL::IO::read_OFF(name, mesh);
  else
    is_read = CGAL::IO::read_polygon_mesh(name, mesh);

  if(!is_read)
    mesh.clear();
  else if(extension == ".obj")
    read_texture(name, mesh);
  return is_read;
}

// Whether the two sides of an edge have different texture coordinates.
template <typename Mesh, typename TextureMap>
bool is_texture_seam(const Mesh& mesh, const TextureMap& texture, typename Mesh::Edge_index e)
{
  const auto h = mesh.halfedge(e), o = mesh.opposite(h);
  return !mesh.is_border(e) && (texture[h] != texture[mesh.prev(o)] || texture[o] != texture[mesh.prev(h)]);
}

// Transfers the attributes of the input to a remesh with marked seams.
template <typename ConcurrencyTag, typename Point, typename Reference, typename SeamMap>
void transfer_attributes(const CGAL::Surface_mesh<Point>& input,
                         const Reference& reference,
                         CGAL::Surface_mesh<Point>& mesh,
                         const SeamMap& is_seam)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  using Attributes = Mesh_attributes<Point>;
  using Vector = typename Attributes::Vector;

  const Attributes from(input);
  if(from.has_colors)
  {
    auto colors = mesh.template add_property_map<typename Attributes::Vertex, CGAL::IO::Color>("v:color").first;
    PMP::optimize_vertex_attributes<ConcurrencyTag>(mesh, reference, from.colors, colors);
  }
  if(from.has_normals)
  {
    auto normals = mesh.template add_property_map<typename Attributes::Vertex, Vector>("v:normal").first;
    PMP::optimize_vertex_attributes<ConcurrencyTag>(mesh, reference, from.normals, normals);
    for(auto v : mesh.vertices())
      if(const double length = std::sqrt(normals[v].squared_length()); length > 0)
        normals[v] = normals[v] / length;
  }
  if(from.has_texture)
  {
    using Halfedge = typename Attributes::Halfedge;
    auto texture = mesh.template add_property_map<Halfedge, typename Attributes::Kernel::Point_2>("h:texture").first;
    PMP::optimize_vertex_attributes<ConcurrencyTag>(mesh, reference, from.texture, texture,
                                                    CGAL::parameters::edge_is_constrained_map(is_seam));
  }
}

// Writes an OBJ file with texture coordinates, once for a vertex where they are the same.
template <typename Point, typename TextureMap>
void write_textured_OBJ(const std::string& name, const CGAL::Surface_mesh<Point>& mesh, const TextureMap& texture)
{
  write_file(name, [&](const std::string& partial) {
    std::ofstream out(partial);
    out.precision(17);
    std::map<std::size_t, std::size_t> number_of_vertex; // without gaps, from 1 on
    for(auto v : mesh.vertices())
    {
      number_of_vertex.emplace(static_cast<std::size_t>(v), number_of_vertex.size() + 1);
      out << "v " << mesh.point(v) << "\n";
    }
    using Corner = std::pair<std::size_t, std::pair<double, double>>;
    std::map<Corner, std::size_t> numbers;
    const auto corner = [&](auto h) {
      return Corner(static_cast<std::size_t>(mesh.target(h)), { texture[h].x(), texture[h].y() });
    };
    for(auto f : mesh.faces())
      for(auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
        if(numbers.emplace(corner(h), numbers.size() + 1).second)
          out << "vt " << texture[h] << "\n";
    for(auto f : mesh.faces())
    {
      out << "f";
      for(auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
        out << " " << number_of_vertex[static_cast<std::size_t>(mesh.target(h))] << "/" << numbers[corner(h)];
      out << "\n";
    }
    return bool(out.flush());
  });
}

// Writes a mesh with the attributes that its format, given by the extension of the name, supports.
template <typename Point>
void write_mesh_with_attributes(const std::string& name, const CGAL::Surface_mesh<Point>& mesh)
{
  const std::string extension = std::filesystem::path(name).extension().string();
  const Mesh_attributes<Point> attributes(mesh);
  if(extension == ".obj" && attributes.has_texture)
    write_textured_OBJ(name, mesh, attributes.texture);
  else if((extension == ".ply" || extension == ".off") && (attributes.has_colors || attributes.has_normals))
    write_file(name, [&](const std::string& partial) {
      std::ofstream out(partial, std::ios::binary);
      out.precision(17);
      if(extension == ".off")
        return CGAL::IO::write_OFF(out, mesh, CGAL::parameters::stream_precision(17)) && out.flush();
      CGAL::IO::set_binary_mode(out);
      return CGAL::IO::write_PLY(out, mesh) && out.flush();
    });
  else
    write_mesh(name, mesh);
}

#endif // VERTEX_LOCATION_OPTIMIZATION_EXAMPLES_MESH_ATTRIBUTES_H
