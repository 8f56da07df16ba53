// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_EXAMPLES_MESH_OUTPUT_H
#define VERTEX_LOCATION_OPTIMIZATION_EXAMPLES_MESH_OUTPUT_H

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/IO/Color.h>
#include <CGAL/IO/io.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

// Writes a file with `write(name)`, which returns whether it succeeded. The file is first written under another name and
// renamed when complete.
template <typename Write>
void write_file(const std::filesystem::path& path, const Write& write)
{
  const std::filesystem::path partial = path.parent_path() / (path.stem().string() + ".partial" + path.extension().string());
  try
  {
    if(!std::ofstream(partial) || !write(partial.string()))
      throw std::runtime_error("it cannot be written");
    std::filesystem::rename(partial, path);
  }
  catch(const std::exception& e)
  {
    std::error_code ignored;
    std::filesystem::remove(partial, ignored);
    throw std::runtime_error(path.string() + ": " + e.what());
  }
}

// The color of a value between 0 and 1, from violet to yellow: viridis, which is readable with color blindness.
inline CGAL::IO::Color color_of(double value)
{
  using Rgb = std::array<double, 3>;
  constexpr std::array<Rgb, 9> scale{ Rgb{ 68, 1, 84 }, { 71, 44, 122 },  { 59, 81, 139 },
                                      { 44, 113, 142 }, { 33, 144, 141 }, { 39, 173, 129 },
                                      { 92, 200, 99 },  { 170, 220, 50 }, { 253, 231, 37 } };
  const double x = (scale.size() - 1) * (std::min)(1., (std::max)(0., value));
  const std::size_t i = (std::min)(scale.size() - 2, static_cast<std::size_t>(x));
  auto channel = [&](int k) { return static_cast<unsigned char>(scale[i][k] + (x - i) * (scale[i + 1][k] - scale[i][k])); };
  return CGAL::IO::Color(channel(0), channel(1), channel(2));
}

// in the format that the extension of the name says: .off, .obj, .ply, or .stl
template <typename Point>
void write_mesh(const std::string& name, const CGAL::Surface_mesh<Point>& mesh)
{
  const std::string extension = std::filesystem::path(name).extension().string();
  write_file(name, [&](const std::string& partial) {
    // not by the name: a disk that is full at the end of the file would not be noticed
    std::ofstream out(partial, std::ios::binary);
    const auto np = CGAL::parameters::stream_precision(17);
    if(extension == ".obj")
      return CGAL::IO::write_OBJ(out, mesh, np) && out.flush();
    if(extension == ".off")
      return CGAL::IO::write_OFF(out, mesh, np) && out.flush();
    CGAL::IO::set_binary_mode(out);
    return (extension == ".stl" ? CGAL::IO::write_STL(out, mesh) : CGAL::IO::write_PLY(out, mesh)) && out.flush();
  });
}

// as PLY with the colors of the values over `largest`, beside the values themselves
template <typename Point, typename ValueMap>
void write_colored_PLY(const std::string& name, CGAL::Surface_mesh<Point> mesh, const ValueMap& values, double largest)
{
  using Vertex = typename CGAL::Surface_mesh<Point>::Vertex_index;
  auto colors = mesh.template add_property_map<Vertex, CGAL::IO::Color>("v:color").first;
  for(Vertex v : mesh.vertices())
    colors[v] = color_of(largest > 0 ? get(values, v) / largest : 0);
  write_file(name, [&](const std::string& partial) {
    std::ofstream out(partial, std::ios::binary);
    CGAL::IO::set_binary_mode(out);
    return out && CGAL::IO::write_PLY(out, mesh) && out.flush();
  });
}

// as VTK polygons with a scalar, for a scientific viewer; the vertices are numbered without gaps
template <typename Point, typename ValueMap>
void write_VTP(const std::string& name,
               const CGAL::Surface_mesh<Point>& mesh,
               const std::string& scalar_name,
               const ValueMap& values)
{
  write_file(name, [&](const std::string& partial) {
    std::ofstream out(partial);
    out.precision(17);
    out << "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n<PolyData>\n"
        << "<Piece NumberOfPoints=\"" << mesh.number_of_vertices() << "\" NumberOfPolys=\"" << mesh.number_of_faces()
        << "\">\n<PointData Scalars=\"" << scalar_name << "\">\n"
        << "<DataArray type=\"Float64\" Name=\"" << scalar_name << "\" format=\"ascii\">\n";
    for(auto v : mesh.vertices())
      out << get(values, v) << "\n";
    out << "</DataArray>\n</PointData>\n<Points>\n"
        << "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n";
    for(auto v : mesh.vertices())
      out << mesh.point(v) << "\n";
    out << "</DataArray>\n</Points>\n<Polys>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
    for(auto f : mesh.faces())
    {
      for(auto v : vertices_around_face(mesh.halfedge(f), mesh))
        out << static_cast<std::size_t>(v) << " ";
      out << "\n";
    }
    out << "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
    std::size_t offset = 0;
    for(auto f : mesh.faces())
      out << (offset += mesh.degree(f)) << "\n";
    out << "</DataArray>\n</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
    return bool(out.flush());
  });
}

#endif // VERTEX_LOCATION_OPTIMIZATION_EXAMPLES_MESH_OUTPUT_H
