// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Edge lengths that follow the curvature: the curvatures, the lengths, and, with CGAL 6, the sizing field.

#include "check.h"
#include "mesh_quality.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/Approximation_sizing_field.h>
#include <CGAL/Polygon_mesh_processing/approximation_error.h>
#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Sizing/compute_edge_lengths.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_mesh.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace vlo = PMP::internal::vertex_location;

struct Arrays : vlo::Mesh_arrays
{
  explicit Arrays(const Mesh& m)
  {
    vlo::Mesh_descriptors<Mesh> descriptors;
    vlo::read_mesh(m, m.points(), *this, descriptors);
    normals = vlo::compute_face_normals<CGAL::Sequential_tag>(*this);
    is_crease = vlo::detect_creases<CGAL::Sequential_tag>(*this, normals, std::cos(40 * CGAL_PI / 180));
  }

  std::vector<vlo::Curvatures> curvatures() const
  {
    return vlo::compute_face_curvatures<CGAL::Sequential_tag>(*this, normals, is_crease);
  }

  vlo::Vertex_means vertex_curvatures(PMP::Tolerated_error kind) const
  {
    return vlo::compute_vertex_curvatures<CGAL::Sequential_tag>(*this, normals, is_crease, kind, points.size());
  }

  std::vector<vlo::Vector> normals;
  std::vector<char> is_crease;
};

void test_curvatures()
{
  start_topic("The curvatures of a sphere, a cylinder, a saddle and a cube");
  const auto doubled = [](const Point& p) { return CGAL::ORIGIN + 2 * (p - CGAL::ORIGIN); };
  for(const vlo::Curvatures& c : Arrays(make_mesh(transformed(icosphere(4), doubled))).curvatures())
  {
    CHECK_NEAR(c.k1, 0.5, 0.03);
    CHECK_NEAR(c.k2, 0.5, 0.03);
  }
  const Arrays tube(make_mesh(transformed(cylinder(60, 40), rotated)));
  const auto of_tube = tube.curvatures();
  for(std::size_t f = 0; f < of_tube.size(); ++f)
  {
    bool is_inside = true; // away from the border, where the normals are one-sided
    for(vlo::Index i : tube.face(f))
      for(std::size_t e = 0; e < tube.edges.size(); ++e)
        is_inside = is_inside && !(tube.is_border(e) && (tube.edges[e][0] == i || tube.edges[e][1] == i));
    if(is_inside)
    {
      CHECK_NEAR(std::abs(of_tube[f].k1), 1, 0.02);
      CHECK_NEAR(of_tube[f].k2, 0, 0.02);
    }
  }
  const Arrays saddle(make_mesh(transformed(triangle_grid(40, 40), [](const Point& p) {
    const double x = p.x() / 200 - 0.1, y = p.y() / 200 - 0.1;
    return Point(x, y, x * x - y * y);
  })));
  const auto of_saddle = saddle.curvatures();
  for(std::size_t f = 0; f < of_saddle.size(); ++f)
    if(const vlo::Point p = saddle.barycenter(f); std::abs(p.x()) < 0.05 && std::abs(p.y()) < 0.05)
    {
      CHECK_NEAR(std::abs(of_saddle[f].k1), 2, 0.1);
      CHECK_NEAR(of_saddle[f].k2 / of_saddle[f].k1, -1, 0.05);
    }
  for(const vlo::Curvatures& c : Arrays(make_mesh(transformed(cube(3), rotated))).curvatures())
    CHECK_NEAR(c.k1, 0, 1e-9);
}

// an ellipsoid with ends that are bent eight times as much as its waist
Mesh ellipsoid(int level)
{
  return make_mesh(transformed(icosphere(level), [](const Point& p) { return rotated(Point(p.x(), p.y(), 2 * p.z())); }));
}

