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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_RESULT_DISTANCES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_RESULT_DISTANCES_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/Error_integral.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Face_sampling.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Initial_quality.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/largest_distance.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Moves.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/Face_orientation.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Sampling/Remesh_samples.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_element.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The sampled distance to the reference of the remesh with its vertices at the next points, which finally are the result of
// the run.
template <typename Reference>
class Result_distances
{
  using Foot = typename Reference::Foot;
  using Hint = typename Reference::Hint;

  static constexpr float unknown = -1; // of what is not measured

  // The distances at some queries, and where to search for their closest points.
  struct Samples
  {
    explicit Samples(Sample_offsets<Hint>& samples) : hints(std::move(samples.hints)), distances(samples.offsets.size())
    {
      std::transform(samples.offsets.begin(), samples.offsets.end(), distances.begin(), norm);
      samples.offsets = {};
    }

    // Measures query k, which goes from `from` to `to`; the edges there have this length. Its distance gets a sign.
    void measure(std::size_t k, const Reference& reference, const Point& from, const Point& to, double length)
    {
      const double near = near_by(std::abs(distances[k]) + norm(to - from) / 2, length);
      const auto [foot, signed_distance] = walk_or_search(reference, to, hints[k], near);
      distances[k] = signed_distance;
      hints[k] = foot;
    }

    const Hint& hint(std::size_t k) const { return hints[k]; }

    std::vector<Hint> hints;
    std::vector<double> distances;
  };

  // in single precision, as there are many
  struct Face
  {
    float mean, standard_error, mean_square, max;
    Face_orientation orientation; // at the barycenter
  };

public:
  // `samples` are those of the points of the remesh, with which it goes on
  Result_distances(const Reference& reference,
                   const Remesh& remesh,
                   const Initial_quality& initial,
                   Remesh_sample_offsets<Hint> samples)
    : m_reference(reference), m_remesh(remesh), m_initial(initial), m_vertices(samples.vertices),
      m_midpoints(samples.midpoints), m_points(remesh.points), m_faces(remesh.number_of_faces())
  {}

  // Measures the next points.
  template <typename ConcurrencyTag>
  void measure()
  {
    for_each_element<ConcurrencyTag>(
      m_remesh, [&](std::size_t i) { measure_vertex(i); }, [&](std::size_t e) { measure_midpoint(e); }, [](std::size_t) {});
    // afterwards, as a face reads what is measured at all of its corners and sides
    for_each_index<ConcurrencyTag>(m_remesh.number_of_faces(), [&](std::size_t f) {
      constexpr std::size_t ahead = 8;
      if(f + ahead < m_remesh.number_of_faces())
        m_reference.prefetch(barycenter_hint(f + ahead));
      measure_face(f);
      if(!has_moved(f))
        restore_face(f);
    });
    m_points = m_remesh.next_points;
  }

  // Measures again what has changed since; returns the faces, in increasing order.
  template <typename ConcurrencyTag>
  std::vector<Index> update()
  {
    const std::vector<Index> vertices =
      find_indices<ConcurrencyTag>(m_points.size(), [&](std::size_t i) { return m_points[i] != m_remesh.next_points[i]; });
    std::vector<Index> edges, faces;
    find_edges_and_faces(m_remesh, vertices, edges, faces);
    for_each_index<ConcurrencyTag>(vertices.size(), [&](std::size_t k) { measure_vertex(vertices[k]); });
    for_each_index<ConcurrencyTag>(edges.size(), [&](std::size_t k) { measure_midpoint(edges[k]); });
    for_each_index<ConcurrencyTag>(faces.size(), [&](std::size_t k) {
      if(has_moved(faces[k]))
        measure_face(faces[k]);
      else
      {
        restore_face(faces[k]);
        m_faces[faces[k]].standard_error = unknown;
      }
    });
    for(Index i : vertices)
      m_points[i] = m_remesh.next_points[i];
    return faces;
  }

  // Finally measures the samples that `update()` has skipped on faces that have not moved.
  template <typename ConcurrencyTag>
  void complete()
  {
    for_each_index<ConcurrencyTag>(m_faces.size(), [&](std::size_t f) {
      if(m_faces[f].standard_error != unknown)
        return;
      measure_face(f);
      restore_face(f);
    });
  }

  // over the whole remesh; the maximum is that of the samples, where walking may have missed closer points
  template <typename ConcurrencyTag>
  Approximation_error error() const
  {
    return sum_over_indices<ConcurrencyTag, Error_integral>(
             m_remesh.number_of_faces(),
             [&](std::size_t f) {
               const double area = m_remesh.area(f, m_remesh.next_points);
               return Error_integral{ area, area * m_faces[f].mean, area * m_faces[f].mean_square, sampled_maximum(f) };
             })
      .error();
  }

  // the integral over face f
  double integral(std::size_t f) const { return m_remesh.area(f, m_remesh.next_points) * m_faces[f].mean; }

