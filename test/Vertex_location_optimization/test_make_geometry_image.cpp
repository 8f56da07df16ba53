// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Geometry images made of meshes.

#include "check.h"
#include "Distance_to_mesh.h"
#include "remeshes.h"
#include "test_images.h"
#include "test_meshes.h"

#include <CGAL/make_geometry_image.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>

// An image of the mesh, whose samples are on it, those of the border on its border; its faces are oriented as the mesh.
Image check_image(const Mesh& mesh, std::size_t width, std::size_t height)
{
  Image image(width, height);
  CHECK(CGAL::make_geometry_image(mesh, image));
  CHECK_EQUAL(image.width(), width);
  CHECK_EQUAL(image.height(), height);

  const double rounding = 1e-9 * longest_side(mesh);
  const Distance_to_mesh surface(mesh);
  auto distance_to_border = [&](const Point& p) {
    double smallest = HUGE_VAL;
    for(Mesh::Edge_index e : mesh.edges())
      if(mesh.is_border(e))
        smallest = (std::min)(smallest, CGAL::squared_distance(p, Kernel::Segment_3(mesh.point(mesh.vertex(e, 0)),
                                                                                    mesh.point(mesh.vertex(e, 1)))));
    return std::sqrt(smallest);
  };
  Point hint = *mesh.points().begin();
  for(std::size_t i = 0; i < height; ++i)
    for(std::size_t j = 0; j < width; ++j)
    {
      CHECK_AT_MOST(surface(image(i, j), hint), rounding);
      if(i == 0 || j == 0 || i + 1 == height || j + 1 == width)
        CHECK_AT_MOST(distance_to_border(image(i, j)), rounding);
    }

  const Mesh result = triangulated(image);
  CHECK_EQUAL(result.number_of_vertices(), width * height);
  CHECK(CGAL::is_valid_polygon_mesh(result));
  CHECK_LESS(3 * number_of_flips(result, surface), result.number_of_faces()); // few, where the image is coarse
  return image;
}

// Checks that there is no image, and why.
template <typename TriangleMesh>
void check_refused(const TriangleMesh& mesh, const std::string& why, std::size_t width = 9, std::size_t height = 9)
{
  Image image(width, height);
  const Image untouched = image;
  std::ostringstream errors;
  std::streambuf* buffer = std::cerr.rdbuf(errors.rdbuf());
  const bool silent = CGAL::make_geometry_image(mesh, image);
  const bool has_said_nothing = errors.str().empty();
  const bool verbose = CGAL::make_geometry_image(mesh, image, CGAL::parameters::verbose(true));
  std::cerr.rdbuf(buffer);
  CHECK(!silent);
  CHECK(!verbose);
  CHECK(has_said_nothing);
  check::check(errors.str().find(why) != std::string::npos, __FILE__, __LINE__, "the message says why", errors.str(), why);
  CHECK(are_identical(image, untouched));
}

Mesh without_face(Mesh mesh, Mesh::Face_index f)
{
  CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  mesh.collect_garbage();
  return mesh;
}

Mesh joined(Mesh a, const Mesh& b)
{
  a += b;
  return a;
}

const Mesh square =
  make_mesh(transformed(triangle_grid(8, 8, false, 0), [](const Point& p) { return Point(p.x() / 8, p.y() / 8, 2); }));

void test_images()
{
  start_topic("A square gives itself");
  Image image = check_image(square, 9, 5);
  for(std::size_t i = 0; i < 5; ++i)
    for(std::size_t j = 0; j < 9; ++j)
    {
      // up to a symmetry of the square
      const double x = image(i, j).x(), y = image(i, j).y();
      CHECK((std::abs(std::remainder(4 * x, 1)) < 1e-9 && std::abs(std::remainder(8 * y, 1)) < 1e-9) ||
            (std::abs(std::remainder(8 * x, 1)) < 1e-9 && std::abs(std::remainder(4 * y, 1)) < 1e-9));
    }

  start_topic("Models with a border");
  const Mesh lion = read_model("lion-head");
  check_image(lion, 33, 33);
  check_image(lion, 2, 2);
  check_image(lion, 3, 40);
  check_image(read_model("nefertiti"), 40, 20);
  Mesh bowl = make_mesh(icosphere(3)); // open in the place of a vertex
  const auto h = CGAL::Euler::remove_center_vertex(bowl.halfedge(Mesh::Vertex_index(20)), bowl);
  check_image(without_face(bowl, bowl.face(h)), 17, 17);

  start_topic("A mesh with isolated vertices, and one of another type");
  Mesh with_isolated_vertex = square;
  with_isolated_vertex.add_vertex(Point(0.5, 0.5, 7));
  check_image(square, 5, 5);
  Image of_isolated(9, 5);
  CHECK(CGAL::make_geometry_image(with_isolated_vertex, of_isolated));
  CHECK(are_identical(of_isolated, image));
  using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  const auto polyhedron = make_mesh<CGAL::Polyhedron_3<Exact_kernel>>(transformed(triangle_grid(4, 4), rotated));
  CGAL::Geometry_image<Exact_kernel::Point_3> exact(6, 6);
  CHECK(CGAL::make_geometry_image(polyhedron, exact));
}

void test_refused()
{
  start_topic("What is no disk");
  const Mesh sphere = make_mesh(icosphere(1));
  check_refused(Mesh(), "no faces");
  check_refused(sphere, "closed: cut it open");
  check_refused(make_mesh(cylinder(8, 4)), "2 borders");
  check_refused(joined(square, sphere), "components");
  check_refused(joined(square, square), "2 borders");
  check_refused(without_face(triangulated(torus(9, 9, 2, 0.5)), Mesh::Face_index(3)), "handle");

  start_topic("Bad meshes and images");
  Mesh bad = square;
  bad.point(Mesh::Vertex_index(7)) = Point(0, std::numeric_limits<double>::quiet_NaN(), 0);
  check_refused(bad, "finite");
  Mesh quads = square;
  CGAL::Euler::join_face(quads.halfedge(Mesh::Edge_index(20)), quads);
  check_refused(quads, "triangles");
  check_refused(square, "rows or columns", 0, 0);
  check_refused(square, "rows or columns", 1, 9);
  check_refused(square, "rows or columns", 9, 1);
  check_refused(make_mesh(Soup{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } } }), "border");

  start_topic("Faces without an area");
  for(int k = 1; k < 30; ++k)
  {
    Mesh flat_faces = square;
    const Mesh::Halfedge_index h(k);
    flat_faces.point(flat_faces.target(h)) = flat_faces.point(flat_faces.source(h));
    check_refused(flat_faces, "without an area");
  }
}

int main()
{
  test_images();
  test_refused();
  return test_result();
}
