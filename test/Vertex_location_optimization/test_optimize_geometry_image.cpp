// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Geometry images are optimized as their meshes, and samples at the same point stay together.

#include "check.h"
#include "check_violation.h"
#include "Exact_sphere.h"
#include "mesh_quality.h"
#include "test_images.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/optimize_geometry_image.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::parameters;

// the border samples at the same points, as those of an image before it was optimized
std::vector<std::array<std::size_t, 4>> coinciding_samples(const Image& image)
{
  auto is_border = [&](std::size_t i, std::size_t j) {
    return i == 0 || j == 0 || i + 1 == image.height() || j + 1 == image.width();
  };
  std::vector<std::array<std::size_t, 4>> pairs;
  for(std::size_t i = 0; i < image.height(); ++i)
    for(std::size_t j = 0; j < image.width(); ++j)
      for(std::size_t k = 0; k < image.height() && is_border(i, j); ++k)
        for(std::size_t l = 0; l < image.width(); ++l)
          if(is_border(k, l) && image(i, j) == image(k, l) && (i != k || j != l))
            pairs.push_back({ i, j, k, l });
  return pairs;
}

struct Result
{
  Image image;
  PMP::Vertex_location_optimization_report report;
};

template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename Reference,
          typename NP = params::Default_named_parameters>
Result optimized(const Image& input, const Reference& reference, const NP& np = params::default_values())
{
  Result result{ input, {} };
  result.report = PMP::optimize_geometry_image<ConcurrencyTag>(result.image, reference, np);
  for(const auto& [i, j, k, l] : coinciding_samples(input))
    CHECK(are_identical(result.image(i, j), result.image(k, l)));
  return result;
}

// The mean error after relative to that before, with the same triangles; the maximum is not larger.
template <typename Distance>
double error_ratio(const Image& input, const Image& output, const Distance& distance)
{
  const Mesh before = triangulated(input), after = triangulated(output, input);
  CHECK(triangles_of(before) == triangles_of(after));
  const Errors errors_before = measure_errors(before, 8, distance), errors_after = measure_errors(after, 8, distance);
  CHECK_AT_MOST(errors_after.max, errors_before.max);
  return errors_after.mean / errors_before.mean;
}

double distance_to_sphere(const Point& p) { return std::abs(norm(p - CGAL::ORIGIN) - 1); }
double distance_to_torus(const Point& p) { return std::abs(std::hypot(std::hypot(p.x(), p.y()) - 2, p.z()) - 0.5); }

void test_closed_images()
{
  const Exact_sphere sphere(CGAL::ORIGIN, 1);
  start_topic("A sphere with folded sides");
  CHECK_LESS(coinciding_samples(octahedral_sphere(33)).size(), 150u);
  CHECK_LESS(100u, coinciding_samples(octahedral_sphere(33)).size());
  for(double spike : { 1., 1.05 })
  {
    const Image image = octahedral_sphere(33, spike);
    const Image result = optimized(image, sphere).image;
    CHECK_LESS(error_ratio(image, result, distance_to_sphere), 0.25);
    for(const Point& p : result)
      CHECK_LESS(1, norm(p - CGAL::ORIGIN)); // also on the side-band and at the folds
  }

  start_topic("A sphere with poles");
  const Image polar = polar_sphere(41, 21);
  CHECK_LESS(error_ratio(polar, optimized(polar, sphere).image, distance_to_sphere), 0.35);

  start_topic("A torus");
  const Image image = torus(61, 25, 2, 0.5);
  const Mesh fine = triangulated(torus(241, 97, 2, 0.5));
  const PMP::Flat_triangle_surface<Mesh> flat(fine);
  CHECK_LESS(error_ratio(image, optimized(image, fine).image, distance_to_torus), 0.5);
  CHECK_LESS(error_ratio(image, optimized(image, flat).image, distance_to_torus), 0.5);

  start_topic("A torus that touches itself in a point keeps it");
  const Image horn = torus(31, 17, 1, 1);
  const Result horn_result = optimized(horn, triangulated(torus(121, 65, 1, 1)));
  CHECK_EQUAL(horn_result.image(0, 0), horn(0, 0));
  CHECK(horn_result.image(8, 8) != horn(8, 8));

  start_topic("The image is optimized as its mesh, without springs");
  Mesh mesh = triangulated(octahedral_sphere(17));
  PMP::optimize_vertex_locations(mesh, sphere, params::number_of_relaxation_steps(0));
  const Result result = optimized(octahedral_sphere(17), sphere);
  CHECK(points_of(mesh) == points_of(triangulated(result.image, octahedral_sphere(17))));
  CHECK(are_identical(result.image, optimized<CGAL::Sequential_tag>(octahedral_sphere(17), sphere).image));
}

