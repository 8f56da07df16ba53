// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes with faces of more than three corners.

#include "attributes_of_polygons.h"
#include "check.h"
#include "Exact_sphere.h"
#include "mesh_quality.h"
#include "polygon_meshes.h"

#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/Polygon_mesh_processing/approximation_error.h>
#include <CGAL/Polygon_mesh_processing/attribute_error.h>
#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Fans.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_attributes.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_normals.h>
#include <CGAL/Polygon_mesh_processing/PN_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/transfer_face_attributes.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::parameters;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Halfedge = Mesh::Halfedge_index;

constexpr PMP::Placement_method methods[]{ PMP::PIECEWISE_LINEAR, PMP::LEAST_SQUARES };

// The fans of a convex polygon cover it: their weights are n - 2 triangles, their areas that of the polygon.
void test_fans()
{
  using PMP::internal::vertex_location::Fans;
  start_topic("The fans of a polygon");
  for(unsigned int n : { 3, 4, 5, 6, 9, 64, 200 })
  {
    const Fans fans(n);
    CHECK_AT_MOST(fans.triangles.size(), 64u * n);
    const auto corner = [&](unsigned int k) {
      return Point(std::cos(2 * CGAL_PI * k / n), std::sin(2 * CGAL_PI * k / n), 0);
    };
    double weight = 0, area = 0;
    std::vector<double> weights_at(n, 0);
    for(const auto& t : fans.triangles)
    {
      const Vector v = area_vector({ corner(t.corners[0]), corner(t.corners[1]), corner(t.corners[2]) });
      CHECK_LESS(0, v.z());
      weight += t.weight;
      area += t.weight * v.z();
      for(unsigned int k : t.corners)
        weights_at[k] += t.weight;
    }
    CHECK_NEAR(weight, n - 2., 1e-12 * n);
    const double expected = n / 2. * std::sin(2 * CGAL_PI / n);
    CHECK_NEAR(area, expected, n <= 64 ? 1e-12 : 1e-3 * expected);
    if(n <= 64)
      for(double w : weights_at)
        CHECK_NEAR(w, 3 * (n - 2.) / n, 1e-12);
  }
}

// The errors of a polygon are the means of those of its fans.
void test_errors()
{
  const Exact_sphere sphere(Point(0.1, 0, 0), 1.02);
  const auto evenly = params::number_of_points_per_face(64); // the same points of a triangle, whatever the others are
  constexpr double precision = 0.002;                        // of the search for the maximum, and of the default
  for(const int degree : { 4, 5 })
  {
    start_topic("Errors of faces with " + std::to_string(degree) + " corners");
    const Mesh mesh = degree == 4 ? make_mesh(cube_sphere(3)) : dual_icosphere(0);
    const auto normals = [](Mesh& m) {
      const auto map = m.add_property_map<Vertex, Vector>("v:normal").first;
      for(const Vertex v : m.vertices())
        map[v] = Vector(m.point(v).y(), m.point(v).z(), m.point(v).x());
      return map;
    };
    double area = 0, mean = 0, square = 0, max = 0, normal = 0, face_normal = 0;
    for(int shift = 0; shift < degree; ++shift)
    {
      Mesh fans = with_fans(mesh, shift);
      double area_of_fans = 0;
      for(const Face f : fans.faces())
        area_of_fans += norm(area_vector(corners(fans, f)));
      const PMP::Approximation_error error = PMP::approximation_error(fans, sphere, evenly);
      area += area_of_fans;
      mean += area_of_fans * error.mean;
      square += area_of_fans * error.rms * error.rms;
      max = (std::max)(max, error.max);
      normal += area_of_fans * PMP::normal_deviation(fans, sphere, normals(fans), evenly);
      face_normal += area_of_fans * PMP::normal_deviation(fans, sphere, evenly);
    }
    Mesh polygons = mesh;
    const auto face_errors = polygons.add_property_map<Face, double>("f:error", -1).first;
    const auto vertex_errors = polygons.add_property_map<Vertex, double>("v:error", -1).first;
    const PMP::Approximation_error error = PMP::approximation_error(
      polygons, sphere, params::face_error_map(face_errors).vertex_error_map(vertex_errors).number_of_points_per_face(64));
    CHECK_NEAR(error.mean, mean / area, 1e-12);
    CHECK_NEAR(error.rms, std::sqrt(square / area), 1e-12);
    CHECK_NEAR(error.max, max, precision * max);
    const PMP::Approximation_error by_default = PMP::approximation_error(polygons, sphere);
    const PMP::Approximation_error truth =
      PMP::approximation_error(polygons, sphere, params::number_of_points_per_face(10000));
    CHECK_NEAR(by_default.mean, truth.mean, precision * truth.mean);
    CHECK_NEAR(by_default.rms, truth.rms, precision * truth.rms);
    CHECK_NEAR(by_default.max, max, precision * max);
    CHECK_NEAR(PMP::normal_deviation(polygons, sphere, normals(polygons), evenly), normal / area, 1e-9);
    CHECK_NEAR(PMP::normal_deviation(polygons, sphere, normals(polygons)), normal / area, precision * normal / area);
    if(degree == 5) // planar faces, whose triangles have their normals
    {
      CHECK_NEAR(PMP::normal_deviation(polygons, sphere, evenly), face_normal / area, 1e-9);
      const double dense = PMP::normal_deviation(polygons, sphere, params::number_of_points_per_face(10000));
      CHECK_NEAR(PMP::normal_deviation(polygons, sphere), dense, precision * dense);
    }

    // the corners have the errors of their faces
    const auto [min, largest] = std::minmax_element(face_errors.begin(), face_errors.end());
    CHECK_LESS(0, *min);
    for(const Vertex v : polygons.vertices())
    {
      CHECK_AT_LEAST(vertex_errors[v], *min);
      CHECK_AT_MOST(vertex_errors[v], *largest);
    }
  }
}

