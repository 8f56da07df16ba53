// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Calls that must not compile, each with what the compiler says.

#include <CGAL/Polygon_mesh_processing/approximation_error.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Polygon_mesh_processing/PN_triangle_surface.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::parameters;

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Edge_map = Mesh::Property_map<Mesh::Edge_index, bool>;

struct Surface_without_normals
{
  using Point_3 = Point;
  struct Foot
  {};
  Foot project(const Point&) const;
  Foot project(const Point&, const Foot&) const;
  Point point(const Foot&) const;
};

void optimize_wrongly(Mesh& mesh, const Mesh& input)
{
  // says: sharpness_angle is about the reference: give it in np2
  PMP::optimize_vertex_locations(mesh, input, params::number_of_iterations(3).sharpness_angle(30));

  // says: placement_method is not about the reference: give it in np1
  PMP::optimize_vertex_locations(mesh, input, params::number_of_iterations(3), params::placement_method(PMP::LEAST_SQUARES));

  // says: edge_is_constrained_map comes too late for a surface that is ready
  PMP::optimize_vertex_locations(mesh, PMP::PN_triangle_surface<Mesh>(input), params::default_values(),
                                 params::edge_is_constrained_map(Edge_map()));

  // says: must have Vector_3 normal
  PMP::optimize_vertex_locations(mesh, Surface_without_normals());

  // says: neither a mesh, that is, a model of FaceListGraph, nor a model of ReferenceSurface
  PMP::approximation_error(mesh, 3);

  // says: The mesh is const
  PMP::optimize_vertex_locations(input, input);

  // says: The keys of a property map are not the vertices or edges of the mesh
  PMP::optimize_vertex_locations(mesh, input, params::vertex_is_constrained_map(Edge_map()).number_of_iterations(1));

  // says: The visitor must be a model of VertexLocationOptimizationVisitor
  PMP::optimize_vertex_locations(mesh, input, params::visitor(3));

  // says: allow_move_functor must be callable
  PMP::optimize_vertex_locations(mesh, input, params::allow_move_functor([](int) { return true; }));
}
