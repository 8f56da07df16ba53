// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
//
// Author(s)     : The Vertex_location_optimization authors

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_LEAST_SQUARES_PLACEMENT_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_LEAST_SQUARES_PLACEMENT_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Placement/for_each_sum_over_faces.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Placement/measure_regularity.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Placement/Normal_equations.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Placement/Placement.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Placement/pull_to_regular.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Sampling/Area_samples.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

inline Optimization_options least_squares_defaults()
{
  Optimization_options options{ LEAST_SQUARES, std::nullopt, true };
  options.guarantee_both_directions = true; // the samples of the reference are there already
  return options;
}

// The sums of the faces at a vertex.
struct Vertex_equations
{
  Normal_equations of_faces;
  double area = 0;            // of these faces
  double number_of_faces = 0; // the sum of their weights

  Vertex_equations& operator+=(const Vertex_equations& other)
  {
    of_faces += other.of_faces;
    area += other.area;
    number_of_faces += other.number_of_faces;
    return *this;
  }
};

// A point-to-plane least squares fit to samples of both surfaces, with the regularity of the triangles as a term of it.
template <typename ConcurrencyTag, typename Reference>
class Least_squares_placement : public Placement<Reference>
{
  using Base = Placement<Reference>;
  using Base::m_reference;
  using Base::m_remesh;
  using Base::m_samples;

public:
  Least_squares_placement(const Reference& reference, Remesh& remesh, const Optimization_options& options)
    : Base(reference, remesh, Sample_set::MIDPOINTS_AND_BARYCENTERS), m_convergence_threshold(options.convergence_threshold),
      m_regularity_weight(options.part_of_regularity * options.regularity_weight.value_or(default_weight)),
      m_keeps_shapes(!options.regularity_weight)
  {}

  Initial_measure start() override
  {
    if(m_keeps_shapes && !m_remesh.has_polygons()) // quads are not measured by the angles of their triangles
      m_regularity = measure_regularity(m_remesh);
    else
      m_regularity.assign(m_remesh.points.size(), 1);
    Initial_measure measure = m_samples.template start<ConcurrencyTag>(m_reference, m_remesh);
    take_area_samples_anew();
    return measure;
  }

  // While the vertices still move far, the reference is resampled at intervals, so that the density of the samples follows
  // that of the faces, and the fit does not adapt to a single set of points.
  void resample(const Iteration& iteration) override
  {
    constexpr double all = -1; // no face's vertices have gone less far
    if(iteration.is_last)
      m_samples.template project<ConcurrencyTag>(m_reference, m_remesh);
    else
      m_samples.template update<ConcurrencyTag>(m_reference, m_remesh, tolerance());

    if(are_area_samples_due(iteration))
      take_area_samples_anew();
    else
      m_area_samples.template update<ConcurrencyTag>(m_remesh, iteration.is_last ? all : tolerance().travel);
  }

  // Moves each free vertex towards the least squares fit of its faces to the samples of both surfaces, its neighbors held
  // fixed. The equations of the vertices are solved independently of each other, hence the relaxation factor; part of the
  // last displacement is repeated to get there sooner. A vertex whose samples already fit does not move.
  void place(const Iteration&) override
  {
    // found by trial: they trade speed for settling; max_step is relative to the length of the edges
    constexpr double relaxation = 1.4, momentum = 0.6, max_step = 0.25;
    constexpr double rounding = 1e-9; // relative to the terms of the equations

    for_each_sum_over_faces<ConcurrencyTag, Vertex_equations>(
      m_remesh, [&](std::size_t f) { return face_equations(f); },
      [&](std::size_t i, const Vertex_equations& of_vertex) {
        const Point& v = m_remesh.points[i];
        m_remesh.next_points[i] = v;
        const double area = of_vertex.area, edge_length = m_remesh.lengths[i], limit = max_step * edge_length;
        if(!m_remesh.is_free(i) || !(area > 0))
          return;

        Normal_equations equations = of_vertex.of_faces;
        equations += Normal_equations(m_samples.vertices.normal(i), m_samples.vertices.offset(i),
                                      Cubic_quadrature::of_vertex(area), edge_length, reweighting(m_regularity[i]));
        if(norm(equations.right_hand_side()) <= rounding * area * edge_length)
          return;

        const Vector d =
          equations.solve(pull(i, of_vertex), pull_weight(i, of_vertex, equations.mean_residual()), rounding * area);
        const Vector step = relaxation * d + momentum * m_remesh.last_displacement(i);
        const double length = norm(step);
        m_remesh.next_points[i] = v + (length > limit ? (limit / length) * step : step);
      });
  }

