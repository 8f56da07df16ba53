// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes and references of different types and kernels give the same results.

#include "check.h"
#include "test_meshes.h"

#ifdef CGAL_USE_OPENMESH
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/properties_PolyMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/properties_TriMesh_ArrayKernelT.h>
#endif

#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>

namespace PMP = CGAL::Polygon_mesh_processing;
using Surface_mesh_of_floats = CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>;
using Surface_mesh_of_doubles = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Surface_mesh_of_exact_numbers = CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

#ifdef CGAL_USE_OPENMESH
struct Double_traits : OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
#endif

// a torus with triangles that are nearly equilateral, turned in itself
Soup torus(std::size_t columns, std::size_t rows, double turn)
{
  Soup soup = triangle_grid(columns, rows, true);
  soup.points.resize(columns * rows); // the last row is the first
  for(auto& triangle : soup.triangles)
    for(std::size_t& i : triangle)
      i %= columns * rows;
  return transformed(soup, [&](const Point& p) {
    const double a = 2 * CGAL_PI * p.x() / columns + turn, b = 2 * CGAL_PI * p.y() / rows + 2 * turn, r = 5 + std::cos(b);
    return Point(r * std::cos(a), r * std::sin(a), std::sin(b));
  });
}

const Soup remesh = torus(80, 16, 0.1);
const Soup input = torus(120, 30, 0);

template <typename TriangleMesh, typename Reference>
std::vector<Point> optimized(TriangleMesh mesh, const Reference& reference)
{
  const auto report = PMP::optimize_vertex_locations<CGAL::Parallel_if_available_tag>(mesh, reference);
  CHECK_LESS(0u, report.iterations);
  return points_of(mesh);
}

template <typename TriangleMesh, typename Reference>
void check_types(const std::string& name, const std::vector<Point>& expected, double tolerance)
{
  start_topic(name);
  const TriangleMesh mesh = make_mesh<TriangleMesh>(remesh);
  const Reference reference = make_mesh<Reference>(input);
  CHECK_EQUAL(num_vertices(mesh), expected.size());
  CHECK_AT_MOST(largest_distance(optimized(mesh, reference), expected), tolerance);
}

void test_types(const std::vector<Point>& expected)
{
  CHECK_AT_LEAST(largest_distance(expected, remesh.points), 0.01);

  check_types<Polyhedron, Polyhedron>("Polyhedron_3", expected, 1e-10);
  check_types<Polyhedron, Mesh>("Polyhedron_3 and Surface_mesh", expected, 1e-10);
  check_types<Mesh, Polyhedron>("Surface_mesh and Polyhedron_3", expected, 1e-10);
#ifdef CGAL_USE_OPENMESH
  // CGAL writes floats to the points of OpenMesh, whatever their type
  using Tri_mesh = OpenMesh::TriMesh_ArrayKernelT<Double_traits>;
  using Poly_mesh = OpenMesh::PolyMesh_ArrayKernelT<Double_traits>;
  using Float_mesh = OpenMesh::TriMesh_ArrayKernelT<>;
  check_types<Tri_mesh, Mesh>("OpenMesh's triangle mesh and Surface_mesh", expected, 1e-6);
  check_types<Mesh, Poly_mesh>("Surface_mesh and OpenMesh's polygon mesh", expected, 1e-6);
  check_types<Float_mesh, Tri_mesh>("OpenMesh's triangle mesh of floats", expected, 1e-5);
#endif
  check_types<Surface_mesh_of_doubles, Surface_mesh_of_doubles>("Simple_cartesian<double>", expected, 1e-10);
  check_types<Surface_mesh_of_floats, Surface_mesh_of_floats>("Simple_cartesian<float>", expected, 1e-5);
  check_types<Surface_mesh_of_exact_numbers, Mesh>("Exact constructions and inexact ones", expected, 1e-10);
  check_types<Surface_mesh_of_floats, Surface_mesh_of_exact_numbers>("Floats and exact constructions", expected, 1e-5);
}

void test_reference_surfaces(const std::vector<Point>& expected)
{
  start_topic("A reference surface with a kernel of its own");
  const PMP::PN_triangle_surface<Polyhedron, CGAL::Simple_cartesian<float>> of_floats(make_mesh<Polyhedron>(input));
  CHECK_AT_MOST(largest_distance(optimized(make_mesh(remesh), of_floats), expected), 1e-4);
  const PMP::Flat_triangle_surface<Polyhedron> flat(make_mesh<Polyhedron>(input));
  CHECK_AT_MOST(largest_distance(optimized(make_mesh(remesh), flat),
                                 optimized(make_mesh(remesh), PMP::Flat_triangle_surface<Mesh>(make_mesh(input)))),
                1e-10);
}

void test_exact_points()
{
  start_topic("Exact points that do not move stay exact");
  Surface_mesh_of_exact_numbers exact = make_mesh<Surface_mesh_of_exact_numbers>(remesh);
  const Surface_mesh_of_exact_numbers::Vertex_index v(0);
  using Exact_point = CGAL::Exact_predicates_exact_constructions_kernel::Point_3;
  const auto to_be_evaluated = [](auto x) // nearly x, with a wide interval until then
  {
    x += x / 3000000;
    for(int i = 0; i < 20; ++i)
      x = x / 3 * 7 / 11 * 33 / 7;
    return x;
  };
  exact.point(v) = Exact_point(to_be_evaluated(exact.point(v).x()), to_be_evaluated(exact.point(v).y()),
                               to_be_evaluated(exact.point(v).z()));
  const Exact_point before = exact.point(v);
  auto is_constrained = exact.add_property_map<Surface_mesh_of_exact_numbers::Vertex_index, bool>("c", false).first;
  is_constrained[v] = true;
  int asked = 0;
  const auto evaluate = [&](Surface_mesh_of_exact_numbers::Vertex_index w, const Exact_point&, const Exact_point&) {
    CGAL::exact(exact.point(v));
    asked += w == v;
    return true;
  };
  PMP::optimize_vertex_locations(exact, make_mesh(input),
                                 CGAL::parameters::vertex_is_constrained_map(is_constrained).allow_move_functor(evaluate));
  CHECK(exact.point(v) == before);
  CHECK_EQUAL(asked, 0);
}

int main()
{
  const std::vector<Point> expected = optimized(make_mesh(remesh), make_mesh(input));
  test_types(expected);
  test_reference_surfaces(expected);
  test_exact_points();
  return test_result();
}
