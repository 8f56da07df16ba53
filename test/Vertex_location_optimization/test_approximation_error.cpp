// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Errors and angles that are known, from formulas or from an independent program.

#include "check.h"
#include "Distance_to_mesh.h"
#include "errors_of_models.h"
#include "remeshes.h"
#include "test_meshes.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/approximation_error.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

namespace PMP = CGAL::Polygon_mesh_processing;
using Flat_surface = PMP::Flat_triangle_surface<Mesh>;

bool operator==(const PMP::Approximation_error& a, const PMP::Approximation_error& b)
{
  return a.mean == b.mean && a.rms == b.rms && a.max == b.max;
}

void test_parallel_planes()
{
  start_topic("a plane parallel to a plane");
  for(const double scale : { 1., 1e-6, 1e6 })
  {
    auto large = [&](const Point& p) { return Point(scale * (3 * p.x() - 6), scale * (3 * p.y() - 6), 0); };
    auto lifted = [&](const Point& p) { return Point(scale * p.x(), scale * p.y(), scale * 0.25); };
    const Mesh reference = moved(planar_patch(8), large), mesh = moved(planar_patch(4), lifted);
    for(const PMP::Approximation_error& e :
        { PMP::approximation_error(mesh, reference), PMP::approximation_error(mesh, Flat_surface(reference)) })
    {
      CHECK_NEAR(e.mean, 0.25 * scale, 1e-12 * scale);
      CHECK_NEAR(e.rms, 0.25 * scale, 1e-12 * scale);
      CHECK_NEAR(e.max, 0.25 * scale, 1e-12 * scale);
    }
  }
}

void test_translation()
{
  start_topic("a known translation, both directions");
  // the unit square moved by its own width along itself: the distance is x over the part that sticks out
  const Soup square =
    transformed(triangle_grid(20, 20, false, 0), [](const Point& p) { return Point(p.x() / 20, p.y() / 20, 0); });
  const Mesh here = make_mesh(square);
  const Mesh there = moved(square, [](const Point& p) { return Point(p.x() + 1, p.y(), 0); });
  const Mesh half = moved(square, [](const Point& p) { return Point(p.x() / 2, p.y(), 0); });

  const PMP::Approximation_error e = PMP::approximation_error(there, here);
  CHECK_NEAR(e.mean, 1. / 2, 1e-12); // the sampling is exact for what is linear
  CHECK_NEAR(e.rms, std::sqrt(1. / 3), 1e-4);
  CHECK_NEAR(e.max, 1., 1e-12);

  const PMP::Approximation_error part = PMP::approximation_error(half, here);
  CHECK_NEAR(part.max, 0., 1e-12);
  const PMP::Approximation_error back = PMP::approximation_error(here, half);
  CHECK_NEAR(back.mean, 1. / 8, 1e-12);
  CHECK_NEAR(back.rms, std::sqrt(1. / 24), 1e-4);
  CHECK_NEAR(back.max, 1. / 2, 1e-12);
}

// The mean of |x|^2 over a triangle of the unit sphere is (3 + |a + b + c|^2) / 12, and 1 - |x| is (1 - |x|^2) / 2 but
// for a quarter of its square.
double mean_of_inscribed_mesh(const Mesh& mesh)
{
  double sum = 0, sum_of_areas = 0;
  for(Mesh::Face_index f : mesh.faces())
  {
    Vector corners = CGAL::NULL_VECTOR;
    for(Mesh::Vertex_index v : vertices_around_face(mesh.halfedge(f), mesh))
      corners = corners + (mesh.point(v) - CGAL::ORIGIN);
    sum += area(mesh, f) * (1 - (3 + corners.squared_length()) / 12) / 2;
    sum_of_areas += area(mesh, f);
  }
  return sum / sum_of_areas;
}