  void relax() override {} // the equations do it

  // At first, the vertices oscillate about the surface, those whose moves are shortened permanently, and all vertices keep
  // sliding along it. The criterion is therefore the displacement along the normals over two iterations, relative to the
  // remaining distances: much smaller displacements no longer matter.
  bool has_settled() override
  {
    // They trade time for the error: on remeshes, the fit ends within 1 or 2% of the error of 30 iterations. The second is
    // relative to the lengths of the edges.
    constexpr double part_of_distance = 0.05, smallest_displacement = 1e-4;
    double sum = 0;
    for(std::size_t i = 0; i < m_remesh.points.size(); ++i)
      if(m_remesh.lengths[i] > 0)
        sum += square((m_remesh.next_points[i] - m_remesh.points[i]) * m_samples.vertices.normal(i) / m_remesh.lengths[i]);
    const double last = m_displacement_along_normals;
    m_displacement_along_normals = std::sqrt(sum / (std::max)(m_remesh.points.size(), std::size_t(1)));
    const double threshold = (std::max)(part_of_distance * mean_relative_distance(), smallest_displacement);
    return (std::max)(last, m_displacement_along_normals) <= m_convergence_threshold.value_or(threshold);
  }

private:
  // At the end, the same samples tell whether the vertices have settled. Polygons, each of which is many overlapping
  // triangles, do not settle as well if their samples change.
  bool are_area_samples_due(const Iteration& iteration) const
  {
    constexpr std::size_t period = 3, last = 15; // iterations; they trade time for 1 to 2% of the error
    return !iteration.is_last && !m_remesh.has_polygons() && iteration.number % period == 0 && iteration.number <= last;
  }

  void take_area_samples_anew()
  {
    m_area_samples.template start<ConcurrencyTag>(
      m_reference, m_remesh, [&](std::size_t f) { return m_samples.midpoints.hint(m_remesh.edge_at_first_vertex(f)); });
  }

  // of the barycenters of the faces, relative to the lengths of their edges
  double mean_relative_distance() const
  {
    double sum = 0;
    for(std::size_t f = 0; f < m_remesh.number_of_faces(); ++f)
      if(const double length = m_remesh.length_of_face(f); length > 0)
        sum += norm(m_samples.barycenters.offset(f)) / length;
    return sum / static_cast<double>(m_remesh.number_of_faces());
  }

  // As the vertices settle the samples follow them more closely.
  Sampling_tolerance tolerance() const
  {
    // the third is relative to the displacements; they trade exactness for time
    constexpr double min_travel = 0.02, max_travel = 0.1, max_distance = 0.05, travel_by_displacement = 10;
    return { std::clamp(travel_by_displacement * m_displacement_along_normals, min_travel, max_travel), max_distance, true };
  }

