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
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <CGAL/bounding_box.h>
#include <CGAL/Timer.h>

#include <iterator>
#include <utility>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

double longest_side(const Mesh& mesh)
{
  const auto box = CGAL::bounding_box(mesh.points().begin(), mesh.points().end());
  return (std::max)({ box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin() });
}

// `length` is relative to the longest side of the bounding box
Mesh make_remesh(Mesh mesh, double length)
{
  const double target_edge_length = length * longest_side(mesh);
  PMP::isotropic_remeshing(faces(mesh), target_edge_length, mesh,
                           CGAL::parameters::number_of_iterations(10).number_of_relaxation_steps(3));
  mesh.collect_garbage();
  return mesh;
}

std::size_t number_of_self_intersections(const Mesh& mesh)
{
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
  PMP::self_intersections(mesh, std::back_inserter(pairs));
  return pairs.size();
}

// the faces that are turned away from the surface at their barycenters
std::size_t number_of_flips(const Mesh& mesh, const Distance_to_mesh& surface)
{
  std::size_t flips = 0;
  for(Mesh::Face_index f : mesh.faces())
  {
    const auto t = corners(mesh, f);
    const Mesh::Face_index nearest = surface.closest(CGAL::centroid(t[0], t[1], t[2])).second;
    flips += area_vector(t) * area_vector(corners(surface.mesh(), nearest)) < 0;
  }
  return flips;
}

// `surface` is what the errors are measured against; `reduction` is that of the mean error
void test_model(const std::string& name, const Mesh& input, const Distance_to_mesh& surface, double length, double reduction)
{
  start_topic(name);
  CGAL::Timer remeshing_timer, optimization_timer;
  remeshing_timer.start();
  const Mesh remesh = make_remesh(input, length);
  remeshing_timer.stop();

  optimization_timer.start();
  Mesh mesh = remesh;
  PMP::optimize_vertex_locations(mesh, input);
  optimization_timer.stop();

  auto errors_of = [&, hint = input.point(*input.vertices().begin())](const Mesh& m) mutable
  {
    return measure_errors(m, 4, [&](const Point& p) { return surface(p, hint); });
  };
  const double unit_length = 1e-4 * longest_side(input);
  const Errors before = errors_of(remesh), after = errors_of(mesh);
  std::cout << "  " << mesh.number_of_vertices() << " vertices, mean error " << before.mean / unit_length << " -> "
            << after.mean / unit_length << " (" << 100 * (1 - after.mean / before.mean) << "%), max "
            << before.max / unit_length << " -> " << after.max / unit_length << ", angle " << mean_min_angle(remesh)
            << " -> " << mean_min_angle(mesh) << ", remeshing " << remeshing_timer.time() << " s, optimization "
            << optimization_timer.time() << " s" << std::endl;

  CHECK_AT_LEAST(1 - after.mean / before.mean, reduction);
  CHECK_AT_MOST(after.max, before.max);
  CHECK_AT_MOST(number_of_flips(mesh, surface), number_of_flips(remesh, surface));
  CHECK_AT_MOST(number_of_self_intersections(mesh), number_of_self_intersections(remesh) + 3);
  CHECK_AT_LEAST(mean_min_angle(mesh), mean_min_angle(remesh) - 4);
  if(mesh.number_of_vertices() > 10000)
    CHECK_AT_MOST(optimization_timer.time(), remeshing_timer.time());
}

Mesh read_model(const std::string& name)
{
  Mesh mesh;
  CHECK(CGAL::IO::read_OFF(CGAL::data_file_path("meshes/" + name + ".off"), mesh));
  return mesh;
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
