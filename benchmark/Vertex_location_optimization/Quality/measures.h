// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_MEASURES_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_MEASURES_H

#include "../sparse_least_squares.h"
#include "limits.h"
#include "remeshers.h"
#include "simplify.h"

#include <CGAL/Polygon_mesh_processing/approximation_error.h>
#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Timer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// what is compared
enum Method
{
  REMESH,
  PIECEWISE_LINEAR,
  LEAST_SQUARES,
  SPARSE
};
constexpr std::array<const char*, 4> method_names{ "remesh", "piecewise linear", "least squares", "sparse system" };

// of a mesh; distances in 1e-4 of the longest side of the input's bounding box, angles in degrees
struct Measures
{
  double mean, max;                  // the distance to the reference
  double mean_back, max_back;        // that from the reference
  double mean_angle, smallest_angle; // the smallest angles of the faces
  std::size_t intersections;         // the pairs of faces that intersect
  double seconds;                    // of processor time, to make it with one thread
};

// a remesh, and what the methods make of it
struct Row
{
  std::string model;
  std::string remesher;
  Paper paper;
  std::size_t number_of_vertices;
  std::optional<double> limit;      // of the mean, where the input is smooth
  std::array<Measures, 4> measures; // of the methods

  // in percent; negative if the method does harm
  double reduction(Method method, double Measures::*error) const
  {
    return 100 * (1 - measures[method].*error / measures[REMESH].*error);
  }
};

inline std::pair<double, double> mean_and_smallest_angle(const Mesh& mesh)
{
  double mean = 0, smallest = 180;
  for(Mesh::Face_index f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    const Point &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)), &r = mesh.point(mesh.target(mesh.next(h)));
    const double angle =
      (std::min)({ CGAL::approximate_angle(p, q, r), CGAL::approximate_angle(q, r, p), CGAL::approximate_angle(r, p, q) });
    mean += angle / mesh.number_of_faces();
    smallest = (std::min)(smallest, angle);
  }
  return { mean, smallest };
}

// The mean and the largest distance from the reference to the mesh. The reference is sampled at the points that are
// closest to the vertices of the input and to four points in each of its faces.
template <typename Surface>
std::pair<double, double> distance_back(const Mesh& input, const Surface& reference, const Mesh& mesh)
{
  const PMP::Flat_triangle_surface<Mesh> flat(mesh);
  auto distance = [&](const Point& p) {
    const Point y = reference.point(reference.project(p));
    return std::sqrt(CGAL::squared_distance(y, flat.point(flat.project(y))));
  };
  double sum = 0, area = 0, max = 0;
  for(Mesh::Vertex_index v : input.vertices())
    max = (std::max)(max, distance(input.point(v)));
  for(Mesh::Face_index f : input.faces())
  {
    const auto h = input.halfedge(f);
    const std::array<Point, 3> t{ input.point(input.source(h)), input.point(input.target(h)),
                                  input.point(input.target(input.next(h))) };
    const double a = std::sqrt(CGAL::squared_area(t[0], t[1], t[2]));
    const Point center = CGAL::centroid(t[0], t[1], t[2]);
    for(const Point& p :
        { center, CGAL::midpoint(center, t[0]), CGAL::midpoint(center, t[1]), CGAL::midpoint(center, t[2]) })
    {
      const double d = distance(p);
      sum += a * d;
      area += a;
      max = (std::max)(max, d);
    }
  }
  return { sum / area, max };
}

template <typename Surface>
Measures measure(const Mesh& mesh, const Model& model, const Surface& reference, double seconds)
{
  const double unit = 1e-4 * longest_side(model.input);
  const PMP::Approximation_error error = PMP::approximation_error<Concurrency_tag>(mesh, reference);
  const auto [mean_back, max_back] = distance_back(model.input, reference, mesh);
  const auto [mean_angle, smallest_angle] = mean_and_smallest_angle(mesh);
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
  PMP::self_intersections<Concurrency_tag>(faces(mesh), mesh, std::back_inserter(pairs));
  return { error.mean / unit, error.max / unit, mean_back / unit, max_back / unit,
           mean_angle,        smallest_angle,   pairs.size(),     seconds };
}