void test_edge_lengths()
{
  const Arrays mesh(ellipsoid(4));
  for(auto kind : { PMP::MAXIMUM_ERROR, PMP::MEAN_ERROR, PMP::RMS_ERROR })
  {
    start_topic("Edge lengths go with the power of the curvature");
    const vlo::Vertex_means curvatures = mesh.vertex_curvatures(kind);
    const double exponent = kind == PMP::MAXIMUM_ERROR ? -0.5 : kind == PMP::MEAN_ERROR ? -0.25 : -1. / 3;
    const std::vector<double> free = vlo::compute_edge_lengths(mesh, curvatures, kind, 400, 100);
    for(std::size_t i = 0; i < free.size(); ++i)
      CHECK_NEAR(free[i] / free[0], std::pow(curvatures.values[i] / curvatures.values[0], exponent), 1e-9);
    CHECK_NEAR(vlo::estimate_number_of_vertices(mesh, free), 400, 1);

    start_topic("The gradation limits them");
    const double gradation = 0.05;
    const std::vector<double> limited = vlo::compute_edge_lengths(mesh, curvatures, kind, 400, gradation);
    double steepest = 0;
    for(const auto& [i, j] : mesh.edges)
      steepest = (std::max)(steepest, std::abs(limited[i] - limited[j]) / vlo::norm(mesh.points[i] - mesh.points[j]));
    CHECK_AT_MOST(steepest, gradation * (1 + 1e-9));
    CHECK_AT_LEAST(steepest, 0.9 * gradation); // it is no more than that
    CHECK_NEAR(vlo::estimate_number_of_vertices(mesh, limited), 400, 4);
  }

  start_topic("Where nothing is curved the edge lengths are the same");
  const Arrays flat(make_mesh(cube(2)));
  const auto lengths = vlo::compute_edge_lengths(flat, flat.vertex_curvatures(PMP::MEAN_ERROR), PMP::MEAN_ERROR, 100, 0.5);
  for(double length : lengths)
    CHECK_NEAR(length, std::sqrt(1.15 * 24 / (100 * std::sqrt(3.) / 2)), 1e-9);
}

#if CGAL_VERSION_NR >= 1060000000
struct Remeshed
{
  std::size_t number_of_vertices;
  double maximum; // the error after the optimization
};

template <typename Size>
Remeshed remesh(const Mesh& input, Size make_size)
{
  Mesh mesh = input;
  auto size = make_size(mesh);
  PMP::isotropic_remeshing(faces(mesh), size, mesh,
                           CGAL::parameters::number_of_iterations(10).number_of_relaxation_steps(3));
  const PMP::Flat_triangle_surface<Mesh> reference(input);
  PMP::optimize_vertex_locations(mesh, reference, CGAL::parameters::placement_method(PMP::LEAST_SQUARES));
  return { mesh.number_of_vertices(), PMP::approximation_error(mesh, reference).max };
}

void test_field()
{
  start_topic("A sizing field gives as many vertices as asked for, and less error");
  const Mesh input = make_mesh(transformed(icosphere(5), [](const Point& p) { return Point(p.x(), p.y(), 4 * p.z()); }));
  const auto make_field = [](Mesh& mesh) {
    return PMP::Approximation_sizing_field<Mesh>(600, mesh, CGAL::parameters::tolerated_error(PMP::MAXIMUM_ERROR));
  };
  const Remeshed adapted = remesh(input, make_field);
  CHECK_NEAR(double(adapted.number_of_vertices), 600, 90);

  double length = 0.3;
  for(int i = 0; i < 20; ++i)
    length *= std::sqrt(PMP::Approximation_sizing_field<Mesh>::number_of_vertices(length, input) / 600.);
  const Remeshed uniform = remesh(input, [&](Mesh&) { return length; });
  CHECK_NEAR(double(uniform.number_of_vertices), 600, 90);
  std::printf("largest error times vertices: %g uniform, %g with the field\n", uniform.maximum * uniform.number_of_vertices,
              adapted.maximum * adapted.number_of_vertices);
  CHECK_LESS(adapted.maximum * adapted.number_of_vertices, 0.7 * uniform.maximum * uniform.number_of_vertices);
}
#endif

int main()
{
  test_curvatures();
  test_edge_lengths();
#if CGAL_VERSION_NR >= 1060000000
  test_field();
#endif
  return test_result();
}