void test_inscribed_sphere()
{
  start_topic("a mesh inscribed in a sphere");
  for(const int level : { 3, 4 })
  {
    const Mesh mesh = make_mesh(icosphere(level));
    const double mean = mean_of_inscribed_mesh(mesh);
    const PMP::Approximation_error e = PMP::approximation_error(mesh, Exact_sphere());
    CHECK_NEAR(e.mean, mean, 0.01 * mean);
    CHECK_AT_LEAST(e.rms, e.mean);
    CHECK_AT_LEAST(e.max, e.rms);

    // the limit, which the default is close to
    const auto dense = CGAL::parameters::number_of_points_per_face(10000);
    CHECK_NEAR(PMP::approximation_error(mesh, Exact_sphere(), dense).mean, mean, 0.003 * mean);
  }
}

// The mean over a mesh of f(x, n), where n is the normal of the face. The sides of the faces are cut into `level` pieces.
template <typename F>
double mean_over_faces(const Mesh& mesh, const int level, const F& f)
{
  double sum = 0, sum_of_areas = 0;
  for(Mesh::Face_index face : mesh.faces())
  {
    std::vector<Point> t;
    for(Mesh::Vertex_index v : vertices_around_face(mesh.halfedge(face), mesh))
      t.push_back(mesh.point(v));
    const Vector normal = CGAL::unit_normal(t[0], t[1], t[2]);
    double sum_over_face = 0;
    for(int i = 0; i < level; ++i)
      for(int j = 0; j < level - i; ++j)
        for(const double offset : { 1 / 3., 2 / 3. })
          if(offset < 0.5 || i + j + 1 < level)
            sum_over_face += f(t[0] + ((i + offset) / level * (t[1] - t[0]) + (j + offset) / level * (t[2] - t[0])), normal);
    sum += area(mesh, face) * sum_over_face / (level * level);
    sum_of_areas += area(mesh, face);
  }
  return sum / sum_of_areas;
}

void test_crossing_surfaces()
{
  start_topic("meshes that cross a sphere everywhere, and the normals of their faces");
  const Mesh sphere = make_mesh(icosphere(5)); // its PN triangles differ from the sphere by 1e-6
  for(const double radius : { 1.0015, 1.0025, 1.0035 })
  {
    const Mesh mesh = moved(icosphere(3), [&](const Point& p) { return CGAL::ORIGIN + radius * (p - CGAL::ORIGIN); });
    const auto distance = [](const Point& x, const Vector&) {
      return std::abs(std::sqrt((x - CGAL::ORIGIN).squared_length()) - 1);
    };
    const auto angle = [](const Point& x, const Vector& normal) {
      return std::acos(normal * (x - CGAL::ORIGIN) / std::sqrt((x - CGAL::ORIGIN).squared_length())) * 180 / CGAL_PI;
    };
    const double mean = mean_over_faces(mesh, 60, distance), mean_angle = mean_over_faces(mesh, 60, angle);
    CHECK_NEAR(PMP::approximation_error(mesh, sphere).mean, mean, 0.002 * mean);
    CHECK_NEAR(PMP::normal_deviation(mesh, Exact_sphere()), mean_angle, 0.002 * mean_angle);
  }
}

void test_number_of_points()
{
  start_topic("the number of points per face");
  Mesh mesh;
  const auto a = mesh.add_vertex(Point(0, 0, 0)), b = mesh.add_vertex(Point(3, 0, 0)), c = mesh.add_vertex(Point(0, 3, 0));
  mesh.add_face(a, b, c);
  const Mesh corner = moved(planar_patch(1), [](const Point& p) { return Point(-p.x(), -p.y(), 0); });

  // the centroid of the face is at (1, 1); the vertices count for the maximum
  using CGAL::parameters::number_of_points_per_face;
  CHECK_NEAR(PMP::approximation_error(mesh, corner, number_of_points_per_face(1)).mean, std::sqrt(2.), 1e-12);
  CHECK_NEAR(PMP::approximation_error(mesh, corner, number_of_points_per_face(1)).max, 3., 1e-12);
  CHECK(PMP::approximation_error(mesh, corner, number_of_points_per_face(0)) ==
        PMP::approximation_error(mesh, corner, number_of_points_per_face(1)));
  CHECK(PMP::approximation_error(mesh, corner, number_of_points_per_face(17)) ==
        PMP::approximation_error(mesh, corner, number_of_points_per_face(25)));
  // the area is 4.5
  using CGAL::parameters::number_of_points_per_area_unit;
  CHECK(PMP::approximation_error(mesh, corner, number_of_points_per_area_unit(5)) ==
        PMP::approximation_error(mesh, corner, number_of_points_per_face(25)));
  CHECK(PMP::approximation_error(mesh, corner, number_of_points_per_area_unit(1).number_of_points_per_face(30)) ==
        PMP::approximation_error(mesh, corner, number_of_points_per_face(30)));
  CHECK(PMP::approximation_error(mesh, corner, number_of_points_per_area_unit(5).number_of_points_per_face(1)) ==
        PMP::approximation_error(mesh, corner, number_of_points_per_face(25)));
}

