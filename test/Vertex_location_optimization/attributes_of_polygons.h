// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_ATTRIBUTES_OF_POLYGONS_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_ATTRIBUTES_OF_POLYGONS_H

// Attributes of meshes with polygons, and references with polygons.

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

// what is linear in the plane is met exactly, seams and labels too
inline void test_attributes()
{
  start_topic("Attributes of polygons");
  Mesh reference = make_mesh(square_grid(24, 24)); // the seam and the border of the labels lie on its edges
  const auto on_right = [](const Mesh& m, Halfedge h) {
    double x = 0;
    for(const Vertex v : vertices_around_face(h, m))
      x += m.point(v).x() / m.degree(m.face(h));
    return x > 12;
  };
  const auto value_at = [](const Point& p, bool is_right) { return 3 * p.x() - p.y() + (is_right ? 50 : 0); };
  const auto values = reference.add_property_map<Halfedge, double>("h:value").first;
  const auto labels = reference.add_property_map<Face, bool>("f:label").first;
  for(const Halfedge h : reference.halfedges())
    if(!reference.is_border(h))
    {
      values[h] = value_at(reference.point(reference.target(h)), on_right(reference, h));
      labels[reference.face(h)] = on_right(reference, h);
    }

  Mesh mesh = make_mesh(transformed(square_grid(8, 6), [](const Point& p) { return Point(3 * p.x(), 4 * p.y(), 0); }));
  CGAL::Euler::join_face(mesh.halfedge(Vertex(11), Vertex(20)), mesh);
  const auto result = mesh.add_property_map<Halfedge, double>("h:value", -1).first;
  const auto result_labels = mesh.add_property_map<Face, bool>("f:label").first;
  PMP::optimize_vertex_attributes(mesh, reference, values, result);
  PMP::transfer_face_attributes(mesh, reference, labels, result_labels);
  for(const Halfedge h : mesh.halfedges())
    if(!mesh.is_border(h))
    {
      CHECK_NEAR(result[h], value_at(mesh.point(mesh.target(h)), on_right(mesh, h)), 1e-7);
      CHECK_EQUAL(result_labels[mesh.face(h)], on_right(mesh, h));
    }
  CHECK_NEAR(PMP::attribute_error(mesh, reference, values, result).max, 0, 1e-7);

  const auto normals = mesh.add_property_map<Vertex, Vector>("v:normal").first;
  PMP::optimize_vertex_normals(mesh, reference, normals);
  for(const Vertex v : mesh.vertices())
    CHECK_NEAR(norm(normals[v] - Vector(0, 0, 1)), 0, 1e-12);

  // normals of a sphere, without seams, are radial
  Mesh hexagons = dual_icosphere(2);
  const auto radial = hexagons.add_property_map<Halfedge, Vector>("h:normal").first;
  PMP::optimize_vertex_normals(hexagons, Exact_sphere(CGAL::ORIGIN, 1), radial);
  for(const Halfedge h : hexagons.halfedges())
    CHECK_NEAR(norm(radial[h] - (hexagons.point(hexagons.target(h)) - CGAL::ORIGIN)), 0, 0.01);
}

// A reference with polygons is what its triangulation is, as exactly as the faces are planar: where they are not that of
// CGAL 6 depends on the order of the faces if these have more than four corners.
inline void check_triangulation(Mesh polygons, const double tolerance)
{
  const PMP::Flat_triangle_surface<Mesh> surface(polygons);
  for(const Face f : polygons.faces()) // that of quads may depend on their halfedges
  {
    const auto around = halfedges_around_face(polygons.halfedge(f), polygons);
    polygons.set_halfedge(f, *std::min_element(around.begin(), around.end(), [&](Halfedge a, Halfedge b) {
                            return polygons.target(a) < polygons.target(b);
                          }));
  }
  PMP::triangulate_faces(polygons);
  const PMP::Flat_triangle_surface<Mesh> expected(polygons);
  const Mesh queries = make_mesh(transformed(icosphere(3), rotated));
  for(const Point& p : queries.points())
    CHECK_NEAR(norm(surface.point(surface.project(p)) - expected.point(expected.project(p))), 0, tolerance);
}

// The maps of a reference with polygons keep their meaning.
inline void test_references()
{
  start_topic("References with polygons");
  check_triangulation(make_mesh(cube_sphere(6)), 1e-9);
  check_triangulation(dual_icosphere(2), 2e-3);
  Polygon_soup star;
  star.polygons.emplace_back();
  for(std::size_t i = 0; i < 14; ++i)
  {
    const double radius = i % 2 == 0 ? 1 : 0.4, angle = CGAL_PI * i / 7;
    star.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    star.polygons[0].push_back(i);
  }
  check_triangulation(make_mesh(transformed(star, rigid_motion)), 1e-9);

  Mesh polygons = dual_icosphere(2);
  const Halfedge g = polygons.next(polygons.halfedge(Face(40))), h = polygons.next(g);
  CGAL::Euler::split_face(polygons.prev(g), h, polygons); // cuts off the triangle between g and h
  const PMP::Flat_triangle_surface<Mesh> surface(polygons);

  // a location in a face that is a triangle
  const Point q = CGAL::centroid(polygons.point(polygons.source(g)), polygons.point(polygons.target(g)),
                                 polygons.point(polygons.target(h)));
  if(CHECK(CGAL::is_triangle(g, polygons)))
  {
    const auto location = surface.location(surface.project(q));
    CHECK_EQUAL(location.first, polygons.face(g));
    CHECK_NEAR(norm(PMP::construct_point(location, polygons) - q), 0, 1e-12);
  }

  // creases of a cube whose sides are squares: all that are found are edges of the mesh, and maps of these are obeyed
  Mesh cube;
  CGAL::make_hexahedron(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), Point(0, 1, 1), Point(0, 0, 1),
                        Point(1, 0, 1), Point(1, 1, 1), cube);
  const auto is_crease = cube.add_property_map<Mesh::Edge_index, bool>("e:crease", true).first;
  for(const Point& p : { Point(0.3, 0.4, 1.2), Point(1.5, 0.9, 0.1) })
  {
    const PMP::PN_triangle_surface<Mesh> detected(cube), constrained(cube, params::edge_is_constrained_map(is_crease));
    const Point foot((std::min)(1., p.x()), p.y(), (std::min)(1., p.z()));
    CHECK_NEAR(norm(detected.point(detected.project(p)) - foot), 0, 1e-12);
    CHECK_NEAR(norm(constrained.point(constrained.project(p)) - foot), 0, 1e-12);
  }
}

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_ATTRIBUTES_OF_POLYGONS_H
