// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A part of a mesh: the functions that take a range of faces.

#include "check.h"
#include "mesh_quality.h"
#include "polygon_meshes.h"

#include <CGAL/Polygon_mesh_processing/approximation_error.h>
#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::parameters;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Faces = std::vector<Face>;

constexpr PMP::Placement_method methods[]{ PMP::PIECEWISE_LINEAR, PMP::LEAST_SQUARES };

// the faces with a vertex where `is_inside(p)`
template <typename IsInside>
Faces select(const Mesh& mesh, const IsInside& is_inside)
{
  Faces faces;
  for(const Face f : mesh.faces())
  {
    const auto corners = vertices_around_face(mesh.halfedge(f), mesh);
    if(std::any_of(corners.begin(), corners.end(), [&](Vertex v) { return is_inside(mesh.point(v)); }))
      faces.push_back(f);
  }
  return faces;
}

// whether all faces at v are in a sorted range
bool is_inner(const Mesh& mesh, const Faces& faces, Vertex v)
{
  const auto around = faces_around_target(mesh.halfedge(v), mesh);
  return std::all_of(around.begin(), around.end(),
                     [&](Face f) { return f == Mesh::null_face() || std::binary_search(faces.begin(), faces.end(), f); });
}

// What is selected gets what it would get with the rest constrained, to `margin` times the largest displacement: lengths and
// weights that are relative to means over the mesh are relative to those over the range, and so are the tolerances of the
// samples. There are as many iterations of both, and no springs, so that nothing slides on. With least squares it is the
// error that is compared.
void check_like_constrained(const std::string& name, Mesh mesh, const Mesh& reference, const Faces& faces, double margin)
{
  const auto is_constrained = mesh.add_property_map<Vertex, bool>("v:is_constrained", false).first;
  for(const Vertex v : mesh.vertices())
    is_constrained[v] = !is_inner(mesh, faces, v);
  for(const PMP::Placement_method method : methods)
  {
    start_topic(name + ", method " + std::to_string(method));
    Mesh selected = mesh, constrained = mesh;
    const auto np = params::placement_method(method).convergence_threshold(0).number_of_relaxation_steps(0);
    PMP::optimize_vertex_locations<CGAL::Parallel_if_available_tag>(faces, selected, reference, np);
    PMP::optimize_vertex_locations<CGAL::Parallel_if_available_tag>(constrained, reference,
                                                                    np.vertex_is_constrained_map(is_constrained));
    double difference = 0, displacement = 0;
    for(const Vertex v : mesh.vertices())
      if(is_constrained[v])
        CHECK(selected.point(v) == mesh.point(v));
      else
      {
        difference = (std::max)(difference, norm(selected.point(v) - constrained.point(v)));
        displacement = (std::max)(displacement, norm(constrained.point(v) - mesh.point(v)));
      }
    CHECK_LESS(0, displacement);
    const double error_of_selected = PMP::approximation_error(faces, selected, reference).mean,
                 error_of_constrained = PMP::approximation_error(faces, constrained, reference).mean;
    if(method == PMP::PIECEWISE_LINEAR)
      CHECK_AT_MOST(difference, margin * displacement);
    else // its samples of the reference are spread anew, and vertices slide among them
      CHECK_NEAR(error_of_selected, error_of_constrained, 0.03 * error_of_constrained);
    CHECK_LESS(error_of_selected, PMP::approximation_error(faces, mesh, reference).mean);

    // the order of the range does not matter, nor what is there twice
    Faces shuffled = faces;
    std::reverse(shuffled.begin(), shuffled.end());
    shuffled.insert(shuffled.end(), faces.begin(), faces.begin() + 5);
    Mesh other = mesh;
    PMP::optimize_vertex_locations(shuffled, other, reference, np);
    CHECK(points_of(other) == points_of(selected));
  }
}

void test_whole_and_empty()
{
  start_topic("All faces, and none");
  const Mesh reference = make_mesh(icosphere(4)), mesh = make_mesh(transformed(icosphere(2), rotated));
  for(const PMP::Placement_method method : methods)
  {
    Mesh by_range = mesh, expected = mesh, untouched = mesh;
    PMP::optimize_vertex_locations(faces(mesh), by_range, reference, params::placement_method(method));
    PMP::optimize_vertex_locations(expected, reference, params::placement_method(method));
    CHECK(points_of(by_range) == points_of(expected));
    PMP::optimize_vertex_locations(Faces(), untouched, reference, params::placement_method(method));
    CHECK(points_of(untouched) == points_of(mesh));
  }
  const PMP::Approximation_error none = PMP::approximation_error(Faces(), mesh, reference);
  CHECK_EQUAL(none.mean, 0);
  CHECK_EQUAL(none.max, 0);
  CHECK_EQUAL(PMP::approximation_error(faces(mesh), mesh, reference).mean, PMP::approximation_error(mesh, reference).mean);
}

