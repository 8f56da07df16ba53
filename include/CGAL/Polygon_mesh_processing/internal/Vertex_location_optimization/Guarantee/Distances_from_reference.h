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

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Maximum_from_reference.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Uncertain_sum.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/Error_integral.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Sampling/Area_samples.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>

#include <CGAL/Polygon_mesh_processing/Vertex_location_optimization_report.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// A point of the reference from which the remesh is too far away, and where the remesh, or what surrounds it, is closest to
// it: faces of `make_face_tree()`.
struct Distant_point
{
  Index initial_face; // with the vertices at the initial points
  Index face;         // at the next points
};

// The distance from the reference to the remesh with its vertices at the initial and at the next points, at samples that are
// used for nothing else: a remesh is closer to the samples that it was fitted to than to the points between them.
template <typename Reference>
class Distances_from_reference
{
  using Tree = Patch_tree<Flat_triangle>;

public:
  Distances_from_reference(const Reference& reference, const Remesh& remesh)
    : m_reference(reference), m_remesh(remesh), m_maximum(reference, remesh)
  {}

  // Takes samples, and measures the initial points, exactly. `hint(f)` is a foot of face f on the reference.
  template <typename ConcurrencyTag, typename HintOfFace>
  void start(const HintOfFace& hint)
  {
    take_samples<ConcurrencyTag>(hint);
    if(m_samples.empty())
      return;
    const Tree tree = make_face_tree(m_remesh, m_remesh.initial_points);
    project_to_faces<ConcurrencyTag>(
      tree, m_samples.size(), [&](std::size_t i) -> const Point& { return m_samples[i].point; },
      [&](std::size_t i, const Patch_foot& foot) {
        Sample& s = m_samples[i];
        s.initial_face = s.face = foot.patch;
        s.initial_distance = s.distance = static_cast<float>(norm(s.point - tree.point(foot)));
      });
    // what is closest to the surroundings is left out
    const auto is_elsewhere = [&](const Sample& s) { return s.face >= m_remesh.number_of_faces(); };
    m_samples.erase(std::remove_if(m_samples.begin(), m_samples.end(), is_elsewhere), m_samples.end());
    if constexpr(Reference::walks)
      m_maximum.template start<ConcurrencyTag>(tree, sampled_maximum(tree));
  }

  // measures the next points
  template <typename ConcurrencyTag>
  void measure()
  {
    measure<ConcurrencyTag>(all_samples());
  }

  // measures again the samples whose closest points are in these faces, which have changed
  template <typename ConcurrencyTag>
  void update(const std::vector<Index>& faces)
  {
    if(m_samples.empty())
      return;
    if constexpr(Reference::walks)
      m_maximum.update(faces);
    std::vector<char> has_changed(m_remesh.number_of_faces(), false);
    for(Index f : faces)
      has_changed[f] = true;
    measure<ConcurrencyTag>(
      find_indices<ConcurrencyTag>(m_samples.size(), [&](std::size_t i) { return has_changed[m_samples[i].face]; }));
  }

  // Closer points may have been missed by walking, or in faces measured again, so that it is too early to give up.
  template <typename ConcurrencyTag>
  void measure_exactly()
  {
    search<ConcurrencyTag>(all_samples());
  }

  // with the vertices at the initial points
  template <typename ConcurrencyTag>
  Approximation_error initial_error() const
  {
    Approximation_error result = integral<ConcurrencyTag>(&Sample::initial_distance).error();
    if constexpr(Reference::walks)
      result.max = m_maximum.initial_maximum();
    return result;
  }

  template <typename ConcurrencyTag>
  Approximation_error error() const
  {
    if(m_samples.empty())
      return {};
    Approximation_error result = integral<ConcurrencyTag>(&Sample::distance).error();
    if constexpr(Reference::walks)
    {
      const Tree tree = make_face_tree(m_remesh, m_remesh.next_points);
      result.max = m_maximum.template maximum<ConcurrencyTag>(tree, sampled_maximum(tree));
    }
    return result;
  }

  // Whether the mean has not risen, by twice its standard error; what is less than `negligible` does not count.
  template <typename ConcurrencyTag>
  bool is_mean_kept(const double negligible) const
  {
    constexpr double rounding = 1e-6; // of the distances, in single precision
    const auto weighted_change = [&](std::size_t i) { return m_samples[i].weight * change(m_samples[i]); };
    // Samples that follow each other are neighbors: the surface is stratified, and the variance is that among neighbors,
    // which is less than that among all.
    const auto total = sum_over_indices<ConcurrencyTag, Uncertain_sum>(m_samples.size(), [&](std::size_t i) {
      const double c = weighted_change(i);
      return Uncertain_sum{ c, i == 0 ? 0 : square(c - weighted_change(i - 1)) / 2 };
    });
    const Error_integral initial = integral<ConcurrencyTag>(&Sample::initial_distance);
    return m_samples.empty() || total.upper_bound() <= rounding * initial.distance + negligible * initial.area;
  }

  // The integrals of the distance over the samples initially closest to each face: the initial ones, and by how much they
  // have grown.
  std::pair<std::vector<double>, std::vector<double>> initial_integrals_and_changes() const
  {
    std::vector<double> initial(m_remesh.number_of_faces(), 0), changes = initial;
    for(const Sample& s : m_samples)
    {
      initial[s.initial_face] += double(s.weight) * s.initial_distance;
      changes[s.initial_face] += s.weight * change(s);
    }
    return { std::move(initial), std::move(changes) };
  }

