// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Normals that are known, and what normals must be on any input.

#include "check.h"
#include "read_model.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/approximation_error.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_normals.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polyhedron_3.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <functional>

namespace PMP = CGAL::Polygon_mesh_processing;
using Vertex_normals = Mesh::Property_map<Mesh::Vertex_index, Vector>;
using Corner_normals = Mesh::Property_map<Mesh::Halfedge_index, Vector>;

Vertex_normals add_vertex_normals(Mesh& mesh)
{
  return mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal", Vector(9, 9, 9)).first;
}

Corner_normals add_corner_normals(Mesh& mesh)
{
  return mesh.add_property_map<Mesh::Halfedge_index, Vector>("h:normal", Vector(9, 9, 9)).first;
}

bool is_unit(const Vector& n) { return std::abs(n.squared_length() - 1) < 1e-12; }

// the plane z = 0 with any field of normals over it
struct Plane_with_normals
{
  using Point_3 = Point;
  using Vector_3 = Vector;
  struct Foot
  {
    double x, y;
  };

  Foot project(const Point& p) const { return { p.x(), p.y() }; }
  Foot project(const Point& p, const Foot&) const { return project(p); }
  Point point(const Foot& foot) const { return Point(foot.x, foot.y, 0); }
  Vector normal(const Foot& foot) const { return field(foot.x, foot.y); }

  std::function<Vector(double, double)> field;
};

void test_plane()
{
  start_topic("a plane");
  for(const double scale : { 1., 1e-6, 1e6 })
  {
    Mesh mesh =
      make_mesh(transformed(planar_patch(6), [&](const Point& p) { return Point(scale * p.x(), scale * p.y(), 0); }));
    auto normals = add_vertex_normals(mesh);
    PMP::optimize_vertex_normals(mesh, mesh, normals);
    for(Mesh::Vertex_index v : mesh.vertices())
      CHECK_NEAR((normals[v] - Vector(0, 0, 1)).squared_length(), 0., 1e-24);
  }
}

void test_quadratic_normals()
{
  start_topic("normals that are quadratic");
  // The best piecewise linear fit to a x^2 on equilateral triangles of edge length h is a (x^2 - h^2 / 8) at a vertex.
  const double h = 0.1, a = 1e-4;
  const int n = 26;
  Mesh mesh = make_mesh(
    transformed(triangle_grid(n, n), [&](const Point& p) { return Point(h * p.x(), h * std::sqrt(0.75) * p.y(), 0); }));
  const Plane_with_normals reference{ [&](double x, double) -> Vector {
    const Vector n(a * x * x, 0, 1);
    return n / std::sqrt(n.squared_length());
  } };
  auto normals = add_vertex_normals(mesh);
  PMP::optimize_vertex_normals(mesh, reference, normals);
  int number_of_checks = 0;
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    // what the border makes different falls to a third with each row at least
    const double x = mesh.point(v).x(), row = mesh.point(v).y() / (h * std::sqrt(0.75)), rows_to_border = 11.9;
    if(std::abs(x / h - n / 2.) > n / 2. - rows_to_border || std::abs(row - n / 2.) > n / 2. - rows_to_border)
      continue;
    ++number_of_checks;
    CHECK_NEAR(normals[v].x() / normals[v].z(), a * (x * x - h * h / 8), 1e-6 * a * h * h);
    CHECK_NEAR(normals[v].y(), 0., 1e-15);
  }
  CHECK_LESS(0, number_of_checks);
}

void test_creases()
{
  start_topic("the creases of a cube");
  Mesh mesh = make_mesh(cube(2));
  auto is_crease = mesh.add_property_map<Mesh::Edge_index, bool>("e:crease", false).first;
  auto face_normal = [&](Mesh::Face_index f) { return PMP::compute_face_normal(f, mesh); };
  for(Mesh::Edge_index e : mesh.edges())
    is_crease[e] = face_normal(mesh.face(mesh.halfedge(e))) * face_normal(mesh.face(mesh.halfedge(e, 1))) < 0.5;
  const auto with_creases = CGAL::parameters::edge_is_constrained_map(is_crease);

  auto vertex_normals = add_vertex_normals(mesh);
  auto corner_normals = add_corner_normals(mesh);
  auto check_creases = [&](const auto& reference) {
    PMP::optimize_vertex_normals(mesh, reference, corner_normals, with_creases);
    PMP::optimize_vertex_normals(mesh, reference, vertex_normals, with_creases);
    for(Mesh::Halfedge_index halfedge : mesh.halfedges())
      CHECK_NEAR((corner_normals[halfedge] - face_normal(mesh.face(halfedge))).squared_length(), 0., 1e-20);
    for(Mesh::Vertex_index v : mesh.vertices())
    {
      bool is_of_a_face = false;
      for(Mesh::Halfedge_index halfedge : halfedges_around_target(v, mesh))
        is_of_a_face = is_of_a_face || vertex_normals[v] == corner_normals[halfedge];
      CHECK(is_of_a_face);
    }
    CHECK_NEAR(PMP::normal_deviation(mesh, reference, corner_normals), 0., 1e-6);
  };
  check_creases(mesh);
  check_creases(PMP::Flat_triangle_surface<Mesh>(mesh));

  // without creases the corners around a vertex have one normal
  PMP::optimize_vertex_normals(mesh, mesh, corner_normals);
  PMP::optimize_vertex_normals(mesh, mesh, vertex_normals);
  for(Mesh::Halfedge_index halfedge : mesh.halfedges())
    CHECK(corner_normals[halfedge] == vertex_normals[mesh.target(halfedge)]);
}

