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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_DISTANCES_FROM_REFERENCE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_DISTANCES_FROM_REFERENCE_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/Error_integral.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Sampling/Area_samples.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>

#include <CGAL/Polygon_mesh_processing/Vertex_location_optimization_report.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// A point of the reference from which the remesh is too far away, and where the remesh, or what surrounds it, is closest to
// it: faces of `make_face_tree()`.
struct Distant_sample
{
  Index initial_face; // with the vertices at the initial points
  Index face;         // at the next points
};

// The distance from the reference to the remesh with its vertices at the next points, sampled.
template <typename Reference>
class Distances_from_reference
{
public:
  Distances_from_reference(const Reference& reference, const Remesh& remesh, Points_and_faces samples)
    : m_reference(reference), m_remesh(remesh), m_samples(std::move(samples)), m_distances(m_samples.points.size())
  {}

  bool empty() const { return m_distances.empty(); }

  // measures the next points, by walking from the last closest points
  template <typename ConcurrencyTag>
  void measure()
  {
    for_each_index<ConcurrencyTag>(m_distances.size(), [&](std::size_t i) { measure_sample(i); });
  }

  // measures again the samples whose closest points are in these faces
  template <typename ConcurrencyTag>
  void update(const std::vector<Index>& faces)
  {
    std::vector<char> has_changed(m_remesh.number_of_faces(), false);
    for(Index f : faces)
      has_changed[f] = true;
    for_each_index<ConcurrencyTag>(m_distances.size(), [&](std::size_t i) {
      if(has_changed[m_samples.faces[i]])
        measure_sample(i);
    });
  }

  template <typename ConcurrencyTag>
  Approximation_error error() const
  {
    return sum_over_indices<ConcurrencyTag, Error_integral>(
             m_distances.size(), [&](std::size_t i) { return integral_of_sample(m_samples.weights[i], m_distances[i]); })
      .error();
  }

  // Where walking may have led astray it is too soon to give up: searches for all closest points, with the vertices at the
  // next and at the initial points.
  template <typename ConcurrencyTag>
  void measure_exactly()
  {
    const auto search = [&](const std::vector<Point>& points, std::vector<Index>& faces, std::vector<double>& distances) {
      const Patch_tree<Flat_triangle> tree = make_face_tree(m_remesh, points);
      for_each_index<ConcurrencyTag>(faces.size(), [&](std::size_t i) {
        const Patch_foot foot = tree.project(m_samples.points[i], faces[i]);
        if(foot.patch < m_remesh.number_of_faces()) // not one of the surroundings
          faces[i] = foot.patch;
        distances[i] = norm(m_samples.points[i] - tree.point(foot));
      });
    };
    m_initial_faces = m_samples.faces;
    m_initial_distances.resize(m_initial_faces.size());
    search(m_remesh.initial_points, m_initial_faces, m_initial_distances);
    search(m_remesh.next_points, m_samples.faces, m_distances);
  }

  bool is_exact() const { return !m_initial_distances.empty(); }

  // the mean distance with the vertices at the initial points, once it has been measured exactly
  double initial_mean() const
  {
    Error_integral sum;
    for(std::size_t i = 0; i < m_initial_distances.size(); ++i)
      sum += integral_of_sample(m_samples.weights[i], m_initial_distances[i]);
    return sum.error().mean;
  }

  // Calls f(face, d) for each sample, with the face that was closest at first, and by how much the integral of the distance
  // has grown; once it has been measured exactly.
  template <typename F>
  void for_each_change(const F& f) const
  {
    for(std::size_t i = 0; i < m_distances.size(); ++i)
      f(m_initial_faces[i], m_samples.weights[i] * (m_distances[i] - m_initial_distances[i]));
  }

  // The largest distance, of the samples and of the points to which climbing from the largest of them leads.
  double maximum() const
  {
    return largest_distance_from(m_reference, make_face_tree(m_remesh, m_remesh.next_points), m_samples.points, m_distances,
                                 [&](Index i) { return m_samples.faces[i]; });
  }

  // The samples, and points between them to which climbing leads, whose distance exceeds `limit` and was less at first.
  std::vector<Distant_sample> find_distant(const double limit) const
  {
    constexpr double close = 0.5; // relative to the limit; from samples of less climbing is not thought to lead above it
    std::vector<Distant_sample> result;
    std::vector<Index> candidates;
    for(Index i = 0; i < m_distances.size(); ++i)
      if(m_distances[i] > close * limit)
        candidates.push_back(i);
    if(candidates.empty())
      return result;

    // the points that are too far away now, with the faces that are closest, and then those that were not so far at first
    struct Far_point
    {
      Point point;
      Closest closest;
    };
    std::vector<Far_point> far_points;
    {
      const Patch_tree<Flat_triangle> tree = make_face_tree(m_remesh, m_remesh.next_points);
      for(Index i : candidates)
      {
        const auto add = [&](const Point& q) {
          const Closest now = closest_in(tree, q, m_samples.faces[i]);
          if(now.distance > limit)
            far_points.push_back({ q, now });
        };
        const Point& p = m_samples.points[i];
        if(!(closest_in(tree, p, m_samples.faces[i]).distance > close * limit))
          continue;
        const auto height = [&](const auto& foot) {
          return closest_in(tree, m_reference.point(foot), m_samples.faces[i]).distance;
        };
        add(p);
        add(m_reference.point(m_reference.climb(m_reference.project(p), height)));
      }
    }
    if(far_points.empty())
      return result;
    const Patch_tree<Flat_triangle> initial_tree = make_face_tree(m_remesh, m_remesh.initial_points);
    for(const Far_point& q : far_points)
    {
      const Closest initial = closest_in(initial_tree, q.point, q.closest.face);
      if(q.closest.distance > initial.distance)
        result.push_back({ initial.face, q.closest.face });
    }
    return result;
  }

private:
  struct Closest
  {
    Index face;
    double distance;
  };

  static Closest closest_in(const Patch_tree<Flat_triangle>& tree, const Point& query, Index hint)
  {
    const Patch_foot foot = tree.project(query, hint);
    return { foot.patch, norm(query - tree.point(foot)) };
  }

  Closest closest(const Point& query, const std::vector<Point>& points, Index face) const
  {
    Patch_foot foot{ face, Coordinates() };
    walk_to_closest_point(m_remesh, points, query, foot);
    return { foot.patch, norm(query - point_at(m_remesh.triangle(foot.patch, points), foot.coordinates)) };
  }

  void measure_sample(std::size_t i)
  {
    const Closest result = closest(m_samples.points[i], m_remesh.next_points, m_samples.faces[i]);
    m_samples.faces[i] = result.face;
    m_distances[i] = result.distance;
  }

  const Reference& m_reference;
  const Remesh& m_remesh;
  Points_and_faces m_samples;
  std::vector<double> m_distances;
  std::vector<Index> m_initial_faces; // and distances, with the vertices at the initial points, once they are needed
  std::vector<double> m_initial_distances;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_DISTANCES_FROM_REFERENCE_H
