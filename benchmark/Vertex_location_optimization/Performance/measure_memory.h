// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_MEASURE_MEMORY_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_MEASURE_MEMORY_H

#include "heap_use.h"
#include "meshes.h"
#include "Table.h"

#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>

#include <cstdio>
#include <fstream>
#include <string>

template <typename ReferenceSurface>
void add_surface_memory(Table& table, const std::string& name, const Mesh& reference)
{
  Heap_use::start_counting();
  const ReferenceSurface surface(reference);
  Heap_use::stop_counting();
  const double n = static_cast<double>(reference.number_of_faces());
  table.add_row(name, { n, Heap_use::live() / n, Heap_use::peak() / n });
}

// Bytes a vertex of the remesh above the reference surface, and bytes a triangle of a reference surface.
inline void measure_memory(std::ofstream& csv, const Mesh& reference, const Mesh& mesh)
{
  if(!Heap_use::is_known())
  {
    std::printf("\nmemory: not measured, since this system does not tell the size of what is allocated\n");
    return;
  }

  {
    Table table(csv, "memory: bytes a triangle of a reference surface with its tree", { "triangles", "kept", "peak" });
    add_surface_memory<PMP::Flat_triangle_surface<Mesh>>(table, "flat surface", reference);
    add_surface_memory<Surface>(table, "PN surface", reference);
  }

  Table table(csv, "memory: bytes a vertex of the remesh, the reference apart", { "vertices", "peak" });
  const Surface surface(reference);
  for(PMP::Placement_method method : placement_methods)
  {
    Mesh copy = mesh;
    Heap_use::start_counting();
    PMP::optimize_vertex_locations(copy, surface, CGAL::parameters::placement_method(method));
    Heap_use::stop_counting();
    const double n = static_cast<double>(mesh.number_of_vertices());
    table.add_row(name_of(method), { n, Heap_use::peak() / n });
  }
}

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_MEASURE_MEMORY_H
