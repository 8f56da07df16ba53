// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What a call needs of the heap: 450 bytes a vertex of the remesh with the piecewise linear method, and 1800 with the least
// squares fit, which has five times the samples; and what a reference surface keeps: 270 bytes a triangle if it is flat, 640
// if it is curved, up to 30 of which are room for more in CGAL's AABB tree. And a tenth more where the allocator rounds up.

#include "check.h"
#include "heap_use.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Polygon_mesh_processing/PN_triangle_surface.h>

namespace PMP = CGAL::Polygon_mesh_processing;

void test_memory(const std::string& name, PMP::Placement_method method, double most_bytes)
{
  start_topic(name);
  Mesh mesh = make_mesh(transformed(icosphere(5), rotated));
  const PMP::PN_triangle_surface<Mesh> reference(make_mesh(icosphere(4)));
  const std::vector<Point> before = points_of(mesh);
  Heap_use::start_counting();
  PMP::optimize_vertex_locations(mesh, reference, CGAL::parameters::placement_method(method));
  Heap_use::stop_counting();
  CHECK(points_of(mesh) != before);
  if(!Heap_use::is_known())
  {
    std::cout << "not measured, since this system does not tell the size of what is allocated\n";
    return;
  }
  const double bytes = Heap_use::peak() / static_cast<double>(mesh.number_of_vertices());
  std::cout << bytes << " bytes a vertex\n";
  CHECK_LESS(0, bytes);
  CHECK_LESS(bytes, most_bytes);
}

template <typename Surface>
void test_surface(const std::string& name, double most_bytes)
{
  start_topic(name);
  const Mesh mesh = make_mesh(icosphere(5));
  Heap_use::start_counting();
  const Surface surface(mesh);
  Heap_use::stop_counting();
  if(!Heap_use::is_known())
    return;
  const double bytes = Heap_use::live() / static_cast<double>(mesh.number_of_faces());
  std::cout << bytes << " bytes a triangle\n";
  CHECK_LESS(0, bytes);
  CHECK_LESS(bytes, most_bytes);
}

int main()
{
  test_memory("piecewise linear", PMP::PIECEWISE_LINEAR, 1.1 * 450);
  test_memory("least squares", PMP::LEAST_SQUARES, 1.1 * 1800);
  test_surface<PMP::Flat_triangle_surface<Mesh>>("flat surface", 1.1 * 191);
  test_surface<PMP::PN_triangle_surface<Mesh>>("PN surface", 1.1 * 487);
  return test_result();
}
