// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Geometry images and how they are triangulated.

#include "check.h"
#include "mesh_quality.h"
#include "test_images.h"
#include "test_meshes.h"

#include <CGAL/Geometry_image.h>

#include <CGAL/assertions_behaviour.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::parameters;

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

int main()
{
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {}); // no words, only exceptions
  test_triangulation();
  test_samples();
  return test_result();
}