void test_errors()
{
  start_topic("Errors of a part");
  Mesh mesh = make_mesh(cube_sphere(5));
  const Mesh reference = make_mesh(transformed(icosphere(4), rotated));
  const Faces range = select(mesh, [](const Point& p) { return p.z() > 0.4; });
  const auto expected = mesh.add_property_map<Face, double>("f:expected", -1).first;
  const auto errors = mesh.add_property_map<Face, double>("f:error", -1).first;
  const auto vertex_errors = mesh.add_property_map<Vertex, double>("v:error", -1).first;
  // by default the samples of a face follow the precision of the mean over all
  PMP::approximation_error(mesh, reference, params::face_error_map(expected).number_of_points_per_face(64));
  const PMP::Approximation_error error = PMP::approximation_error(
    range, mesh, reference, params::face_error_map(errors).vertex_error_map(vertex_errors).number_of_points_per_face(64));
  double largest = 0, smallest = 1;
  for(const Face f : mesh.faces())
  {
    const bool is_in_range = std::binary_search(range.begin(), range.end(), f);
    CHECK_NEAR(errors[f], is_in_range ? expected[f] : -1, 1e-15);
    largest = (std::max)(largest, errors[f]);
    smallest = is_in_range ? (std::min)(smallest, errors[f]) : smallest;
  }
  CHECK_AT_LEAST(error.mean, smallest);
  CHECK_AT_MOST(error.mean, largest);
  for(const Vertex v : mesh.vertices())
  {
    const auto around = faces_around_target(mesh.halfedge(v), mesh);
    const bool is_in_range =
      std::any_of(around.begin(), around.end(), [&](Face f) { return std::binary_search(range.begin(), range.end(), f); });
    CHECK_EQUAL(vertex_errors[v] >= 0, is_in_range);
  }
}

// With relaxed constraints the border of the mesh moves, but not that of the range.
void test_borders()
{
  start_topic("Borders of the mesh and of the range");
  const Mesh reference = make_mesh(cylinder(240, 80)), mesh = make_mesh(cylinder(24, 8));
  const Faces range = select(mesh, [](const Point& p) { return p.x() > 0.2; });
  Mesh result = mesh;
  PMP::optimize_vertex_locations(range, result, reference, params::relax_constraints(true));
  int number_of_moves = 0;
  for(const Vertex v : mesh.vertices())
    if(!is_inner(mesh, range, v))
      CHECK(result.point(v) == mesh.point(v));
    else if(mesh.is_border(v))
      number_of_moves += result.point(v) != mesh.point(v);
  CHECK_AT_LEAST(number_of_moves, 10);
}

// A sheet that is drawn through another one, which is not in the range.
void test_self_intersections()
{
  const auto sheet = [](const auto& grid, double height, double bulge) {
    return make_mesh(transformed(grid, [=](const Point& p) {
      const double x = p.x() / 6 - 1, y = p.y() / 6 - 1;
      return Point(x, y, height + bulge * (1 - x * x) * (1 - y * y));
    }));
  };
  const Mesh reference = sheet(triangle_grid(12, 12), 0, 0.2);
  for(const bool has_quads : { false, true })
  {
    start_topic(std::string("The rest of a mesh of ") + (has_quads ? "quads" : "triangles") + " is not run through");
    Mesh mesh = has_quads ? sheet(square_grid(12, 12), 0, 0) : sheet(triangle_grid(12, 12), 0, 0);
    const Faces range(mesh.faces().begin(), mesh.faces().end());
    mesh += has_quads ? sheet(square_grid(12, 12), 0.05, 0) : sheet(triangle_grid(12, 12), 0.05, 0);
    for(const PMP::Placement_method method : methods)
      for(const bool is_tested : { false, true })
      {
        Mesh result = mesh;
        PMP::optimize_vertex_locations(range, result, reference,
                                       params::placement_method(method).do_self_intersection_tests(is_tested));
        CHECK(points_of(result) != points_of(mesh));
        PMP::triangulate_faces(result);
        CHECK_EQUAL(PMP::does_self_intersect(result), !is_tested);
      }
  }
}

int main()
{
  const auto flattened = [](const Point& p) { return Point(p.x(), p.y(), 0.15 * p.z()); };
  const Mesh sphere = make_mesh(icosphere(5)), disk = make_mesh(transformed(icosphere(5), flattened));
  const Mesh remesh = make_mesh(transformed(icosphere(3), rotated)),
             thin = make_mesh(transformed(transformed(icosphere(3), rotated), flattened)),
             quads = make_mesh(transformed(cube_sphere(10), rotated));
  check_like_constrained("A cap of a sphere", remesh, sphere, select(remesh, [](const Point& p) { return p.z() > 0.3; }),
                         0.02);
  check_like_constrained("One side of a thin body", thin, disk, select(thin, [](const Point& p) { return p.z() > 0.01; }),
                         0.1);
  check_like_constrained("Quads", quads, sphere, select(quads, [](const Point& p) { return p.x() > 0.3; }), 0.05);
  test_whole_and_empty();
  test_errors();
  test_borders();
  test_self_intersections();
  return test_result();
}