void test_rim()
{
  start_topic("a rim whose chords leave the surface");
  // A coarse drum against a fine one: the midpoints of the edges along the rim are inside the top.
  auto drum = [](std::size_t columns) {
    Soup soup = cylinder(columns, 2, 0);
    const double height = soup.points.back().z();
    soup.points.emplace_back(0, 0, height);
    for(std::size_t i = 0; i < columns; ++i)
      soup.triangles.push_back({ 2 * columns + i, 2 * columns + (i + 1) % columns, soup.points.size() - 1 });
    return transformed(soup, [&](const Point& p) { return Point(p.x(), p.y(), p.z() / height); });
  };
  Mesh mesh = make_mesh(drum(24));
  auto is_crease = mesh.add_property_map<Mesh::Edge_index, bool>("e:crease", false).first;
  for(Mesh::Edge_index e : mesh.edges())
    is_crease[e] = !mesh.is_border(e) && mesh.point(mesh.vertex(e, 0)).z() > 0.99 &&
                   mesh.point(mesh.vertex(e, 1)).z() > 0.99 && mesh.degree(mesh.vertex(e, 0)) < 10 &&
                   mesh.degree(mesh.vertex(e, 1)) < 10;
  auto normals = add_corner_normals(mesh);
  PMP::optimize_vertex_normals(mesh, make_mesh(drum(240)), normals, CGAL::parameters::edge_is_constrained_map(is_crease));
  for(Mesh::Halfedge_index halfedge : mesh.halfedges())
  {
    if(mesh.is_border(halfedge))
      continue;
    const Point& p = mesh.point(mesh.target(halfedge));
    const bool is_top = PMP::compute_face_normal(mesh.face(halfedge), mesh).z() > 0.5;
    const Vector n = is_top ? Vector(0, 0, 1) : Vector(p.x(), p.y(), 0);
    CHECK_AT_LEAST(normals[halfedge] * n, std::cos(2 * CGAL_PI / 180));
  }
}

