// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_REMESHES_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_REMESHES_H

#include "check.h"
#include "Distance_to_mesh.h"
#include "mesh_quality.h"
#include "read_model.h"
#include "test_meshes.h"

#include <CGAL/bounding_box.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Remeshes of real models, and what must not get worse with them.

inline double longest_side(const Mesh& mesh)
{
  const auto box = CGAL::bounding_box(mesh.points().begin(), mesh.points().end());
  return (std::max)({ box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin() });
}

// `length` is relative to the longest side of the bounding box
inline Mesh make_remesh(Mesh mesh, double length)
{
  const double target_edge_length = length * longest_side(mesh);
  CGAL::Polygon_mesh_processing::isotropic_remeshing(
    faces(mesh), target_edge_length, mesh, CGAL::parameters::number_of_iterations(10).number_of_relaxation_steps(3));
  mesh.collect_garbage();
  return mesh;
}

using Face_pairs = std::set<std::pair<Mesh::Face_index, Mesh::Face_index>>;

inline Face_pairs self_intersections_of(const Mesh& mesh)
{
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
  Face_pairs sorted;
  for(const auto& pair : pairs)
    sorted.insert(std::minmax(pair.first, pair.second));
  return sorted;
}

// the faces that are turned away from the surface at their barycenters
inline std::size_t number_of_flips(const Mesh& mesh, const Distance_to_mesh& surface)
{
  std::size_t flips = 0;
  for(Mesh::Face_index f : mesh.faces())
  {
    const auto t = corners(mesh, f);
    const Mesh::Face_index nearest = surface.closest_face(CGAL::centroid(t[0], t[1], t[2]));
    flips += area_vector(t) * area_vector(corners(surface.mesh(), nearest)) < 0;
  }
  return flips;
}

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_REMESHES_H
