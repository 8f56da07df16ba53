// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the optimization must reach after isotropic_remeshing() on real models.

#include "check.h"
#include "check_equivariance.h"
#include "Distance_to_mesh.h"
#include "Independent_PN_mesh.h"
#include "mesh_quality.h"
#include "remeshes.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>

namespace PMP = CGAL::Polygon_mesh_processing;

// `surface` is what the errors are measured against; `reduction` is that of the mean error
void test_model(const std::string& name, const Mesh& input, const Distance_to_mesh& surface, double length, double reduction)
{
  start_topic(name);
  const Mesh remesh = make_remesh(input, length);
  Mesh mesh = remesh;
  PMP::optimize_vertex_locations(mesh, input);

  auto errors_of = [&, hint = input.point(*input.vertices().begin())](const Mesh& m) mutable
  {
    return measure_errors(m, 4, [&](const Point& p) { return surface(p, hint); });
  };
  const double unit_length = 1e-4 * longest_side(input);
  const Errors before = errors_of(remesh), after = errors_of(mesh);
  std::cout << "  " << mesh.number_of_vertices() << " vertices, mean error " << before.mean / unit_length << " -> "
            << after.mean / unit_length << " (" << 100 * (1 - after.mean / before.mean) << "%), max "
            << before.max / unit_length << " -> " << after.max / unit_length << ", angle " << mean_min_angle(remesh)
            << " -> " << mean_min_angle(mesh) << std::endl;

  CHECK_AT_LEAST(1 - after.mean / before.mean, reduction);
  CHECK_AT_MOST(after.max, before.max);
  CHECK_AT_MOST(number_of_flips(mesh, surface), number_of_flips(remesh, surface));
  CHECK_AT_MOST(self_intersections_of(mesh).size(), self_intersections_of(remesh).size() + 3);
  CHECK_AT_LEAST(mean_min_angle(mesh), mean_min_angle(remesh) - 4);
}

void test_data(const std::string& name, double length, double reduction)
{
  const Mesh input = read_model(name);
  double tolerance;
  const Distance_to_mesh surface(Independent_PN_mesh(input, 45).tessellate(3, tolerance));
  test_model(name, input, surface, length, reduction);
}

int main()
{
  const Mesh sphere = make_mesh(icosphere(6));
  test_model("sphere", sphere, Distance_to_mesh(sphere), 0.062, 0.79);
  test_data("knot1", 0.04, 0.74);
  test_data("hand", 0.05, 0.66);
  test_data("refined_elephant", 0.025, 0.50);
  test_data("bunny00", 0.02, 0.57);
  test_data("armadillo", 0.012, 0.50);

  start_topic("The optimized knot scales and moves with the input");
  const Mesh knot = read_model("knot1");
  check_equivariance(make_remesh(knot, 0.04), knot);
  return test_result();
}