void test_error_maps()
{
  start_topic("the error maps");
  Mesh mesh = moved(icosphere(3), [](const Point& p) { return Point(p.x(), 1.1 * p.y(), p.z()); });
  const Mesh::Vertex_index isolated = mesh.add_vertex(Point(0, 0, 3));
  auto face_errors = mesh.add_property_map<Mesh::Face_index, double>("f:error", -1).first;
  auto vertex_errors = mesh.add_property_map<Mesh::Vertex_index, double>("v:error", -1).first;
  const PMP::Approximation_error e = PMP::approximation_error(
    mesh, Exact_sphere(),
    CGAL::parameters::face_error_map(face_errors).vertex_error_map(vertex_errors).vertex_point_map(mesh.points()));

  double sum_of_faces = 0, sum_of_vertices = 0, sum_of_areas = 0;
  for(Mesh::Face_index f : mesh.faces())
  {
    sum_of_areas += area(mesh, f);
    sum_of_faces += area(mesh, f) * face_errors[f];
    for(Mesh::Vertex_index v : vertices_around_face(mesh.halfedge(f), mesh))
      sum_of_vertices += area(mesh, f) / 3 * vertex_errors[v];
    CHECK_AT_MOST(face_errors[f], e.max);
    CHECK_AT_LEAST(face_errors[f], 0.);
  }
  CHECK_NEAR(sum_of_faces / sum_of_areas, e.mean, 1e-12);
  CHECK_NEAR(sum_of_vertices / sum_of_areas, e.mean, 1e-12);
  CHECK_NEAR(vertex_errors[isolated], 2., 1e-12);
  CHECK_LESS(e.max, 0.2); // the isolated vertex is no part of the surface
  CHECK(e == PMP::approximation_error(mesh, Exact_sphere()));
}

void test_threads()
{
  start_topic("any number of threads");
  const Mesh mesh = moved(icosphere(3), [](const Point& p) { return rigid_motion(Point(p.x(), 1.1 * p.y(), p.z())); });
  const Mesh reference = moved(icosphere(4), rigid_motion);
  const PMP::Approximation_error e = PMP::approximation_error(mesh, reference);
  const double angle = PMP::normal_deviation(mesh, reference);
  CHECK_LESS(0., e.mean);
#ifdef CGAL_LINKED_WITH_TBB
  for(const int threads : { 1, 2, 5 })
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    CHECK(e == PMP::approximation_error<CGAL::Parallel_tag>(mesh, reference));
    CHECK_EQUAL(angle, PMP::normal_deviation<CGAL::Parallel_tag>(mesh, reference));
  }
#endif
  CHECK(e == PMP::approximation_error<CGAL::Parallel_if_available_tag>(mesh, reference));
  CHECK_EQUAL(angle, PMP::normal_deviation<CGAL::Parallel_if_available_tag>(mesh, reference));
}

