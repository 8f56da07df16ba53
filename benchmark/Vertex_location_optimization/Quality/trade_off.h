// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_TRADE_OFF_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_TRADE_OFF_H

#include "measures.h"
#include "models.h"
#include "remeshers.h"
#include "tables.h"

#include <fstream>
#include <ostream>
#include <string>

// What `regularity_weight` trades: the errors of `LEAST_SQUARES` for the angles, on a remesh of the model.
inline void make_trade_off(const Model& model, std::ostream& out)
{
  const PMP::PN_triangle_surface<Mesh> reference(model.input);
  const Mesh remesh = remesh_isotropically(model);
  out << "Regularity weights: " << model.name << ", " << remesh.number_of_vertices() << " vertices\n\n"
      << "| weight | mean | maximum | mean back | maximum back | angle | smallest angle | intersections |\n"
      << "|---|---|---|---|---|---|---|---|\n";
  auto print = [&](const std::string& name, const Measures& m) {
    out << "| " << name << " | " << to_text(m.mean, 2) << " | " << to_text(m.max, 0) << " | " << to_text(m.mean_back, 2)
        << " | " << to_text(m.max_back, 0) << " | " << to_text(m.mean_angle, 1) << " | " << to_text(m.smallest_angle, 1)
        << " | " << m.intersections << " |" << std::endl;
  };

  print("(remesh)", measure(remesh, model, reference, 0));
  std::ofstream csv("trade_off_" + model.name + ".csv");
  csv << "regularity_weight,mean error (1e-4),60 - angle (degrees)\n";
  for(double weight : { 0.0125, 0.025, 0.05, 0.1, 0.2, 0.4, 0.8, 1.6 })
  {
    Mesh mesh = remesh;
    PMP::optimize_vertex_locations(mesh, reference,
                                   CGAL::parameters::placement_method(PMP::LEAST_SQUARES).regularity_weight(weight));
    const Measures measures = measure(mesh, model, reference, 0);
    print(to_text(weight, 4), measures);
    csv << weight << ',' << measures.mean << ',' << 60 - measures.mean_angle << '\n';
  }
  print("(piecewise linear)", measure(optimize(remesh, reference, PIECEWISE_LINEAR), model, reference, 0));
  out << "\n";
}

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_TRADE_OFF_H