void test_any_input()
{
  start_topic("unit normals on any input");
  // an isolated vertex, a face without an area with vertices of its own, and one that shares two
  Mesh mesh = make_mesh(planar_patch(3));
  mesh.add_vertex(Point(1, 1, 1));
  mesh.add_face(mesh.add_vertex(Point(0, 0, 2)), mesh.add_vertex(Point(1, 0, 2)), mesh.add_vertex(Point(2, 0, 2)));
  for(Mesh::Halfedge_index h : mesh.halfedges())
    if(mesh.is_border(h))
    {
      const auto v = mesh.add_vertex(CGAL::midpoint(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
      mesh.add_face(mesh.source(h), mesh.target(h), v);
      break;
    }

  Mesh needle;
  needle.add_face(needle.add_vertex(Point(0, 0, 0)), needle.add_vertex(Point(1, 0, 0)), needle.add_vertex(Point(2, 0, 0)));

  auto vertex_normals = add_vertex_normals(mesh);
  auto corner_normals = add_corner_normals(mesh);
  auto check_units = [&](const auto& reference) {
    PMP::optimize_vertex_normals(mesh, reference, vertex_normals);
    PMP::optimize_vertex_normals(mesh, reference, corner_normals);
    for(Mesh::Vertex_index v : mesh.vertices())
      CHECK(is_unit(vertex_normals[v]));
    for(Mesh::Halfedge_index h : mesh.halfedges())
      CHECK(mesh.is_border(h) || is_unit(corner_normals[h]));
  };
  check_units(mesh);
  check_units(needle); // no normal at all
  CHECK(vertex_normals[*mesh.vertices().begin()] == Vector(0, 0, 1));
  check_units(Plane_with_normals{ [](double x, double) { return Vector(0, 0, x < 1.5 ? 1 : -1); } }); // opposing
  check_units(Plane_with_normals{ [](double x, double y) { return Vector(std::cos(40 * x), std::sin(50 * y), 0); } });
  check_units(Plane_with_normals{ [](double x, double) { return x < 1.5 ? Vector(0, 0, 0) : Vector(1, 0, 0); } });
  check_units(Plane_with_normals{ [](double, double) { return Vector(0, 0, std::nan("")); } });
}

void test_bad_input()
{
  start_topic("faces that fold back on each other, and no faces");
  Mesh fold;
  const auto a = fold.add_vertex(Point(0, 0, 0)), b = fold.add_vertex(Point(1, 0, 0));
  fold.add_face(a, b, fold.add_vertex(Point(0.5, 1, 0)));
  fold.add_face(b, a, fold.add_vertex(Point(0.5, 1, 0)));
  auto fold_normals = add_vertex_normals(fold);
  PMP::optimize_vertex_normals(fold, fold, fold_normals);
  for(Mesh::Vertex_index v : fold.vertices())
    CHECK(is_unit(fold_normals[v]));

  Mesh empty;
  auto none = add_vertex_normals(empty);
  PMP::optimize_vertex_normals(empty, fold, none);

#ifdef CGAL_NO_ASSERTIONS
  // violated preconditions that are not checked leave the map as it is
  Mesh plane = make_mesh(planar_patch(2));
  auto untouched = add_vertex_normals(plane);
  PMP::optimize_vertex_normals(plane, empty, untouched);
  CHECK(untouched[*plane.vertices().begin()] == Vector(9, 9, 9));
#endif
}

void test_threads_and_types()
{
  start_topic("any number of threads, any mesh");
  auto squashed = [](const Point& p) { return rigid_motion(Point(p.x(), p.y(), 0.6 * p.z())); };
  Mesh mesh = make_mesh(transformed(icosphere(2), squashed));
  const Mesh reference = make_mesh(transformed(icosphere(4), squashed));
  auto normals = add_vertex_normals(mesh), other = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:other").first;
  PMP::optimize_vertex_normals(mesh, reference, normals);
  auto is_same = [&] {
    return std::all_of(vertices(mesh).begin(), vertices(mesh).end(),
                       [&](Mesh::Vertex_index v) { return normals[v] == other[v]; });
  };
#ifdef CGAL_LINKED_WITH_TBB
  for(const int threads : { 1, 2, 5 })
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    PMP::optimize_vertex_normals<CGAL::Parallel_tag>(mesh, reference, other);
    CHECK(is_same());
  }
#endif
  PMP::optimize_vertex_normals<CGAL::Parallel_if_available_tag>(mesh, reference, other);
  CHECK(is_same());

  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  const Polyhedron polyhedron = make_mesh<Polyhedron>(transformed(icosphere(2), squashed));
  std::map<boost::graph_traits<Polyhedron>::vertex_descriptor, Vector> map;
  PMP::optimize_vertex_normals(polyhedron, reference, boost::make_assoc_property_map(map));
  CHECK_EQUAL(map.size(), mesh.number_of_vertices());
  auto v = mesh.vertices().begin();
  for(auto w : vertices(polyhedron))
  {
    CHECK_NEAR((map[w] - normals[*v]).squared_length(), 0., 1e-20);
    ++v;
  }
}

// Section 3.4: better than the normals of the reference at the vertices, which are better than the mesh's own
void test_model()
{
  start_topic("a model of CGAL");
  const Mesh input = read_model("knot1");
  CGAL::Bbox_3 box;
  for(const Point& p : input.points())
    box += p.bbox();
  const PMP::PN_triangle_surface<Mesh> reference(input);

  Mesh mesh = input;
  PMP::isotropic_remeshing(faces(mesh), 0.04 * (std::max)({ box.x_span(), box.y_span(), box.z_span() }), mesh,
                           CGAL::parameters::number_of_iterations(5).number_of_relaxation_steps(3));
  mesh.collect_garbage();
  PMP::optimize_vertex_locations(mesh, reference);

  auto normals = add_vertex_normals(mesh);
  PMP::compute_vertex_normals(mesh, normals);
  const double own = PMP::normal_deviation(mesh, reference, normals);
  for(Mesh::Vertex_index v : mesh.vertices())
    normals[v] = reference.normal(reference.project(mesh.point(v)));
  const double sampled = PMP::normal_deviation(mesh, reference, normals);
  PMP::optimize_vertex_normals(mesh, reference, normals);
  const double optimized = PMP::normal_deviation(mesh, reference, normals);
  CHECK_LESS(own, PMP::normal_deviation(mesh, reference));
  CHECK_LESS(sampled, 0.95 * own);
  CHECK_LESS(optimized, 0.95 * sampled);
}

int main()
{
  test_plane();
  test_quadratic_normals();
  test_creases();
  test_rim();
  test_any_input();
  test_bad_input();
  test_threads_and_types();
  test_model();
  return test_result();
}
