// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_MESHES_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_MESHES_H

#include "clocks.h"

#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Polygon_mesh_processing/PN_triangle_surface.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/subdivision_method_3.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Surface = PMP::PN_triangle_surface<Mesh>;

constexpr PMP::Placement_method placement_methods[] = { PMP::PIECEWISE_LINEAR, PMP::LEAST_SQUARES };

inline const char* name_of(PMP::Placement_method method)
{
  return method == PMP::PIECEWISE_LINEAR ? "piecewise linear" : "least squares";
}

inline Mesh subdivided(Mesh mesh, unsigned int number_of_iterations)
{
  if(number_of_iterations > 0)
    CGAL::Subdivision_method_3::Sqrt3_subdivision(mesh, CGAL::parameters::number_of_iterations(number_of_iterations));
  return mesh;
}

inline Mesh loop_subdivided(Mesh mesh)
{
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(1));
  return mesh;
}

// The target edge length, relative to the longest side, that gives a remesh of the armadillo about so many vertices.
inline double edge_length_for(double number_of_vertices) { return 0.0106 * std::sqrt(20000 / number_of_vertices); }

// `edge_length` is relative to the longest side of the bounding box
inline Mesh remeshed(Mesh mesh, double edge_length, double* seconds = nullptr)
{
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  const double side = (std::max)({ box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin() });
  const double time = thread_time_of([&] {
    PMP::isotropic_remeshing(faces(mesh), edge_length * side, mesh,
                             CGAL::parameters::number_of_iterations(10).number_of_relaxation_steps(3));
  });
  mesh.collect_garbage();
  if(seconds != nullptr)
    *seconds = time;
  return mesh;
}

// The samples of the first iteration, in the order of the mesh.
inline std::vector<Point> vertices_and_midpoints(const Mesh& mesh)
{
  std::vector<Point> points;
  points.reserve(mesh.number_of_vertices() + mesh.number_of_edges());
  for(Mesh::Vertex_index v : mesh.vertices())
    points.push_back(mesh.point(v));
  for(Mesh::Edge_index e : mesh.edges())
    points.push_back(CGAL::midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return points;
}

// Optimizes a copy, and returns the time of the call alone.
inline double time_of_optimization(Mesh mesh, const Surface& surface, PMP::Placement_method method)
{
  return thread_time_of([&] { PMP::optimize_vertex_locations(mesh, surface, CGAL::parameters::placement_method(method)); });
}

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_MESHES_H
