// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What fitted attributes gain over those at the closest points of the vertices, on remeshes whose locations have been
// optimized:
//
//   attributes
//
// For a model of size 1 the number is f = sin(6x) cos(5y) + sin(7z), and the channels of the color are the shorter waves
// sin(20x), sin(20y) cos(9z) and cos(25z), from 0 to 255. Errors are the mean absolute ones over the remesh, seconds those
// of one thread. The texture coordinates are those of a torus that is cut open along two seams.

#include "../Quality/models.h"
#include "../Quality/remeshers.h"

#include <CGAL/Polygon_mesh_processing/attribute_error.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_attributes.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Timer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <utility>
#include <vector>

using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;
using Color = CGAL::IO::Color;
using Surface = PMP::PN_triangle_surface<Mesh>;
template <typename T>
using Vertex_map = Mesh::Property_map<Vertex, T>;

unsigned char channel(double x) { return static_cast<unsigned char>(std::lround(x)); }

// the coordinates of the reference's vertices around a foot
struct Weighted_vertices
{
  std::array<Vertex, 3> vertices;
  std::array<double, 3> weights;
};

Weighted_vertices find_vertices(const Mesh& input, const Surface& surface, const Point& p)
{
  const auto [face, weights] = surface.location(surface.project(p));
  const Halfedge h = input.halfedge(face);
  return { { input.source(h), input.target(h), input.target(input.next(h)) }, weights };
}

double sample(const Weighted_vertices& w, const Vertex_map<double>& map)
{
  return w.weights[0] * map[w.vertices[0]] + w.weights[1] * map[w.vertices[1]] + w.weights[2] * map[w.vertices[2]];
}

Color sample(const Weighted_vertices& w, const Vertex_map<Color>& map)
{
  std::array<double, 3> sum{};
  for(int i = 0; i < 3; ++i)
  {
    const Color& c = map[w.vertices[i]];
    sum[0] += w.weights[i] * c.red();
    sum[1] += w.weights[i] * c.green();
    sum[2] += w.weights[i] * c.blue();
  }
  return Color(channel(sum[0]), channel(sum[1]), channel(sum[2]));
}

// prints the error of the samples at the vertices and of the fit, and returns the seconds of the fit
template <typename T>
double print_errors(const Mesh& input, const Surface& surface, const Vertex_map<T>& map, Mesh& mesh)
{
  const Vertex_map<T> values = mesh.add_property_map<Vertex, T>().first;
  for(Vertex v : mesh.vertices())
    values[v] = sample(find_vertices(input, surface, mesh.point(v)), map);
  const double sampled = PMP::attribute_error(mesh, surface, map, values).mean;
  CGAL::Timer timer;
  timer.start();
  PMP::optimize_vertex_attributes(mesh, surface, map, values);
  timer.stop();
  const double fitted = PMP::attribute_error(mesh, surface, map, values).mean;
  std::printf(" %.3g | %.3g (-%.1f%%) |", sampled, fitted, 100 * (1 - fitted / sampled));
  return timer.time();
}

void print_model(Model model)
{
  Mesh& input = model.input;
  const double size = longest_side(input);
  const auto number = input.add_property_map<Vertex, double>("v:number").first;
  const auto color = input.add_property_map<Vertex, Color>("v:color").first;
  for(Vertex v : input.vertices())
  {
    const Point& p = input.point(v);
    const double x = p.x() / size, y = p.y() / size, z = p.z() / size;
    number[v] = std::sin(6 * x) * std::cos(5 * y) + std::sin(7 * z);
    color[v] = Color(channel(127.5 * (1 + std::sin(20 * x))), channel(127.5 * (1 + std::sin(20 * y) * std::cos(9 * z))),
                     channel(127.5 * (1 + std::cos(25 * z))));
  }
  Mesh mesh = remesh_isotropically(model);
  const Surface surface(input);
  CGAL::Timer timer;
  timer.start();
  PMP::optimize_vertex_locations(mesh, surface);
  timer.stop();
  std::printf("| %s %g | %u |", model.name.c_str(), model.edge_length, mesh.number_of_vertices());
  const double seconds = print_errors(input, surface, number, mesh);
  const double seconds_of_color = print_errors(input, surface, color, mesh);
  std::printf(" %.2f | %.2f | %.2f |\n", timer.time(), seconds, seconds_of_color);
  std::fflush(stdout);
}

