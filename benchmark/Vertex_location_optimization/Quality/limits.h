// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_LIMITS_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_LIMITS_H

#include "measures.h"
#include "models.h"
#include "remeshers.h"
#include "simplify.h"
#include "tables.h"

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Sizing/compute_edge_lengths.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_mesh.h>

// the estimate of the curvatures that CGAL has since 6.0
#if __has_include(<CGAL/Polygon_mesh_processing/interpolated_corrected_curvatures.h>)
#define HAS_CORRECTED_CURVATURES
#include <CGAL/Polygon_mesh_processing/interpolated_corrected_curvatures.h>
#endif

#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>
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

// the flat input is the reference; `limit` is the one for the kind of mesh
inline void print_limits(std::ostream& out, const Model& model, const std::string& made_by, Mesh mesh, double Limits::*limit)
{
  const double unit = 1e-4 * longest_side(model.input);
  const PMP::Flat_triangle_surface<Mesh> reference(model.input);
  const auto mean_error = [&]() { return PMP::approximation_error<Concurrency_tag>(mesh, reference).mean / unit; };
  const double before = mean_error();
  PMP::optimize_vertex_locations<Concurrency_tag>(mesh, reference, CGAL::parameters::placement_method(PMP::LEAST_SQUARES));
  const double after = mean_error();
  const Limits limits = limits_of(curvatures_of(model.input), mesh.number_of_vertices());
  out << "| " << model.name << " | " << made_by << " | " << mesh.number_of_vertices() << " | " << to_text(before, 2) << " | "
      << to_text(after, 2);
  for(double value : { limits.uniform, limits.adaptive, limits.anisotropic })
    out << " | " << to_text(value / unit, 2);
  out << " | " << to_text(before * unit / (limits.*limit), 2) << " | " << to_text(after * unit / (limits.*limit), 2) << " |"
      << std::endl;
}

// How near to the limits least squares comes: of remeshes to that of equilateral triangles of one size, of simplified
// meshes that of the best triangles.
inline void print_table_of_limits(std::ostream& out)
{
  constexpr std::size_t number_of_vertices = 2000; // of the simplified meshes
  out
    << "| model | made by | vertices | mean before | least squares | limit: uniform | adaptive | anisotropic | before over "
       "limit | least squares over limit |\n|---|---|---|---|---|---|---|---|---|---|\n";
  std::vector<Model> models{ { "sphere", make_sphere(6), 0.062 } };
  for(const auto& [name, edge_length] : std::vector<std::pair<std::string, double>>{ { "knot1", 0.04 },
                                                                                     { "refined_elephant", 0.025 },
                                                                                     { "bunny00", 0.02 },
                                                                                     { "ChineseDragon-10kv", 0.025 },
                                                                                     { "armadillo", 0.012 } })
    if(Mesh input = read_model(data_file(name)); !input.is_empty())
      models.push_back({ name, std::move(input), edge_length });
  for(const Model& model : models)
  {
    print_limits(out, model, "isotropic remeshing", remesh_isotropically(model), &Limits::uniform);
    print_limits(out, model, "Garland-Heckbert", simplify_Garland_Heckbert(model.input, number_of_vertices),
                 &Limits::anisotropic);
    print_limits(out, model, "Lindstrom-Turk", simplify_Lindstrom_Turk(model.input, number_of_vertices),
                 &Limits::anisotropic);
  }
  out << "\n";
}

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_LIMITS_H