// By how much the mean error of flat regular polygons with their corners on a sphere falls when they are offset by the mean:
// the height of the sphere over them falls from the center with the square of the distance.
double expected_ratio(const int n)
{
  const int steps = 400;
  const double height = std::cos(CGAL_PI / n), half_side = std::sin(CGAL_PI / n); // of the triangles around the center
  std::vector<double> gaps, weights;
  for(int i = 0; i < steps; ++i)
    for(int j = 0; j < steps; ++j)
    {
      const double x = (i + 0.5) / steps * height, y = (j + 0.5) / steps * half_side * x / height;
      gaps.push_back(1 - x * x - y * y);
      weights.push_back(x);
    }
  double sum = 0, sum_of_weights = 0, deviation = 0;
  for(std::size_t k = 0; k < gaps.size(); ++k)
  {
    sum += weights[k] * gaps[k];
    sum_of_weights += weights[k];
  }
  for(std::size_t k = 0; k < gaps.size(); ++k)
    deviation += weights[k] * std::abs(gaps[k] - sum / sum_of_weights);
  return deviation / sum;
}

void test_squares_on_sphere()
{
  start_topic("Squares of side h on a sphere of radius r: vertices move by h^2 / 6r");
  const int n = 12;
  const double h = 1e-3, r = 2;
  const Exact_sphere sphere(Point(0, 0, -r), r);
  Mesh mesh = make_mesh(transformed(square_grid(n, n), [&](const Point& p) {
    return sphere.point(sphere.project(Point(h * (p.x() - n / 2), h * (p.y() - n / 2), 0)));
  }));
  const Mesh before = mesh;
  PMP::optimize_vertex_locations(mesh, sphere, params::number_of_iterations(5));
  for(const Vertex v : mesh.vertices())
    if(!mesh.is_border(v))
      CHECK_NEAR(norm(mesh.point(v) - Point(0, 0, -r)) - r, h * h / (6 * r), 1e-4 * h * h / r);

  const auto inner_error = [&](Mesh m) {
    const auto errors = m.add_property_map<Face, double>("f:error").first;
    PMP::approximation_error(m, sphere, params::face_error_map(errors).number_of_points_per_face(400));
    return errors[Face(n / 2 * n + n / 2)];
  };
  CHECK_NEAR(inner_error(mesh) / inner_error(before), expected_ratio(4), 0.01);
}

