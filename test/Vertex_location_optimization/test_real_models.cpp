// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the optimization must reach after isotropic_remeshing() on real models.

#include "check.h"
#include "check_equivariance.h"
#include "Distance_to_mesh.h"
#include "mesh_quality.h"
#include "remeshes.h"
#include "tessellate_patches.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Polygon_mesh_processing/PN_triangle_surface.h>

#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

// What a method must reach: by what part it must reduce the mean error, and by how many degrees, at most, the mean of the
// smallest angles may fall.
struct Goal
{
  PMP::Placement_method method;
  double reduction;
  double angle_loss = 4;
};

// `surface` is what the errors are measured against, as good as `reference`
template <typename Reference>
void test_model(const std::string& name,
                const Mesh& input,
                const Reference& reference,
                const Distance_to_mesh& surface,
                double length,
                const std::vector<Goal>& goals)
{
  const Mesh remesh = make_remesh(input, length);
  auto errors_of = [&, hint = input.point(*input.vertices().begin())](const Mesh& m) mutable {
    return measure_errors(m, 4, [&](const Point& p) { return surface(p, hint); });
  };
  const double unit_length = 1e-4 * longest_side(input);
  const Errors before = errors_of(remesh);
  for(const Goal& goal : goals)
  {
    const bool is_least_squares = goal.method == PMP::LEAST_SQUARES;
    start_topic(name + (is_least_squares ? ", least squares" : ", piecewise linear"));
    Mesh mesh = remesh;
    PMP::optimize_vertex_locations(mesh, reference, CGAL::parameters::placement_method(goal.method));

    const Errors after = errors_of(mesh);
    std::cout << "  " << mesh.number_of_vertices() << " vertices, mean error " << before.mean / unit_length << " -> "
              << after.mean / unit_length << " (" << 100 * (1 - after.mean / before.mean) << "%), max "
              << before.max / unit_length << " -> " << after.max / unit_length << ", angle " << mean_min_angle(remesh)
              << " -> " << mean_min_angle(mesh) << std::endl;

    CHECK_AT_LEAST(1 - after.mean / before.mean, goal.reduction);
    CHECK_AT_MOST(after.max, before.max);
    CHECK_AT_MOST(number_of_flips(mesh, surface), number_of_flips(remesh, surface));
    CHECK_AT_MOST(self_intersections_of(mesh).size(), self_intersections_of(remesh).size() + (is_least_squares ? 0 : 3));
    CHECK_AT_LEAST(mean_min_angle(mesh), mean_min_angle(remesh) - goal.angle_loss);
  }
}

void test_data(const std::string& name, double length, const std::vector<Goal>& goals)
{
  const Mesh input = read_model(name);
  double tolerance;
  const Distance_to_mesh surface(
    tessellate_patches(PMP::PN_triangle_surface<Mesh>(input), input.number_of_faces(), 3, tolerance));
  test_model(name, input, input, surface, length, goals);
}

int main()
{
  using namespace PMP;
  const Mesh sphere = make_mesh(icosphere(6));
  test_model("sphere", sphere, Flat_triangle_surface<Mesh>(sphere), Distance_to_mesh(sphere), 0.062,
             { { PIECEWISE_LINEAR, 0.79 }, { LEAST_SQUARES, 0.79, 1 } });
  test_data("knot1", 0.04, { { PIECEWISE_LINEAR, 0.74 }, { LEAST_SQUARES, 0.74, 1 } });
  test_data("hand", 0.05, { { PIECEWISE_LINEAR, 0.66 }, { LEAST_SQUARES, 0.72, 2.5 } });
  test_data("refined_elephant", 0.025, { { PIECEWISE_LINEAR, 0.50 }, { LEAST_SQUARES, 0.59, 2.5 } });
  test_data("bunny00", 0.02, { { PIECEWISE_LINEAR, 0.57 }, { LEAST_SQUARES, 0.63, 2.5 } });
  test_data("armadillo", 0.012, { { PIECEWISE_LINEAR, 0.50 }, { LEAST_SQUARES, 0.60, 2.5 } });
  test_data("armadillo", 0.03, { { LEAST_SQUARES, 0.47, 4 } });

  start_topic("The optimized knot scales and moves with the input");
  const Mesh knot = read_model("knot1");
  const Mesh knot_remesh = make_remesh(knot, 0.04);
  check_equivariance(knot_remesh, knot);
  check_equivariance<PMP::Flat_triangle_surface<Mesh>>(knot_remesh, knot);
  check_equivariance_of_least_squares(knot_remesh, knot);
  return test_result();
}
