// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_SIMPLIFY_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_SIMPLIFY_H

#include "models.h"

#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/version.h>
#if CGAL_VERSION_MAJOR >= 6
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_count_stop_predicate.h>
#else
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#endif

#include <cstddef>

// a closed mesh has three edges a vertex, about
inline auto stop_at(std::size_t number_of_vertices)
{
#if CGAL_VERSION_MAJOR >= 6
  return CGAL::Surface_mesh_simplification::Edge_count_stop_predicate<Mesh>(3 * number_of_vertices);
#else
  return CGAL::Surface_mesh_simplification::Count_stop_predicate<Mesh>(3 * number_of_vertices);
#endif
}

inline Mesh simplify_Garland_Heckbert(Mesh mesh, std::size_t number_of_vertices)
{
  namespace SMS = CGAL::Surface_mesh_simplification;
  const SMS::GarlandHeckbert_plane_policies<Mesh, Kernel> policies(mesh);
  SMS::edge_collapse(mesh, stop_at(number_of_vertices),
                     CGAL::parameters::get_cost(policies.get_cost())
                       .get_placement(policies.get_placement())
                       .filter(SMS::Bounded_normal_change_filter<>()));
  mesh.collect_garbage();
  return mesh;
}

// CGAL's default
inline Mesh simplify_Lindstrom_Turk(Mesh mesh, std::size_t number_of_vertices)
{
  CGAL::Surface_mesh_simplification::edge_collapse(mesh, stop_at(number_of_vertices));
  mesh.collect_garbage();
  return mesh;
}

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_SIMPLIFY_H
