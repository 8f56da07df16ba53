// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Maps of the attributes of a mesh.

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_ADD_ATTRIBUTES_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_ADD_ATTRIBUTES_H

#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/PN_triangle_surface.h>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::parameters;

using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;
using Face = Mesh::Face_index;
using Surface = PMP::PN_triangle_surface<Mesh>;
using Flat_surface = PMP::Flat_triangle_surface<Mesh>;
using Point_2 = Kernel::Point_2;
template <typename T>
using Vertex_map = Mesh::Property_map<Vertex, T>;
template <typename T>
using Corner_map = Mesh::Property_map<Halfedge, T>;
template <typename T>
using Face_map = Mesh::Property_map<Face, T>;

// adds a map without a name
template <typename T>
Vertex_map<T> add_vertex_map(Mesh& mesh)
{
  return mesh.add_property_map<Vertex, T>().first;
}
template <typename T>
Corner_map<T> add_corner_map(Mesh& mesh)
{
  return mesh.add_property_map<Halfedge, T>().first;
}
template <typename T>
Face_map<T> add_face_map(Mesh& mesh)
{
  return mesh.add_property_map<Face, T>().first;
}

// adds a map of the values f(p) at the points p of the vertices
template <typename F>
auto add_map_of(Mesh& mesh, const F& f)
{
  auto map = add_vertex_map<decltype(f(Point()))>(mesh);
  for(Vertex v : mesh.vertices())
    map[v] = f(mesh.point(v));
  return map;
}

inline double wave(const Point& p) { return std::sin(3 * p.x()) * std::cos(2.5 * p.y()) + std::sin(3.5 * p.z()); }

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_ADD_ATTRIBUTES_H
