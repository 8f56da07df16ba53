// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_REMESHERS_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_REMESHERS_H

#include "models.h"

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/random_perturbation.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

// CGAL 6 has remeshers that CGAL 5 does not have; others stand in for them
#if __has_include(<CGAL/Polygon_mesh_processing/Adaptive_sizing_field.h>)
#define HAS_ADAPTIVE_SIZING_FIELD
#include <CGAL/Polygon_mesh_processing/Adaptive_sizing_field.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/approximated_centroidal_Voronoi_diagram_remeshing.h>)
#define HAS_ACVD
#include <CGAL/Polygon_mesh_processing/approximated_centroidal_Voronoi_diagram_remeshing.h>
#else
#include "lloyd_relaxation.h"
#endif

#include <algorithm>
#include <cstddef>
#include <utility>

using Crease_map = Mesh::Property_map<Mesh::Edge_index, bool>;

// the creases of a mesh, none unless they have been marked
inline Crease_map creases(Mesh& mesh) { return mesh.add_property_map<Mesh::Edge_index, bool>("e:is_crease", false).first; }

// triangles of one size, the more alike the more iterations
inline Mesh remesh_isotropically(const Model& model, unsigned int number_of_iterations = 10)
{
  Mesh mesh = model.input;
  if(model.crease_angle < 180)
    PMP::detect_sharp_edges(mesh, model.crease_angle, creases(mesh));
  PMP::isotropic_remeshing(faces(mesh), model.edge_length * longest_side(model.input), mesh,
                           CGAL::parameters::number_of_iterations(number_of_iterations)
                             .number_of_relaxation_steps(3)
                             .edge_is_constrained_map(creases(mesh)));
  mesh.collect_garbage();
  return mesh;
}

#ifdef HAS_ADAPTIVE_SIZING_FIELD
constexpr const char* adaptive_remesher = "adaptive";

// smaller triangles where the curvature is larger
inline Mesh remesh_adaptively(const Model& model)
{
  // the edge length is that of the model where the surface bends like a sphere of a fifth of the size
  const double side = longest_side(model.input), length = model.edge_length * side;
  const double tolerance = length * length / (0.6 * side);
  Mesh mesh = model.input;
  PMP::Adaptive_sizing_field<Mesh> sizing(tolerance, std::make_pair(length / 2, 2 * length), faces(mesh), mesh);
  PMP::isotropic_remeshing(faces(mesh), sizing, mesh,
                           CGAL::parameters::number_of_iterations(10).number_of_relaxation_steps(3));
  mesh.collect_garbage();
  return mesh;
}
#else
constexpr const char* adaptive_remesher = "feature-sensitive";

// keeps the sharpest edges
inline Mesh remesh_adaptively(Model model)
{
  model.crease_angle = 60;
  return remesh_isotropically(model);
}
#endif

// the dual of a centroidal Voronoi tessellation
template <typename Surface>
Mesh remesh_with_Voronoi_cells(const Model& model,
                               [[maybe_unused]] std::size_t number_of_vertices,
                               [[maybe_unused]] const Surface& surface)
{
#ifdef HAS_ACVD
  Mesh mesh = model.input;
  PMP::approximated_centroidal_Voronoi_diagram_remeshing(mesh, number_of_vertices);
#else
  Mesh mesh = remesh_isotropically(model);
  relax_with_Lloyd(mesh, model.input, surface);
#endif
  return mesh;
}

// the isotropic remesh made rough: each vertex is moved at random, and back to the surface
template <typename Surface>
Mesh remesh_roughly(const Model& model, const Surface& surface)
{
  Mesh mesh = remesh_isotropically(model);
  PMP::random_perturbation(vertices(mesh), mesh, model.edge_length * longest_side(model.input) / 4,
                           CGAL::parameters::do_project(false).random_seed(0));
  for(Point& p : mesh.points())
    p = surface.point(surface.project(p));
  return mesh;
}

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_REMESHERS_H
