// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_RESULT_DISTANCES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_RESULT_DISTANCES_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Farthest_point.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/Distance_samples.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/Face_orientation.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Sampling/Remesh_samples.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_element.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The distance to the reference of the remesh with its vertices at the next points, sampled; in the end that is the result
// of the run.
template <typename Reference>
class Result_distances
{
  using Foot = typename Reference::Foot;
  using Hint = typename Reference::Hint;
  using Samples = Sample_offsets<Hint>;
  using Farthest = Farthest_point<Reference>;

public:
  // `samples` are those of the points of the remesh, with which it goes on
  Result_distances(const Reference& reference, const Remesh& remesh, Remesh_sample_offsets<Hint> samples)
    : m_reference(reference), m_remesh(remesh), m_vertices(std::move(samples.vertices)),
      m_midpoints(std::move(samples.midpoints)), m_points(remesh.points), m_distances(remesh),
      m_orientations(remesh.number_of_faces())
  {}

  // Measures the next points. Each distance is that to the point where walking from the foot of the last iteration leads,
  // or to the last sample if the query has moved by nothing to speak of since that was taken; rather more than less.
  template <typename ConcurrencyTag>
  void measure()
  {
    constexpr double negligible = 1e-3; // relative to the length of edges; it saves the search where the run has converged
    const auto move = [&](Samples& samples, std::size_t k, const Point& from, const Point& to, double length) {
      if(!(squared_distance(from, to) <= square(negligible * length)))
        return walk(samples, k, to);
      samples.offsets[k] = samples.offsets[k] - (to - from);
      return norm(samples.offsets[k]);
    };

    for_each_element<ConcurrencyTag>(
      m_remesh,
      [&](std::size_t i) {
        m_distances.at_vertices[i] = move(m_vertices, i, m_points[i], m_remesh.next_points[i], m_remesh.lengths[i]);
      },
      [&](std::size_t e) {
        const double length = m_remesh.length_at(m_remesh.edges[e]);
        m_distances.at_midpoints[e] =
          move(m_midpoints, e, m_remesh.midpoint(e, m_points), m_remesh.midpoint(e, m_remesh.next_points), length);
      },
      [&](std::size_t f) {
        constexpr std::size_t ahead = 8;
        if(f + ahead < m_remesh.number_of_faces())
          m_reference.prefetch(barycenter_hint(f + ahead));
        measure_barycenter(f);
      });
    m_points = m_remesh.next_points;
  }

  // measures anew what has changed with the next point of vertex i
  void update(Index i)
  {
    m_points[i] = m_remesh.next_points[i];
    m_distances.at_vertices[i] = walk(m_vertices, i, m_points[i]);
    m_remesh.for_each_corner(i, [&](Index c) {
      for(Index d : { Mesh_arrays::next(c), Mesh_arrays::previous(c) })
      {
        const Index e = m_remesh.opposite_edge(d);
        m_distances.at_midpoints[e] = walk(m_midpoints, e, m_remesh.midpoint(e, m_remesh.next_points));
      }
      measure_barycenter(c / 3);
    });
  }

  template <typename ConcurrencyTag>
  double mean() const
  {
    return mean_distance<ConcurrencyTag>(m_remesh, m_remesh.next_points, m_distances);
  }

  // the integral over face f
  double integral(std::size_t f) const { return m_remesh.area(f, m_remesh.next_points) * m_distances.mean(m_remesh, f); }

  // the same with the vertices at their initial points, at closest points
  double initial_integral(std::size_t f) const
  {
    const std::array<Index, 3>& vertices = m_remesh.face(f);
    const std::array<Point, 3> t = m_remesh.triangle(f, m_remesh.initial_points);
    double of_vertices = 0, of_midpoints = 0;
    for(int k = 0; k < 3; ++k)
    {
      of_vertices += distance(t[k], m_vertices.hints[vertices[k]]);
      of_midpoints += distance(midpoint(t[(k + 1) % 3], t[(k + 2) % 3]), m_midpoints.hints[m_remesh.face_edges[f][k]]);
    }
    const double of_barycenter = distance(point_at(t, barycenter_coordinates), barycenter_hint(f));
    return m_remesh.area(f, m_remesh.initial_points) *
           (Cubic_quadrature::of_vertex(of_vertices) + Cubic_quadrature::of_midpoint(of_midpoints) +
            Cubic_quadrature::of_barycenter(of_barycenter));
  }

