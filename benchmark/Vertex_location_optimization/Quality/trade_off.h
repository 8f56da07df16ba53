// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_TRADE_OFF_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_TRADE_OFF_H

#include "../Log_log_plot.h"
#include "measures.h"
#include "models.h"
#include "remeshers.h"
#include "tables.h"

#include <fstream>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

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
  std::vector<std::pair<double, double>> errors, angles;
  for(double weight : { 0.0125, 0.025, 0.05, 0.1, 0.2, 0.4, 0.8, 1.6 })
  {
    Mesh mesh = remesh;
    PMP::optimize_vertex_locations(mesh, reference,
                                   CGAL::parameters::placement_method(PMP::LEAST_SQUARES).regularity_weight(weight));
    const Measures measures = measure(mesh, model, reference, 0);
    print(to_text(weight, 4), measures);
    errors.emplace_back(weight, measures.mean);
    angles.emplace_back(weight, 60 - measures.mean_angle);
  }
  print("(piecewise linear)", measure(optimize(remesh, reference, PIECEWISE_LINEAR), model, reference, 0));
  out << "\n";

  Log_log_plot plot(model.name, "regularity_weight", "");
  plot.add_curve("mean error (1e-4)", "#008000", errors);
  plot.add_curve("60 - angle (degrees)", "#0050c0", angles);
  std::ofstream file("trade_off_" + model.name + ".svg");
  write_svg(file, { plot });
}

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_TRADE_OFF_H
