// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_TABLE_OF_LIMITS_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_TABLE_OF_LIMITS_H

#include "limits.h"
#include "measures.h"
#include "models.h"
#include "remeshers.h"
#include "simplify.h"
#include "tables.h"

#include <cstddef>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

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

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_TABLE_OF_LIMITS_H