// what faces of four, five and six corners gain on a sphere
void test_spheres()
{
  const Exact_sphere sphere(Point(0, 0, 0), 1);
  const Mesh reference = make_mesh(transformed(icosphere(5), rotated));
  for(const bool is_dual : { false, true })
    for(const PMP::Placement_method method : methods)
    {
      start_topic(std::string(is_dual ? "Hexagons" : "Quads") + " on a sphere, method " + std::to_string(method));
      const Mesh before = is_dual ? dual_icosphere(3) : make_mesh(cube_sphere(12));
      Mesh after = before;
      const PMP::Vertex_location_optimization_report report =
        PMP::optimize_vertex_locations<CGAL::Parallel_if_available_tag>(after, reference, params::placement_method(method));
      CHECK_LESS(0u, report.iterations);
      const PMP::Approximation_error error_before = PMP::approximation_error(before, sphere),
                                     error_after = PMP::approximation_error(after, sphere);
      // 0.26 for squares, 0.36 for hexagons
      CHECK_AT_MOST(error_after.mean, 1.05 * expected_ratio(is_dual ? 6 : 4) * error_before.mean);
      CHECK_AT_MOST(error_after.max, error_before.max);
      CHECK(CGAL::is_valid_polygon_mesh(after));

      Mesh other = with_other_corners_first(before);
      PMP::optimize_vertex_locations(other, reference, params::placement_method(method));
      CHECK(points_of(other) == points_of(after));
    }
}

// Planes are fixed points, also with faces that are not convex.
void test_planes()
{
  start_topic("Planar faces of any shape stay");
  Polygon_soup soup = square_grid(6, 6);
  for(std::size_t i = 0; i < soup.points.size(); ++i)
    if(const Point p = soup.points[i]; p.x() > 0 && p.x() < 6 && p.y() > 0 && p.y() < 6)
      soup.points[i] = p + Vector(0.55 * std::sin(7. * i), 0.55 * std::cos(5. * i), 0); // some are notches
  Mesh mesh = make_mesh(transformed(soup, rigid_motion));
  CGAL::Euler::join_face(mesh.halfedge(Vertex(9), Vertex(16)), mesh);
  const Mesh reference = make_mesh(transformed(
    transformed(triangle_grid(9, 9), [](const Point& p) { return Point(p.x() - 1, p.y() - 1, 0); }), rigid_motion));
  for(const PMP::Placement_method method : methods)
  {
    Mesh result = mesh;
    PMP::optimize_vertex_locations(result, reference, params::placement_method(method));
    CHECK_AT_MOST(largest_distance(points_of(result), points_of(mesh)), 1e-8);
  }
  CHECK_NEAR(PMP::approximation_error(mesh, reference).max, 0, 1e-14);
  CHECK_NEAR(PMP::normal_deviation(mesh, reference), 0, 1e-6);

  start_topic("A prism with 90 sides stays");
  Polygon_soup soup_of_prism;
  std::vector<std::size_t> bottom, top;
  for(std::size_t i = 0; i < 90; ++i)
    for(double z : { 0., 1. })
    {
      const double angle = CGAL_PI * i / 45;
      (z == 0 ? bottom : top).push_back(soup_of_prism.points.size());
      soup_of_prism.points.push_back(rotated(Point(20 * std::cos(angle), 20 * std::sin(angle), z)));
    }
  for(std::size_t i = 0; i < 90; ++i)
    soup_of_prism.polygons.push_back({ bottom[i], bottom[(i + 1) % 90], top[(i + 1) % 90], top[i] });
  std::reverse(bottom.begin(), bottom.end());
  soup_of_prism.polygons.push_back(bottom);
  soup_of_prism.polygons.push_back(top);
  const Mesh prism = make_mesh(soup_of_prism);
  for(const PMP::Placement_method method : methods)
  {
    Mesh result = prism;
    PMP::optimize_vertex_locations(result, PMP::Flat_triangle_surface<Mesh>(prism), params::placement_method(method));
    CHECK_AT_MOST(largest_distance(points_of(result), points_of(prism)), 1e-8);
  }
}

int main()
{
  test_fans();
  test_errors();
  test_squares_on_sphere();
  test_spheres();
  test_planes();
  test_attributes();
  test_references();
  return test_result();
}