void test_open_images()
{
  start_topic("The border of an open image stays");
  const Image image = open_patch(25, 19);
  const Mesh fine = triangulated(open_patch(193, 145));
  const PMP::Flat_triangle_surface<Mesh> reference(fine);
  const auto distance = [&](const Point& p) { return norm(p - reference.point(reference.project(p))); };
  const auto check_border = [&](const Image& result, bool stays) {
    std::size_t moved = 0;
    for(std::size_t i = 0; i < 19; ++i)
      for(std::size_t j : { 0, 24 })
        moved += !are_identical(result(i, j), image(i, j));
    for(std::size_t j = 0; j < 25; ++j)
      for(std::size_t i : { 0, 18 })
        moved += !are_identical(result(i, j), image(i, j));
    CHECK_EQUAL(moved == 0, stays);
    for(std::size_t i : { 0, 18 })
      for(std::size_t j : { 0, 24 })
        CHECK(are_identical(result(i, j), image(i, j)));
  };
  const Image result = optimized(image, reference).image;
  check_border(result, true);
  CHECK_LESS(error_ratio(image, result, distance), 0.5);
  const Image relaxed = optimized(image, reference, params::relax_constraints(true)).image;
  check_border(relaxed, false);
  CHECK_LESS(error_ratio(image, relaxed, distance), 0.5);

  start_topic("A plane stays as it is");
  const Image plane = make_image(9, 9, [](std::size_t i, std::size_t j) { return Point(j + 0.25 * (i % 2), i, 0); });
  const Mesh plane_mesh =
    make_mesh(transformed(triangle_grid(2, 2), [](const Point& p) { return Point(9 * p.x() - 6, 9 * p.y() - 6, 0); }));
  const Image plane_result = optimized(plane, plane_mesh).image;
  for(std::size_t i = 0; i < 9; ++i)
    for(std::size_t j = 0; j < 9; ++j)
      CHECK_AT_MOST(norm(plane_result(i, j) - plane(i, j)), 1e-12);

  start_topic("A one-sided image");
  const Image strip = moebius_strip(40, 9);
  const Result strip_result = optimized(strip, triangulated(moebius_strip(157, 33)));
  CHECK_LESS(0u, strip_result.report.iterations);
  CHECK(!are_identical(strip_result.image, strip));
  for(std::size_t i = 0; i < 9; ++i)
    CHECK_EQUAL(strip_result.image(i, 0), strip(i, 0)); // where it is cut
}

struct Counting_visitor : PMP::Vertex_location_optimization_default_visitor
{
  void end_iteration(const PMP::Vertex_location_optimization_report&) { ++iterations; }
  bool go_further() { return iterations < 4; }

  std::size_t iterations = 0;
};

void test_parameters()
{
  start_topic("Named parameters");
  const Exact_sphere sphere(CGAL::ORIGIN, 1);
  const Image image = octahedral_sphere(17);
  const Image result = optimized(image, sphere).image;
  CHECK_EQUAL(optimized(image, sphere, params::number_of_iterations(3)).report.iterations, 3u);
  Image same = image;
  CHECK_EQUAL(PMP::optimize_geometry_image(same, sphere, params::number_of_iterations(0)).iterations, 0u);
  CHECK(are_identical(same, image));
  CHECK(optimized(image, sphere, params::convergence_threshold(0.5)).report.converged);
  CHECK(!are_identical(optimized(image, sphere, params::number_of_free_iterations(0)).image, result));
  CHECK(are_identical(optimized(image, sphere, params::do_self_intersection_tests(true)).image, result));
  CHECK(are_identical(optimized(image, sphere, params::number_of_relaxation_steps(9)).image, result)); // no springs

  auto is_default = [&](const auto& np) { return are_identical(optimized(image, sphere, np).image, result); };
  CHECK(is_default(params::number_of_iterations(30)));
  CHECK(is_default(params::number_of_free_iterations(20)));
  CHECK(is_default(params::convergence_threshold(1e-6)));
  CHECK(is_default(params::placement_method(PMP::PIECEWISE_LINEAR)));
  CHECK(is_default(params::relax_constraints(false)));
  CHECK(is_default(params::do_self_intersection_tests(false)));
  CHECK(is_default(params::visitor(PMP::Vertex_location_optimization_default_visitor())));
  CHECK(are_identical(optimized(image, sphere, params::placement_method(PMP::LEAST_SQUARES)).image,
                      optimized(image, sphere,
                                params::placement_method(PMP::LEAST_SQUARES)
                                  .regularity_weight(std::optional<double>()) // that follows the mesh
                                  .do_self_intersection_tests(true))
                        .image));

  Counting_visitor visitor;
  const Result stopped = optimized(image, sphere, params::visitor(std::ref(visitor)));
  CHECK_EQUAL(stopped.report.iterations, 4u);
  CHECK_EQUAL(visitor.iterations, 4u);

  const auto least_squares = params::regularity_weight(0.2).placement_method(PMP::LEAST_SQUARES);
  const Image least_squares_result = optimized(image, sphere, least_squares.number_of_iterations(20)).image;
  CHECK(!are_identical(least_squares_result, result));
  CHECK_LESS(error_ratio(image, least_squares_result, distance_to_sphere), 0.3);
}

