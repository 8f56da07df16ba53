// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_NORMALS_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_NORMALS_H

#include "measures.h"
#include "tables.h"

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_normals.h>

#include <ostream>

inline void print_head_of_normals(std::ostream& out)
{
  out << "| model | faces of the remesh | faces | own vertex normals | sampled | optimized |\n|---|---|---|---|---|---|"
      << std::endl;
}

// The mean angle to the normals of the reference, in degrees: of the faces before and after the optimization, and of
// three kinds of vertex normals after it.
template <typename Surface>
void print_normals(std::ostream& out, const Model& model, const Mesh& remesh, const Surface& reference)
{
  Mesh mesh = optimize(remesh, reference, PIECEWISE_LINEAR);
  auto make_map = [&](const char* name) { return mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>(name).first; };
  const auto own = make_map("v:own"), sampled = make_map("v:sampled"), optimized = make_map("v:optimized");
  PMP::compute_vertex_normals(mesh, own);
  for(Mesh::Vertex_index v : mesh.vertices())
    put(sampled, v, reference.normal(reference.project(mesh.point(v))));
  PMP::optimize_vertex_normals<Concurrency_tag>(mesh, reference, optimized);

  out << "| " << model.name << " " << mesh.number_of_vertices() << " | "
      << to_text(PMP::normal_deviation<Concurrency_tag>(remesh, reference), 2) << " | "
      << to_text(PMP::normal_deviation<Concurrency_tag>(mesh, reference), 2);
  for(const auto& normals : { own, sampled, optimized })
    out << " | " << to_text(PMP::normal_deviation<Concurrency_tag>(mesh, reference, normals), 2);
  out << " |" << std::endl;
}

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_NORMALS_H