// the mesh that a method makes of a remesh; creases follow those of the input, but the sparse system keeps them there
template <typename Surface>
Mesh optimize(Mesh mesh, const Surface& reference, Method method)
{
  const Crease_map is_crease = creases(mesh);
  if(method == SPARSE)
    fit_sparse_least_squares(mesh, reference, [&](Mesh::Vertex_index v) {
      for(Mesh::Halfedge_index h : CGAL::halfedges_around_target(v, mesh))
        if(is_crease[mesh.edge(h)])
          return true;
      return false;
    });
  else
    PMP::optimize_vertex_locations(
      mesh, reference,
      CGAL::parameters::placement_method(method == PIECEWISE_LINEAR ? PMP::PIECEWISE_LINEAR : PMP::LEAST_SQUARES)
        .edge_is_constrained_map(is_crease)
        .relax_constraints(true));
  return mesh;
}

// that of the mean error, in 1e-4 of the longest side; a model with creases is not smooth
inline std::optional<double> limit_of(const Model& model, std::size_t number_of_vertices, double Limits::*limit)
{
  if(model.is_flat)
    return {};
  return limits_of(curvatures_of(model.input), number_of_vertices).*limit / (1e-4 * longest_side(model.input));
}

// Optimizes a remesh of the model with each method and measures the results.
template <typename Surface>
Row measure_methods(const Model& model,
                    const std::string& remesher,
                    const Mesh& remesh,
                    double seconds,
                    const Surface& reference,
                    double Limits::*limit)
{
  const std::size_t number_of_vertices = remesh.number_of_vertices();
  Row row{ model.name, remesher, model.paper, number_of_vertices, limit_of(model, number_of_vertices, limit), {} };
  row.measures[REMESH] = measure(remesh, model, reference, seconds);
  for(Method method : { PIECEWISE_LINEAR, LEAST_SQUARES, SPARSE })
  {
    CGAL::Timer timer;
    timer.start();
    const Mesh mesh = optimize(remesh, reference, method);
    timer.stop();
    row.measures[method] = measure(mesh, model, reference, timer.time());
  }
  return row;
}

// Makes a remesh of the model with `make_remesh()`, and its row.
template <typename Surface, typename MakeRemesh>
Row measure_remesh(const Model& model,
                   const std::string& remesher,
                   const Surface& reference,
                   const MakeRemesh& make_remesh,
                   double Limits::*limit = &Limits::uniform)
{
  CGAL::Timer timer;
  timer.start();
  const Mesh remesh = make_remesh();
  timer.stop();
  return measure_methods(model, remesher, remesh, timer.time(), reference, limit);
}

template <typename Surface>
Row measure_isotropic_remesh(const Model& model, const Surface& reference)
{
  return measure_remesh(model, "isotropic", reference, [&]() { return remesh_isotropically(model); });
}

// The rows of a model: one for each remesher if the paper has the model and no creases are to be kept.
template <typename Surface>
std::vector<Row> measure_remeshers(const Model& model, const Surface& reference)
{
  std::vector<Row> rows{ measure_isotropic_remesh(model, reference) };
  auto add_row = [&](const char* remesher, const auto& make_remesh, double Limits::*limit = &Limits::uniform) {
    rows.push_back(measure_remesh(model, remesher, reference, make_remesh, limit));
  };
  if(model.paper.mean.empty() || model.crease_angle < 180)
    return rows;
  add_row("isotropic, one iteration", [&]() { return remesh_isotropically(model, 1); });
  add_row("isotropic, made rough", [&]() { return remesh_roughly(model, reference); });
  add_row(adaptive_remesher, [&]() { return remesh_adaptively(model); });
  const std::size_t n = rows[0].number_of_vertices;
  add_row("centroidal Voronoi", [&]() { return remesh_with_Voronoi_cells(model, n, reference); });
  add_row(
    "Lindstrom-Turk", [&]() { return simplify_Lindstrom_Turk(model.input, n); }, &Limits::anisotropic);
  return rows;
}

// calls f with the surface that the model's input stands for
template <typename F>
auto with_reference(const Model& model, const F& f)
{
  return model.is_flat ? f(PMP::Flat_triangle_surface<Mesh>(model.input)) : f(PMP::PN_triangle_surface<Mesh>(model.input));
}

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_MEASURES_H
