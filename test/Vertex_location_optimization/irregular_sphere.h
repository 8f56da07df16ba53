// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_IRREGULAR_SPHERE_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_IRREGULAR_SPHERE_H

#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>

#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::parameters;
using Report = PMP::Vertex_location_optimization_report;
using Vertex = Mesh::Vertex_index;

// A sphere, or a part of it, as remesh and a finer one as reference. The remesh is irregular: its vertices have been
// moved along the sphere.
struct Input
{
  Mesh mesh = make_mesh(transformed(icosphere(2), [random = CGAL::Random(5)](const Point& p) mutable {
    auto moved = [&](double x) { return x + random.get_double(-.05, .05); };
    return CGAL::ORIGIN + unit(Vector(moved(p.x()), moved(p.y()), moved(p.z())));
  }));
  Mesh reference = make_mesh(icosphere(3));
};

// the points of an optimized mesh
template <typename Reference, typename NP1, typename NP2 = parameters::Default_named_parameters>
std::vector<Point>
optimized(Mesh mesh, const Reference& reference, const NP1& np1, const NP2& np2 = parameters::default_values())
{
  PMP::optimize_vertex_locations(mesh, reference, np1, np2);
  return points_of(mesh);
}

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_IRREGULAR_SPHERE_H
