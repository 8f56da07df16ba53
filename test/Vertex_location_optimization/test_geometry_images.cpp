// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Geometry images, how they are triangulated and optimized.

#include "check.h"
#include "Exact_sphere.h"
#include "mesh_quality.h"
#include "test_images.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/optimize_geometry_image.h>

#include <CGAL/assertions_behaviour.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::parameters;

Mesh triangulated(const Image& image)
{
  Mesh mesh;
  CGAL::geometry_image_to_polygon_mesh(image, mesh);
  return mesh;
}

Mesh triangulated(const Image& image, const Image& diagonals)
{
  Mesh mesh;
  CGAL::geometry_image_to_polygon_mesh(image, mesh, diagonals);
  return mesh;
}

std::vector<std::array<std::size_t, 3>> triangles_of(const Mesh& mesh)
{
  std::vector<std::array<std::size_t, 3>> triangles;
  for(Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    triangles.push_back({ mesh.source(h), mesh.target(h), mesh.target(mesh.next(h)) });
  }
  return triangles;
}

// A mesh without non-manifold vertices, of so many vertices, faces and borders.
Mesh check_mesh(const Image& image, std::size_t vertices, std::size_t faces, std::size_t borders)
{
  const Mesh mesh = triangulated(image);
  CHECK_EQUAL(mesh.number_of_vertices(), vertices);
  CHECK_EQUAL(mesh.number_of_faces(), faces);
  CHECK(CGAL::is_valid_polygon_mesh(mesh));
  CHECK(CGAL::is_triangle_mesh(mesh));
  std::vector<Mesh::Halfedge_index> found;
  PMP::non_manifold_vertices(mesh, std::back_inserter(found));
  CHECK_EQUAL(found.size(), 0u);
  found.clear();
  Mesh copy = mesh;
  PMP::extract_boundary_cycles(copy, std::back_inserter(found));
  CHECK_EQUAL(found.size(), borders);
  return mesh;
}

// The triangles of an open image whose samples all differ: two a quad, from its shorter diagonal.
void check_diagonals(const Image& image)
{
  const std::size_t w = image.width(), h = image.height();
  const Mesh mesh = check_mesh(image, w * h, 2 * (w - 1) * (h - 1), 1);
  for(std::size_t i = 0; i < h; ++i)
    for(std::size_t j = 0; j < w; ++j)
      CHECK_EQUAL(mesh.point(Mesh::Vertex_index(static_cast<unsigned int>(i * w + j))), image(i, j));

  const auto triangles = triangles_of(mesh);
  for(std::size_t i = 0; i + 1 < h; ++i)
    for(std::size_t j = 0; j + 1 < w; ++j)
    {
      const std::size_t a = i * w + j, b = a + 1, d = a + w, c = d + 1;
      std::array<std::size_t, 4> in_both{}; // how many of the two triangles a corner of the quad is in
      for(std::size_t t : { 0, 1 })
        for(std::size_t v : triangles[2 * (i * (w - 1) + j) + t])
          for(std::size_t k = 0; k < 4; ++k)
            in_both[k] += v == std::array{ a, b, c, d }[k];
      const bool is_ac_shorter = norm(image(i, j) - image(i + 1, j + 1)) <= norm(image(i, j + 1) - image(i + 1, j));
      const std::array<std::size_t, 4> from_a_to_c{ 2, 1, 2, 1 }, from_b_to_d{ 1, 2, 1, 2 };
      CHECK(in_both == (is_ac_shorter ? from_a_to_c : from_b_to_d));
    }
}

void test_triangulation()
{
  start_topic("Open images are split along the shorter diagonals");
  check_diagonals(open_patch(9, 6));
  check_diagonals(open_patch(2, 2));
  check_diagonals(make_image(5, 7, [](std::size_t i, std::size_t j) { return Point(j + 2. * i, 3. * i - j, 0); }));

  start_topic("Closed images");
  Mesh mesh = check_mesh(octahedral_sphere(33), 32 * 32 + 2, 2 * 32 * 32, 0);
  CHECK_NEAR(PMP::volume(mesh), 4 * CGAL_PI / 3, 0.03); // oriented outwards
  mesh = check_mesh(octahedral_sphere(33).downsampled(4), 8 * 8 + 2, 2 * 8 * 8, 0);
  mesh = check_mesh(polar_sphere(41, 21), 40 * 19 + 2, 2 * 40 * 19, 0);
  CHECK_NEAR(PMP::volume(mesh), 4 * CGAL_PI / 3, 0.05);
  mesh = check_mesh(torus(31, 17, 2, 0.5), 30 * 16, 2 * 30 * 16, 0);
  CHECK_NEAR(PMP::volume(mesh), CGAL_PI * CGAL_PI, 0.4);

  start_topic("The two triangles at a fold differ");
  check_mesh(octahedral_sphere(33, 3), 32 * 32 + 2, 2 * 32 * 32, 0);

  start_topic("Sides with a common corner are joined: the corner is in no triangle");
  const Image joined = cone(12);
  mesh = check_mesh(joined, 12 * 12 - 11 - 1, 2 * 11 * 11 - 2, 1);
  CHECK(std::find(mesh.points().begin(), mesh.points().end(), joined(0, 0)) == mesh.points().end());

  start_topic("What is no surface is cut open");
  check_mesh(moebius_strip(30, 7), 30 * 7, 2 * 29 * 6, 1); // the seam is twice there
  check_mesh(torus(31, 17, 1, 1), 30 * 15 + 2, 2 * 30 * 15, 0);
  Image bow = open_patch(9, 9);
  bow(8, 4) = bow(0, 4);
  check_mesh(bow, 81, 128, 1);

  start_topic("Images without an area");
  for(const auto& [width, height] : { std::pair(0, 0), { 1, 1 }, { 7, 1 }, { 1, 7 }, { 0, 3 } })
    check_mesh(Image(width, height), 0, 0, 0);
  check_mesh(make_image(2, 2, [](std::size_t, std::size_t) { return Point(1, 2, 3); }), 0, 0, 0);
  const Mesh flat = triangulated(Image(5, 5)); // the border is one point
  CHECK(CGAL::is_valid_polygon_mesh(flat));

  start_topic("Meshes of other types, and those that are not empty");
  using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  CGAL::Polyhedron_3<Exact_kernel> polyhedron;
  CGAL::geometry_image_to_polygon_mesh(octahedral_sphere(9), polyhedron);
  CHECK_EQUAL(polyhedron.size_of_vertices(), 66u);
  CHECK(polyhedron.is_closed());
  CGAL::geometry_image_to_polygon_mesh(octahedral_sphere(9), polyhedron);
  CHECK_EQUAL(polyhedron.size_of_vertices(), 132u);
  Mesh other;
  auto map = other.add_property_map<Mesh::Vertex_index, Point>("other").first;
  CGAL::geometry_image_to_polygon_mesh(open_patch(3, 3), other, params::vertex_point_map(map));
  CHECK_EQUAL(map[Mesh::Vertex_index(4)], open_patch(3, 3)(1, 1));
}