  // the equations of the samples in face f, except for those at its vertices, for each of its vertices
  std::array<Vertex_equations, 3> face_equations(const std::size_t f) const
  {
    const std::array<Point, 3> t = m_remesh.triangle(f);
    const double area = m_remesh.area(f), length = m_remesh.length_of_face(f), power = reweighting_of_face(f);
    std::array<Normal_equations, 3> equations;
    for(int k = 0; k < 3; ++k)
    {
      const Index e = m_remesh.face_edges[f][k];
      const Normal_equations of_midpoint(m_samples.midpoints.normal(e), m_samples.midpoints.offset(e),
                                         Cubic_quadrature::of_midpoint(area), length, power);
      equations[(k + 1) % 3].add(of_midpoint, 0.5);
      equations[(k + 2) % 3].add(of_midpoint, 0.5);
    }

    const Normal_equations of_barycenter(m_samples.barycenters.normal(f), m_samples.barycenters.offset(f),
                                         Cubic_quadrature::of_barycenter(area), length, power);
    for(Normal_equations& of_corner : equations)
      of_corner.add(of_barycenter, 1. / 3);

    m_area_samples.for_each_in_face(
      f, [&](const Point& point, const Vector& normal, double sample_area, const Coordinates& x) {
        const std::array<double, 3> lambda = x.barycentric();
        const Vector offset = point - point_at(t, x);
        // inside the face the reference's normal, on its boundary the direction to the sample
        const Vector direction = is_inside(lambda) ? Vector(NULL_VECTOR) : normalized(offset);
        const Normal_equations of_sample(direction != NULL_VECTOR ? direction : normal, offset, sample_area, length, power);
        for(int k = 0; k < 3; ++k)
          equations[k].add(of_sample, lambda[k]);
      });
    const double weight = m_remesh.weight(f);
    return { { { equations[0], area, weight }, { equations[1], area, weight }, { equations[2], area, weight } } };
  }

  // where the polygons at vertex i would become more regular
  Vector pull(const std::size_t i, const Vertex_equations& of_vertex) const
  {
    Vector sum = NULL_VECTOR;
    double number_of_polygons = 0;
    const double mean_area = of_vertex.area / of_vertex.number_of_faces;
    const double side = std::sqrt(mean_area * 4 / std::sqrt(3.)); // if the faces were equilateral
    m_remesh.for_each_corner(i, [&](Index c) {
      if(m_remesh.ear(c) != c)
        return;
      const Point &v = m_remesh.points[i], &p = m_remesh.points[m_remesh.vertex(Mesh_arrays::next(c))],
                  &q = m_remesh.points[m_remesh.vertex(Mesh_arrays::previous(c))];
      sum = sum + (m_remesh.weight(c / 3) == 1
                     ? pull_to_regular(v, p, q, side)
                     : pull_to_regular_polygon(v, p, q, m_samples.vertices.normal(i), m_remesh.weight(c / 3)));
      ++number_of_polygons;
    });
    return sum / number_of_polygons;
  }

  // All faces have the same weight, as in the mean of their angles. Where M_0 is irregular, its shapes are preserved rather
  // than made regular. The smaller the current error is, the less of it is traded for regularity.
  double pull_weight(const std::size_t i, const Vertex_equations& of_vertex, const double mean_residual) const
  {
    // found by trial, on remeshes and on simplified meshes; they trade the angles for the error
    constexpr double part_of_irregular = 0.27;
    constexpr double small_error = 0.03; // relative to the length of the edges; above it, regularity has its full weight
    const double x = mean_residual / (small_error * m_remesh.lengths[i]);
    const double of_error = x / std::sqrt(std::sqrt(1 + square(square(x))));
    const double of_shapes = std::pow(part_of_irregular, 1 - m_regularity[i]);
    const double equilateral_area = std::sqrt(3.) / 4 * square(m_remesh.lengths[i]);
    return m_regularity_weight * of_error * of_shapes * of_vertex.number_of_faces * equilateral_area;
  }

  // The power by which large distances are weighted down. It is closer to 1, for which the mean distance itself is
  // minimized, where regularity has little weight: simplified meshes have small errors nearly everywhere.
  static double reweighting(const double regularity)
  {
    constexpr double of_regular = 0.5, of_irregular = 0.7;
    return of_irregular + (of_regular - of_irregular) * regularity;
  }

  double reweighting_of_face(const std::size_t f) const
  {
    const std::array<Index, 3>& v = m_remesh.face(f);
    return reweighting((m_regularity[v[0]] + m_regularity[v[1]] + m_regularity[v[2]]) / 3);
  }

  static constexpr double default_weight = 0.19;
  Area_samples m_area_samples; // of the reference
  const std::optional<double> m_convergence_threshold;
  const double m_regularity_weight;
  const bool m_keeps_shapes;               // of M_0, where they are irregular: unless the user has chosen the weight
  std::vector<double> m_regularity;        // of M_0
  double m_displacement_along_normals = 0; // of the last iteration, relative to the lengths, root mean square
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_LEAST_SQUARES_PLACEMENT_H