  // of the mean over face f, as its samples tell
  double standard_error(std::size_t f) const { return m_faces[f].standard_error; }

  // at the barycenter of face f
  Face_orientation orientation(std::size_t f) const { return m_faces[f].orientation; }

  // of the reference, at the points closest to the corners and the barycenter of face f
  std::array<Vector, 4> reference_normals(std::size_t f) const
  {
    const std::array<Point, 3> t = m_remesh.triangle(f, m_remesh.next_points);
    const auto normal_at = [&](const Point& p) { return m_reference.normal(m_reference.project(p, hint(f))); };
    return { { normal_at(t[0]), normal_at(t[1]), normal_at(t[2]), normal_at(point_at(t, barycenter_coordinates)) } };
  }

  // the largest of the samples on face f
  double sampled_maximum(std::size_t f) const { return (std::max)(double(m_faces[f].max), on_sides(f).maximum()); }

  double maximum() const
  {
    return largest_distance(
      m_remesh, [&](std::size_t f) { return sampled_maximum(f); },
      [&](std::size_t f, double bound) {
        return largest_on_face(f, m_remesh.next_points, sampled_maximum(f), bound, false);
      });
  }

  // Whether the largest distance on face f is larger than `limit` and than with the initial points.
  bool exceeds(std::size_t f, double limit) const
  {
    const double sampled = sampled_maximum(f);
    // no point is farther away from all corners and midpoints
    const double radius = std::sqrt(squared_longest_side(m_remesh.triangle(f, m_remesh.next_points)) / 12);
    if(sampled + radius <= limit)
      return false;
    if(!(largest_on_face(f, m_remesh.next_points, sampled, limit, true) > limit))
      return false;
    constexpr double all_samples = std::numeric_limits<double>::infinity(); // are measured again
    const double initial = rounded_up(largest_on_face(f, m_remesh.initial_points, all_samples, limit, false));
    return largest_on_face(f, m_remesh.next_points, sampled, initial, true) > initial;
  }

  // a foot near to face f
  const Hint& hint(std::size_t f) const { return m_vertices.hints[m_remesh.first_vertex(f)]; }

private:
  const Hint& barycenter_hint(std::size_t f) const { return m_midpoints.hints[m_remesh.edge_at_first_vertex(f)]; }

  double largest_on_face(
    std::size_t f, const std::vector<Point>& points, double sampled_maximum, double bound, bool is_any_enough) const
  {
    return largest_distance_on_face(m_reference, m_initial.sampling, f, m_remesh.triangle(f, points), feet(f),
                                    sampled_maximum, bound, is_any_enough);
  }

  Face_feet<Foot> feet(std::size_t f) const { return feet_of_face<Foot>(m_remesh, f, m_vertices, m_midpoints); }

  Distances_on_sides on_sides(std::size_t f) const
  {
    return distances_on_sides(m_remesh, f, m_vertices.distances, m_midpoints.distances);
  }

  bool has_moved(std::size_t f) const
  {
    const std::array<Index, 3>& v = m_remesh.face(f);
    return std::any_of(v.begin(), v.end(), [&](Index i) { return m_remesh.next_points[i] != m_remesh.initial_points[i]; });
  }

  void measure_vertex(std::size_t i)
  {
    m_vertices.measure(i, m_reference, m_points[i], m_remesh.next_points[i], m_remesh.lengths[i]);
  }

  void measure_midpoint(std::size_t e)
  {
    m_midpoints.measure(e, m_reference, m_remesh.midpoint(e, m_points), m_remesh.midpoint(e, m_remesh.next_points),
                        m_remesh.length_at(m_remesh.edges[e]));
  }

  // The orientation requires the exact closest point: on a thin part, another sheet has the opposite normal.
  void measure_face(std::size_t f)
  {
    const std::array<Point, 3> t = m_remesh.triangle(f, m_remesh.next_points);
    const Face_distances d = m_initial.sampling.measure(m_reference, f, t, feet(f), on_sides(f));
    const Point p = point_at(t, barycenter_coordinates);
    const Foot foot = m_reference.project(p, barycenter_hint(f));
    const double at_barycenter = distance_to_foot(p, m_reference, foot);
    m_faces[f] = { static_cast<float>(d.mean), static_cast<float>(d.standard_error), static_cast<float>(d.mean_square),
                   static_cast<float>((std::max)(d.max, at_barycenter)),
                   orientation_at(m_reference, foot, m_remesh.area_normal(f, m_remesh.next_points)) };
  }

  // Face f has not moved: its mean has not changed, whatever a walk finds.
  void restore_face(std::size_t f)
  {
    m_faces[f].mean = m_initial.means[f];
    m_faces[f].orientation = m_initial.orientations[f];
  }

  const Reference& m_reference;
  const Remesh& m_remesh;
  const Initial_quality& m_initial;
  Samples m_vertices, m_midpoints;
  std::vector<Point> m_points; // of the vertices, for which the samples were taken
  std::vector<Face> m_faces;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_RESULT_DISTANCES_H