// a torus around the z-axis
Mesh make_torus(std::size_t columns, std::size_t rows)
{
  Mesh mesh;
  std::vector<Vertex> v;
  for(std::size_t j = 0; j < rows; ++j)
    for(std::size_t i = 0; i < columns; ++i)
    {
      const double a = 2 * CGAL_PI * i / columns, b = 2 * CGAL_PI * j / rows, r = 3 + std::cos(b);
      v.push_back(mesh.add_vertex(Point(r * std::cos(a), r * std::sin(a), std::sin(b))));
    }
  for(std::size_t j = 0; j < rows; ++j)
    for(std::size_t i = 0; i < columns; ++i)
    {
      const std::size_t k = (i + 1) % columns, l = (j + 1) % rows;
      mesh.add_face(v[j * columns + i], v[j * columns + k], v[l * columns + k]);
      mesh.add_face(v[j * columns + i], v[l * columns + k], v[l * columns + i]);
    }
  return mesh;
}

// the angles around both axes, in turns
std::array<double, 2> angles(const Point& p)
{
  const auto turns = [](double y, double x) { return std::fmod(std::atan2(y, x) / (2 * CGAL_PI) + 1, 1.); };
  return { turns(p.y(), p.x()), turns(p.z(), std::hypot(p.x(), p.y()) - 3) };
}

void print_torus(bool has_constrained_seams)
{
  using Point_2 = Kernel::Point_2;
  Mesh input = make_torus(180, 60);
  const auto texture = input.add_property_map<Halfedge, Point_2>("h:texture").first;
  for(Mesh::Face_index f : input.faces())
  {
    const Halfedge h = input.halfedge(f);
    const auto center = angles(
      CGAL::centroid(input.point(input.source(h)), input.point(input.target(h)), input.point(input.target(input.next(h)))));
    for(Halfedge g : CGAL::halfedges_around_face(h, input))
    {
      const auto a = angles(input.point(input.target(g)));
      texture[g] = Point_2(a[0] + std::round(center[0] - a[0]), a[1] + std::round(center[1] - a[1]));
    }
  }
  Mesh mesh = input;
  const auto is_seam = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_seam", false).first;
  if(has_constrained_seams)
    for(Mesh::Edge_index e : mesh.edges())
    {
      const Halfedge h = input.halfedge(e), o = input.opposite(h);
      is_seam[e] = CGAL::squared_distance(texture[h], texture[input.prev(o)]) > 0.25;
    }
  PMP::isotropic_remeshing(
    faces(mesh), 0.25, mesh,
    CGAL::parameters::number_of_iterations(10).number_of_relaxation_steps(3).edge_is_constrained_map(is_seam));
  mesh.collect_garbage();
  const Surface surface(input);
  PMP::optimize_vertex_locations(mesh, surface, CGAL::parameters::edge_is_constrained_map(is_seam));
  const auto result = mesh.add_property_map<Halfedge, Point_2>("h:result").first;
  PMP::optimize_vertex_attributes(mesh, surface, texture, result, CGAL::parameters::edge_is_constrained_map(is_seam));

  // A mixture is no angle of the point in any number of turns, by more than the length of an edge.
  std::size_t mixtures = 0, torn = 0;
  double largest = 0;
  for(Halfedge h : mesh.halfedges())
    for(int k = 0; k < 2; ++k)
    {
      const double difference = result[h][k] - angles(mesh.point(mesh.target(h)))[k];
      largest = (std::max)(largest, std::abs(difference - std::round(difference)));
      mixtures += std::abs(difference - std::round(difference)) > 0.05;
      torn += std::abs(result[h][k] - result[mesh.next(h)][k]) > 0.25;
    }
  std::printf("| %s | %u | %zu | %zu | %.4f | %.5f |\n", has_constrained_seams ? "kept as edges" : "not known",
              mesh.number_of_vertices(), mixtures, torn, largest, PMP::attribute_error(mesh, surface, texture, result).mean);
}

int main()
{
  std::printf("| model | vertices | number: sampled | fitted | color: sampled | fitted "
              "| seconds: locations | number | color |\n"
              "|---|---|---|---|---|---|---|---|---|\n");
  print_model({ "sphere", make_sphere(6), 0.062 });
  for(const auto& [name, length] : { std::pair("bunny00", 0.02), std::pair("knot1", 0.04), std::pair("armadillo", 0.012),
                                     std::pair("refined_elephant", 0.025) })
    if(Mesh mesh = read_model(data_file(name)); !mesh.is_empty())
      print_model({ name, mesh, length });

  std::printf("\n| seams | vertices | mixtures | faces across a seam | largest error | mean error |\n"
              "|---|---|---|---|---|---|\n");
  print_torus(true);
  print_torus(false);
}