  // The points of the reference whose distance exceeds the largest one with the initial points.
  template <typename ConcurrencyTag>
  std::vector<Distant_point> find_distant()
  {
    std::vector<Distant_point> result;
    if constexpr(Reference::walks)
    {
      if(m_samples.empty())
        return result;
      const std::vector<Far_point> far_points = m_maximum.template find_beyond<ConcurrencyTag>();
      if(far_points.empty())
        return result;
      const Tree initial_tree = make_face_tree(m_remesh, m_remesh.initial_points);
      for(const Far_point& q : far_points)
        result.push_back({ initial_tree.project(q.point, q.face).patch, q.face });
    }
    return result;
  }

private:
  struct Sample
  {
    Point point;
    float weight;             // the area that it stands for, in any unit
    Index initial_face, face; // where the closest points are
    float initial_distance, distance;
  };

  template <typename ConcurrencyTag, typename HintOfFace>
  void take_samples(const HintOfFace& hint)
  {
    constexpr std::size_t samples_per_face = 5, least = 8192, most = 49152; // they trade time for exactness
    const double area = m_reference.area();
    if(!(area > 0) || m_remesh.number_of_faces() == 0)
      return;
    const std::size_t n = std::clamp(samples_per_face * m_remesh.number_of_faces(), least, most);
    m_samples.reserve(n);
    take_area_samples<ConcurrencyTag>(m_reference, m_remesh, n, hint, [&](const auto& foot, double area_of_sample) {
      m_samples.push_back({ m_reference.point(foot), static_cast<float>(area_of_sample / area * n), 0, 0, 0, 0 });
    });
  }

  static double change(const Sample& s) { return double(s.distance) - s.initial_distance; }

  template <typename ConcurrencyTag>
  Error_integral integral(float Sample::*distance) const
  {
    return sum_over_indices<ConcurrencyTag, Error_integral>(m_samples.size(), [&](std::size_t i) {
      const double weight = m_samples[i].weight, d = m_samples[i].*distance;
      return Error_integral{ weight, weight * d, weight * square(d), d };
    });
  }

  // the largest distance of those samples that have the largest ones, as they were measured
  double sampled_maximum(const Tree& tree) const
  {
    constexpr std::size_t max_samples = 16; // walking may have led astray
    const std::vector<Index> all = all_samples();
    std::vector<Index> farthest((std::min)(max_samples, m_samples.size()));
    std::partial_sort_copy(all.begin(), all.end(), farthest.begin(), farthest.end(), [&](Index i, Index j) {
      return std::make_pair(-m_samples[i].distance, i) < std::make_pair(-m_samples[j].distance, j);
    });
    double largest = 0;
    for(Index i : farthest)
      largest = (std::max)(largest, distance_to_faces(tree, m_samples[i]).second);
    return largest;
  }

  // the face that is closest to a sample, and its distance
  static std::pair<Index, double> distance_to_faces(const Tree& tree, const Sample& s)
  {
    const Patch_foot foot = tree.project(s.point, s.face);
    return { foot.patch, norm(s.point - tree.point(foot)) };
  }

  std::vector<Index> all_samples() const
  {
    std::vector<Index> result(m_samples.size());
    std::iota(result.begin(), result.end(), Index(0));
    return result;
  }

  // By walking from the last closest points if these are near, and by a search where the result of the walk is in doubt.
  template <typename ConcurrencyTag>
  void measure(const std::vector<Index>& indices)
  {
    constexpr double near = 0.1; // relative to the lengths of the edges; other sheets are thought to be farther away
    std::vector<char> is_sure(indices.size());
    for_each_index<ConcurrencyTag>(indices.size(), [&](std::size_t k) {
      Sample& s = m_samples[indices[k]];
      Patch_foot foot{ s.face, Coordinates() };
      walk_to_closest_point(m_remesh, m_remesh.next_points, s.point, foot);
      const Point closest = point_at(m_remesh.triangle(foot.patch, m_remesh.next_points), foot.coordinates);
      s.face = foot.patch;
      s.distance = static_cast<float>(norm(s.point - closest));
      is_sure[k] = s.distance <= near * m_remesh.length_of_face(s.face);
    });
    std::vector<Index> unsure;
    for(std::size_t k = 0; k < is_sure.size(); ++k)
      if(!is_sure[k])
        unsure.push_back(indices[k]);
    search<ConcurrencyTag>(unsure);
  }

  template <typename ConcurrencyTag>
  void search(const std::vector<Index>& indices)
  {
    if(indices.empty())
      return;
    const Tree tree = make_face_tree(m_remesh, m_remesh.next_points);
    for_each_index<ConcurrencyTag>(indices.size(), [&](std::size_t k) {
      Sample& s = m_samples[indices[k]];
      const auto [face, distance] = distance_to_faces(tree, s);
      if(face < m_remesh.number_of_faces()) // not one of the surroundings
        s.face = face;
      s.distance = static_cast<float>(distance);
    });
  }

  const Reference& m_reference;
  const Remesh& m_remesh;
  std::vector<Sample> m_samples;
  Maximum_from_reference<Reference> m_maximum;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_DISTANCES_FROM_REFERENCE_H
