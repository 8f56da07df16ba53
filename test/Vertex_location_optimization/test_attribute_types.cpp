// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Attributes of all types, of meshes of other types.

#include "add_attributes.h"
#include "check.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/attribute_error.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_attributes.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <map>
#include <string>

// A signal that is linear over the surface is reproduced, in each of the types of values, with keys of each kind.
template <typename T, typename MakeValue, typename IsNear>
void check_type(const std::string& name, const MakeValue& make_value, const IsNear& is_near)
{
  start_topic("a linear signal of the type " + name);
  Mesh mesh = make_mesh(planar_patch(5)), reference = make_mesh(triangle_grid(9, 9));
  for(Point& p : reference.points()) // a larger plane, with other triangles
    p = Point(p.x() - 2, p.y() - 2, 0);
  const auto reference_map = add_map_of(reference, make_value);
  const auto reference_corner_map = add_corner_map<T>(reference);
  for(Halfedge h : reference.halfedges())
    reference_corner_map[h] = reference_map[reference.target(h)];
  const auto map = add_vertex_map<T>(mesh);
  const auto corner_map = add_corner_map<T>(mesh);

  const auto check_values = [&](const auto& from) {
    PMP::optimize_vertex_attributes(mesh, reference, from, map);
    PMP::optimize_vertex_attributes(mesh, reference, from, corner_map);
    for(Halfedge h : mesh.halfedges())
    {
      if(mesh.is_border(h))
        continue;
      CHECK(is_near(map[mesh.target(h)], make_value(mesh.point(mesh.target(h)))));
      CHECK(is_near(corner_map[h], make_value(mesh.point(mesh.target(h)))));
    }
    CHECK_AT_MOST(PMP::attribute_error(mesh, reference, from, map).max, 1.);
  };
  check_values(reference_map);
  check_values(reference_corner_map);
}

void test_types()
{
  const auto number = [](const Point& p) { return 3 + 2 * p.x() - p.y(); };
  const auto is_near = [](auto a, auto b) { return std::abs(a - b) < 1e-11; };
  const auto is_vector_near = [](const auto& a, const auto& b) { return std::sqrt((a - b).squared_length()) < 1e-11; };
  check_type<double>("double", number, is_near);
  check_type<float>(
    "float", [&](const Point& p) { return float(number(p)); }, [](float a, float b) { return std::abs(a - b) < 1e-5; });
  check_type<int>(
    "int", [&](const Point& p) { return int(std::lround(1000 * number(p))); },
    [](int a, int b) { return std::abs(a - b) <= 1; });
  check_type<Point_2>(
    "Point_2", [&](const Point& p) { return Point_2(p.y(), number(p)); }, is_vector_near);
  check_type<Point>(
    "Point_3", [&](const Point& p) { return Point(p.y(), number(p), 7); }, is_vector_near);
  check_type<Kernel::Vector_2>(
    "Vector_2", [&](const Point& p) { return Kernel::Vector_2(p.y(), number(p)); }, is_vector_near);
  check_type<Vector>(
    "Vector_3", [&](const Point& p) { return Vector(p.y(), number(p), -1); }, is_vector_near);
  using Color = CGAL::IO::Color;
  const auto channel = [](double x) { return static_cast<unsigned char>(std::lround(x)); };
  check_type<Color>(
    "Color",
    [&](const Point& p) {
      return Color(channel(50 + 10 * p.x()), channel(200 - 10 * p.y()), 17, channel(100 + 10 * p.y()));
    },
    [](const Color& a, const Color& b) {
      return std::abs(a.red() - b.red()) <= 1 && std::abs(a.green() - b.green()) <= 1 && a.blue() == b.blue() &&
             std::abs(a.alpha() - b.alpha()) <= 1;
    });
  using Array = std::array<double, 5>;
  check_type<Array>(
    "array",
    [&](const Point& p) {
      return Array{ 1, p.x(), p.y(), number(p), -number(p) };
    },
    [&](const Array& a, const Array& b) {
      bool all_near = true;
      for(int i = 0; i < 5; ++i)
        all_near = all_near && is_near(a[i], b[i]);
      return all_near;
    });
}

void test_polyhedron()
{
  start_topic("a Polyhedron_3");
  const auto squashed = [](const Point& p) { return rigid_motion(Point(p.x(), p.y(), 0.6 * p.z())); };
  Mesh mesh = make_mesh(transformed(icosphere(2), squashed)), reference = make_mesh(transformed(icosphere(4), squashed));
  using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;
  const Polyhedron polyhedron = make_mesh<Polyhedron>(transformed(icosphere(2), squashed)),
                   polyhedral_reference = make_mesh<Polyhedron>(transformed(icosphere(4), squashed));
  std::map<boost::graph_traits<Polyhedron>::vertex_descriptor, double> from, to;
  for(auto v : vertices(polyhedral_reference))
    from[v] = wave(Point(v->point().x(), v->point().y(), v->point().z()));
  const auto smooth = add_map_of(reference, wave);
  const auto values = add_vertex_map<double>(mesh);
  PMP::optimize_vertex_attributes(mesh, reference, smooth, values);
  PMP::optimize_vertex_attributes(polyhedron, polyhedral_reference, boost::make_assoc_property_map(from),
                                  boost::make_assoc_property_map(to));
  CHECK_EQUAL(to.size(), mesh.number_of_vertices());
  auto v = mesh.vertices().begin();
  for(auto w : vertices(polyhedron))
  {
    CHECK_NEAR(to[w], values[*v], 1e-9);
    ++v;
  }
}

int main()
{
  test_types();
  test_polyhedron();
  return test_result();
}
