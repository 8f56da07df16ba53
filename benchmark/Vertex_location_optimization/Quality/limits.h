// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_LIMITS_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_LIMITS_H

#include "models.h"

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Sizing/compute_edge_lengths.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_mesh.h>

// the estimate of the curvatures that CGAL has since 6.0
#if __has_include(<CGAL/Polygon_mesh_processing/interpolated_corrected_curvatures.h>)
#define HAS_CORRECTED_CURVATURES
#include <CGAL/Polygon_mesh_processing/interpolated_corrected_curvatures.h>
#endif

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// Principal curvatures, and the area where they are these.
struct Curved_area
{
  double k1, k2; // |k1| >= |k2|
  double area;
};

#ifdef HAS_CORRECTED_CURVATURES
inline std::vector<Curved_area> curvatures_of(Mesh mesh)
{
  using Principal = PMP::Principal_curvatures_and_directions<Kernel>;
  const auto map = mesh.add_property_map<Mesh::Vertex_index, Principal>("v:curvatures").first;
  PMP::interpolated_corrected_curvatures(mesh, CGAL::parameters::vertex_principal_curvatures_and_directions_map(map));
  std::vector<Curved_area> result;
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    double area = 0;
    for(Mesh::Face_index f : CGAL::faces_around_target(mesh.halfedge(v), mesh))
      area += f != Mesh::null_face() ? PMP::face_area(f, mesh) / 3 : 0;
    double k1 = map[v].max_curvature, k2 = map[v].min_curvature;
    if(std::abs(k1) < std::abs(k2))
      std::swap(k1, k2);
    result.push_back({ k1, k2, area });
  }
  return result;
}
#else
inline std::vector<Curved_area> curvatures_of(const Mesh& mesh)
{
  using namespace PMP::internal::vertex_location;
  Mesh_arrays arrays;
  Mesh_descriptors<Mesh> descriptors;
  read_mesh(mesh, mesh.points(), arrays, descriptors);
  std::vector<Vector> normals;
  for(std::size_t f = 0; f < arrays.number_of_faces(); ++f)
    normals.push_back(normalized(arrays.area_normal(f)));
  const std::vector<char> has_no_creases(arrays.edges.size(), false);
  std::vector<Curved_area> result;
  for(const Curvatures& c : compute_face_curvatures<Concurrency_tag>(arrays, normals, has_no_creases))
    result.push_back({ c.k1, c.k2, arrays.area(result.size()) });
  return result;
}
#endif

// The least mean distances that piecewise linear surfaces with so many vertices can have from a smooth surface.
struct Limits
{
  double uniform, adaptive; // of equilateral triangles of one size, and of the best sizes
  double anisotropic;       // of triangles of the best shapes and sizes
};

inline Limits limits_of(const std::vector<Curved_area>& curvatures, std::size_t number_of_vertices)
{
  constexpr double convex = 0.0564, saddle = 1. / 12; // of a triangle of the best shape, for area 1 and curvatures 1
  double total_area = 0, uniform = 0, adaptive = 0, anisotropic = 0;
  for(const auto& [k1, k2, area] : curvatures)
  {
    const double ratio = k1 != 0 ? k2 / k1 : 0;
    const double isotropic = convex * PMP::internal::vertex_location::relative_mean_error(ratio) * std::abs(k1);
    total_area += area;
    uniform += area * isotropic;
    adaptive += area * std::sqrt(isotropic);
    anisotropic += area * std::sqrt((ratio > 0 ? convex : saddle) * std::sqrt(std::abs(k1 * k2)));
  }
  const double number_of_faces = 2. * number_of_vertices;
  return { uniform / number_of_faces, adaptive * adaptive / (number_of_faces * total_area),
           anisotropic * anisotropic / (number_of_faces * total_area) };
}

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_LIMITS_H