void test_normal_deviation()
{
  start_topic("normals at a known angle");
  const Mesh reference = moved(planar_patch(8), [](const Point& p) { return Point(3 * p.x() - 6, 3 * p.y() - 6, 0); });
  // a plane that is turned by 30 degrees about the y-axis
  const double turn = CGAL_PI / 6;
  Mesh mesh =
    moved(planar_patch(4), [&](const Point& p) { return Point(std::cos(turn) * p.x(), p.y(), -std::sin(turn) * p.x()); });
  CHECK_NEAR(PMP::normal_deviation(mesh, reference), 30., 1e-9);
  CHECK_NEAR(PMP::normal_deviation(mesh, reference, CGAL::parameters::number_of_points_per_face(4)), 30., 1e-9);

  // normals of the vertices, and of the corners: at 20 degrees, the other way and of any length
  auto vertex_normals = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  auto corner_normals = mesh.add_property_map<Mesh::Halfedge_index, Vector>("h:normal").first;
  const Vector n(-std::sin(CGAL_PI / 9), 0, std::cos(CGAL_PI / 9));
  for(Mesh::Vertex_index v : mesh.vertices())
    vertex_normals[v] = 7 * n;
  for(Mesh::Halfedge_index h : mesh.halfedges())
    corner_normals[h] = mesh.is_border(h) ? Vector(0, 0, 0) : n;
  CHECK_NEAR(PMP::normal_deviation(mesh, reference, vertex_normals), 20., 1e-9);
  CHECK_NEAR(PMP::normal_deviation(mesh, Flat_surface(reference), corner_normals), 20., 1e-9);

  // a face whose corners belong to different vertices in the two maps
  Mesh triangle;
  const std::array v{ triangle.add_vertex(Point(0, 0, 0)), triangle.add_vertex(Point(1, 0, 0)),
                      triangle.add_vertex(Point(0, 1, 0)) };
  const Mesh::Face_index f = triangle.add_face(v[0], v[1], v[2]);
  auto of_vertices = triangle.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  auto of_corners = triangle.add_property_map<Mesh::Halfedge_index, Vector>("h:normal").first;
  of_vertices[v[0]] = Vector(1, 0, 1);
  of_vertices[v[1]] = Vector(0, 1, 2);
  of_vertices[v[2]] = Vector(0, -1, 3);
  for(Mesh::Halfedge_index h : halfedges_around_face(triangle.halfedge(f), triangle))
    of_corners[h] = of_vertices[triangle.target(h)];
  CHECK_EQUAL(PMP::normal_deviation(triangle, reference, of_vertices),
              PMP::normal_deviation(triangle, reference, of_corners));

  // normals that vanish do not count
  for(const auto& w : v)
    of_vertices[w] = Vector(0, 0, 0);
  CHECK_EQUAL(PMP::normal_deviation(triangle, reference, of_vertices), 0.);

  // the normals of the sphere at the vertices of an inscribed mesh, interpolated, are nearly those of the sphere
  Mesh sphere = make_mesh(icosphere(3));
  auto sphere_normals = sphere.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  for(Mesh::Vertex_index w : sphere.vertices())
    sphere_normals[w] = sphere.point(w) - CGAL::ORIGIN;
  CHECK_NEAR(PMP::normal_deviation(sphere, Exact_sphere(), sphere_normals), 0., 1e-6);
}

// A face of which each corner lies over a face of the reference that is tiny, unlike the others.
void test_normals_of_large_face()
{
  start_topic("normals of a large face whose corners lie over tiny faces");
  constexpr std::size_t n = 12;
  constexpr double tiny = 1e-4;
  const auto line = [&](double i) { return i == 0 ? 0. : i == n ? 1. : tiny + (1 - 2 * tiny) * (i - 1) / (n - 2); };
  const auto on_waves = [](double x, double y) { return Point(x, y, std::sin(45 * x) * std::cos(31.5 * y + 0.7) / 90); };
  const Mesh reference =
    moved(triangle_grid(n, n, false, 0), [&](const Point& p) { return on_waves(line(p.x()), line(p.y())); });
  const Flat_surface surface(reference);
  const Point a = on_waves(tiny / 2, tiny / 3), b = on_waves(1 - tiny / 2, tiny / 3), c = on_waves(tiny / 3, 1 - tiny / 2);
  const Mesh face = make_mesh(Soup{ { a, b, c }, { { 0, 1, 2 } } });
  const double mean = mean_over_faces(face, 600, [&](const Point& x, const Vector& normal) {
    return std::acos(surface.normal(surface.project(x)) * normal) * 180 / CGAL_PI;
  });
  CHECK_NEAR(PMP::normal_deviation(face, surface), mean, 0.005 * mean);
}