void test_samples()
{
  start_topic("Down-sampling keeps the last row and column");
  const Image image = make_image(14, 8, [](std::size_t i, std::size_t j) { return Point(i, j, 0); });
  for(std::size_t step = 1; step < 20; ++step)
  {
    std::vector<std::size_t> rows, columns;
    for(std::size_t i = 0; i < 7; i += step)
      rows.push_back(i);
    for(std::size_t j = 0; j < 13; j += step)
      columns.push_back(j);
    rows.push_back(7);
    columns.push_back(13);
    CHECK(are_identical(image.downsampled(step), make_image(columns.size(), rows.size(), [&](std::size_t i, std::size_t j) {
                          return Point(rows[i], columns[j], 0);
                        })));
  }
  CHECK(are_identical(image.downsampled((std::numeric_limits<std::size_t>::max)()), image.downsampled(100)));
  CHECK_EQUAL(Image(1, 5).downsampled(2).width(), 1u);
  CHECK_EQUAL(Image(1, 5).downsampled(2).height(), 3u);
  CHECK_EQUAL(Image().downsampled(3).width(), 0u);

  start_topic("Sizes that there cannot be");
  for(std::size_t size : { std::size_t(1) << 32, (std::numeric_limits<std::size_t>::max)() / 2 + 2 })
  {
    bool has_thrown = false;
    try
    {
      Image absurd(size, size);
    }
    catch(const std::length_error&)
    {
      has_thrown = true;
    }
    CHECK(has_thrown);
  }
}

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
  CHECK(are_identical(
    optimized(image, sphere, params::placement_method(PMP::LEAST_SQUARES)).image,
    optimized(image, sphere,
              params::placement_method(PMP::LEAST_SQUARES).convergence_threshold(3e-4).do_self_intersection_tests(true))
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

#ifdef NDEBUG
constexpr bool checks_are_on = false;
#else
constexpr bool checks_are_on = true;
#endif

// checks that a precondition of f() is violated, where that is checked
template <typename F>
void check_refused(const F& f)
{
  bool has_thrown = false;
  try
  {
    f();
  }
  catch(const CGAL::Precondition_exception&)
  {
    has_thrown = true;
  }
  CHECK_EQUAL(has_thrown, checks_are_on);
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
      check_refused([&] { CHECK_EQUAL(PMP::optimize_geometry_image(image, sphere).iterations, 0u); });
      CHECK(are_identical(image, input));
      Mesh mesh;
      check_refused([&] { CGAL::geometry_image_to_polygon_mesh(image, mesh); });
      CHECK_EQUAL(mesh.number_of_vertices(), 0u);
    }

  start_topic("Images and references without an area, and diagonals of another size");
  for(const auto& [width, height] : { std::pair(0, 0), { 1, 1 }, { 7, 1 }, { 2, 2 }, { 5, 5 } })
    CHECK(are_identical(optimized(Image(width, height), sphere).image, Image(width, height)));
  Image image = octahedral_sphere(9);
  check_refused([&] { PMP::optimize_geometry_image(image, Mesh()); });
  check_refused([&] { PMP::optimize_geometry_image(image, sphere, params::convergence_threshold(-1)); });
  check_refused([&] { image.downsampled(0); });
  CHECK(are_identical(image, octahedral_sphere(9)));
  Mesh mesh;
  check_refused([&] { CGAL::geometry_image_to_polygon_mesh(image, mesh, Image(9, 8)); });
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
  test_triangulation();
  test_samples();
  test_closed_images();
  test_open_images();
  test_parameters();
  test_references_and_kernels();
  test_bad_images();
  return test_result();
}