void test_references_and_kernels()
{
  start_topic("The second sequence is that of the reference");
  const Mesh cube_mesh = make_mesh(cube(3));
  Image cube_image = octahedral_sphere(17), smooth = cube_image;
  PMP::optimize_geometry_image(cube_image, cube_mesh, params::default_values(), params::sharpness_angle(45));
  PMP::optimize_geometry_image(smooth, cube_mesh, params::default_values(), params::sharpness_angle(120));
  CHECK(!are_identical(cube_image, smooth));

  start_topic("Points of an exact kernel");
  const Exact_sphere sphere(CGAL::ORIGIN, 1);
  using Exact_point = CGAL::Exact_predicates_exact_constructions_kernel::Point_3;
  CGAL::Geometry_image<Exact_point> exact(9, 9);
  const Image inexact = octahedral_sphere(9);
  for(std::size_t i = 0; i < 9; ++i)
    for(std::size_t j = 0; j < 9; ++j)
      exact(i, j) = Exact_point(inexact(i, j).x(), inexact(i, j).y(), inexact(i, j).z());
  PMP::optimize_geometry_image(exact, sphere);
  const Image expected = optimized(inexact, sphere).image;
  for(std::size_t i = 0; i < 9; ++i)
    for(std::size_t j = 0; j < 9; ++j)
      CHECK_AT_MOST(
        norm(Point(CGAL::to_double(exact(i, j).x()), CGAL::to_double(exact(i, j).y()), CGAL::to_double(exact(i, j).z())) -
             expected(i, j)),
        1e-12);
}

void test_bad_images()
{
  const Exact_sphere sphere(CGAL::ORIGIN, 1);
  for(double bad : { std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, -HUGE_VAL })
    for(std::size_t i : { 0, 3, 8 })
    {
      start_topic("A coordinate that is " + std::to_string(bad) + " in row " + std::to_string(i));
      Image image = octahedral_sphere(9);
      image(i, 3) = Point(0, bad, 0);
      const Image input = image;
      check_violation([&] { CHECK_EQUAL(PMP::optimize_geometry_image(image, sphere).iterations, 0u); });
      CHECK(are_identical(image, input));
      Mesh mesh;
      check_violation([&] { CGAL::geometry_image_to_polygon_mesh(image, mesh); });
      CHECK_EQUAL(mesh.number_of_vertices(), 0u);
    }

  start_topic("Images and references without an area, and diagonals of another size");
  for(const auto& [width, height] : { std::pair(0, 0), { 1, 1 }, { 7, 1 }, { 2, 2 }, { 5, 5 } })
    CHECK(are_identical(optimized(Image(width, height), sphere).image, Image(width, height)));
  Image image = octahedral_sphere(9);
  check_violation([&] { PMP::optimize_geometry_image(image, Mesh()); });
  check_violation([&] { PMP::optimize_geometry_image(image, sphere, params::convergence_threshold(-1)); });
  check_violation([&] { image.downsampled(0); });
  CHECK(are_identical(image, octahedral_sphere(9)));
  Mesh mesh;
  check_violation([&] { CGAL::geometry_image_to_polygon_mesh(image, mesh, Image(9, 8)); });
  CHECK_EQUAL(mesh.number_of_vertices(), 0u);

  start_topic("Images whose samples coincide at random");
  CGAL::Random random(5);
  const Mesh reference = make_mesh(icosphere(1));
  for(int k = 0; k < 300; ++k)
  {
    const int size = random.get_int(1, 4); // of the lattice that the samples are taken from
    auto coordinate = [&] { return random.get_int(0, size + 1); };
    image = make_image(random.get_int(1, 7), random.get_int(1, 7), [&](std::size_t, std::size_t) {
      const int x = coordinate(), y = coordinate();
      return Point(x, y, coordinate());
    });
    CHECK(CGAL::is_valid_polygon_mesh(triangulated(image)));
    const Image result = optimized(image, reference, params::number_of_iterations(2)).image;
    for(const Point& p : result)
      CHECK_LESS(norm(p - CGAL::ORIGIN), 20);
  }
}

int main()
{
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {}); // no words, only exceptions
  test_closed_images();
  test_open_images();
  test_parameters();
  test_references_and_kernels();
  test_bad_images();
  return test_result();
}