  // at the barycenter of face f
  Face_orientation orientation(std::size_t f) const { return m_orientations[f]; }

  // The largest distance on face f, rather more than less, if the samples come near `limit`; else the largest of the
  // samples. Between them the distance may be larger: fivefold on a face that spans a crease, less the more samples there
  // are. Where two sheets of the reference are equally far away it has a ridge, on which climbing may end too early.
  double maximum(std::size_t f, double limit) const
  {
    // relative to the limit: below the first the samples are enough, below the second a coarse lattice, and above the third
    // a fine one is needed to tell on which side of the limit the maximum is
    constexpr double enough_by_samples = 0.2, enough_by_coarse_lattice = 0.6, too_close = 0.9;
    constexpr int coarse_level = 4, fine_level = 24;
    const double sampled = m_distances.maximum(m_remesh, f);
    if(!(sampled >= enough_by_samples * limit))
      return sampled;
    const Farthest farthest(m_reference);
    const std::array<Point, 3> t = m_remesh.triangle(f, m_remesh.next_points);
    if(sampled < enough_by_coarse_lattice * limit &&
       farthest.of_lattice_by_walking(t, hint(f), coarse_level).distance < enough_by_coarse_lattice * limit)
      return sampled;
    const double result = (std::max)(sampled, farthest.by_climbing(t, hint(f)).distance);
    if(result >= too_close * limit && result <= limit)
      return (std::max)(result, farthest.by_climbing(t, hint(f), fine_level).distance);
    return result;
  }

  // Whether the largest distance on face f is larger than with the initial points, on a lattice or beyond it, or not clearly
  // smaller at a point that has moved.
  bool exceeds_initial_maximum(std::size_t f) const
  {
    constexpr double margin = 0.995; // for what lattice and climbing miss
    const Farthest farthest(m_reference);
    const std::array<Point, 3> t = m_remesh.triangle(f, m_remesh.next_points),
                               initial_t = m_remesh.triangle(f, m_remesh.initial_points);
    if(farthest.of_lattice(t, hint(f)).distance > farthest.of_lattice(initial_t, hint(f)).distance)
      return true;
    const auto result = farthest.by_climbing(t, hint(f));
    const double initial = farthest.by_climbing(initial_t, hint(f)).distance;
    return result.distance > initial || (result.distance > margin * initial &&
                                         point_at(t, result.coordinates) != point_at(initial_t, result.coordinates));
  }

private:
  // for the first corner of face f, and for its barycenter
  const Hint& hint(std::size_t f) const { return m_vertices.hints[m_remesh.first_vertex(f)]; }
  const Hint& barycenter_hint(std::size_t f) const { return m_midpoints.hints[m_remesh.edge_at_first_vertex(f)]; }

  double distance(const Point& p, const Foot& hint) const
  {
    return distance_to_foot(p, m_reference, m_reference.project(p, hint));
  }

  // Takes sample k at the point to which walking from its foot leads; returns the distance.
  double walk(Samples& samples, std::size_t k, const Point& query)
  {
    samples.offsets[k] = m_reference.point(m_reference.project_locally(query, samples.hints[k])) - query;
    return norm(samples.offsets[k]);
  }

  void measure_barycenter(std::size_t f)
  {
    constexpr double far = 0.1; // relative to the length of edges; other sheets are thought to be farther away
    const Point p = point_at(m_remesh.triangle(f, m_remesh.next_points), barycenter_coordinates);
    const Foot foot = m_reference.project_locally(p, barycenter_hint(f));
    set_barycenter(f, p, foot);
    if(m_orientations[f] != Face_orientation::CONSISTENT || m_distances.at_barycenters[f] > far * m_remesh.length_of_face(f))
      set_barycenter(f, p, m_reference.project(p, foot));
  }

  void set_barycenter(std::size_t f, const Point& p, const Foot& foot)
  {
    m_distances.at_barycenters[f] = distance_to_foot(p, m_reference, foot);
    m_orientations[f] = orientation_at(m_reference, foot, m_remesh.area_normal(f, m_remesh.next_points));
  }

  const Reference& m_reference;
  const Remesh& m_remesh;
  Samples m_vertices, m_midpoints;
  std::vector<Point> m_points; // of the vertices, for which the samples were taken
  Distance_samples m_distances;
  std::vector<Face_orientation> m_orientations; // at the barycenters
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_RESULT_DISTANCES_H