void test_degenerate_input()
{
  start_topic("degenerate input");
  const Mesh plane = make_mesh(planar_patch(2));
  CHECK(PMP::approximation_error(Mesh(), plane) == PMP::Approximation_error());
  CHECK(PMP::approximation_error(Mesh(), Mesh()) == PMP::Approximation_error());
  CHECK_EQUAL(PMP::normal_deviation(Mesh(), plane), 0.);

  // a face without an area has a maximum, and a mean in the map
  Mesh needle;
  const Mesh::Face_index f =
    needle.add_face(needle.add_vertex(Point(0, 0, 1)), needle.add_vertex(Point(1, 0, 1)), needle.add_vertex(Point(2, 0, 1)));
  auto face_errors = needle.add_property_map<Mesh::Face_index, double>("f:error", -1).first;
  const PMP::Approximation_error e = PMP::approximation_error(needle, plane, CGAL::parameters::face_error_map(face_errors));
  CHECK_EQUAL(e.mean, 0.);
  CHECK_EQUAL(e.rms, 0.);
  CHECK_NEAR(e.max, 1., 1e-12);
  CHECK_NEAR(face_errors[f], 1., 1e-12);
  CHECK_EQUAL(PMP::normal_deviation(needle, plane), 0.);
  CHECK_NEAR(PMP::approximation_error(plane, needle).max, 3., 2.);

  // a face without an area among others, which are refined, makes no difference
  const Soup sphere = icosphere(3);
  Soup with_needle = sphere;
  with_needle.points.insert(with_needle.points.end(), { Point(0, 0, 1), Point(0.1, 0, 1), Point(0.2, 0, 1) });
  const std::size_t n = sphere.points.size();
  with_needle.triangles.push_back({ n, n + 1, n + 2 });
  const Mesh rough = moved(icosphere(5), [](const Point& p) {
    return CGAL::ORIGIN + (1 + 0.03 * std::sin(20 * p.x()) * std::cos(17 * p.y() + p.z())) * (p - CGAL::ORIGIN);
  });
  const double mean = PMP::approximation_error(make_mesh(sphere), rough).mean;
  CHECK_NEAR(PMP::approximation_error(make_mesh(with_needle), rough).mean, mean, 1e-12 * mean);

  // coordinates so large that areas overflow
  const Mesh huge = moved(planar_patch(2), [](const Point& p) { return Point(1e200 * p.x(), 1e200 * p.y(), 1); });
  const PMP::Approximation_error h = PMP::approximation_error(huge, plane);
  CHECK(!std::isnan(h.mean) && !std::isnan(h.rms) && !std::isnan(h.max));
  CHECK(!std::isnan(PMP::normal_deviation(huge, plane)));

#ifdef CGAL_NO_ASSERTIONS
  // violated preconditions that are not checked
  auto is_infinite = [](const PMP::Approximation_error& x) {
    return std::isinf(x.mean) && std::isinf(x.rms) && std::isinf(x.max);
  };
  const Mesh nan = moved(planar_patch(2), [](const Point& p) { return Point(p.x(), p.y(), std::nan("")); });
  CHECK(is_infinite(PMP::approximation_error(plane, Mesh())));
  CHECK(is_infinite(PMP::approximation_error(nan, plane)));
  CHECK(is_infinite(PMP::approximation_error(plane, nan)));
  CHECK_EQUAL(PMP::normal_deviation(nan, plane), 180.);
#endif
}

int main()
{
  test_parallel_planes();
  test_translation();
  test_inscribed_sphere();
  test_crossing_surfaces();
  test_number_of_points();
  test_error_maps();
  test_threads();
  test_normal_deviation();
  test_normals_of_large_face();
  test_degenerate_input();
  test_models();
  test_maximum_between_samples();
  test_large_face();
  test_narrow_maximum();
  test_real_models();
  return test_result();
}
