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

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/climb_to_far_point.h>
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
struct Distant_sample
{
  Index initial_face; // with the vertices at the initial points
  Index face;         // at the next points
};

// The distance from the reference to the remesh with its vertices at the initial and at the next points, at samples that are
// taken for this alone: a remesh is closer to the samples that it was fitted to than to what is between them.
template <typename Reference>
class Distances_from_reference
{
  using Tree = Patch_tree<Flat_triangle>;

public:
  Distances_from_reference(const Reference& reference, const Remesh& remesh) : m_reference(reference), m_remesh(remesh) {}

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
    m_initial_maximum = maximum(tree);
  }

  // measures the next points
  template <typename ConcurrencyTag>
  void measure()
  {
    measure<ConcurrencyTag>(all_samples());
  }

  // measures again the samples whose closest points are in these faces
  template <typename ConcurrencyTag>
  void update(const std::vector<Index>& faces)
  {
    if(m_samples.empty())
      return;
    std::vector<char> has_changed(m_remesh.number_of_faces(), false);
    for(Index f : faces)
      has_changed[f] = true;
    measure<ConcurrencyTag>(
      find_indices<ConcurrencyTag>(m_samples.size(), [&](std::size_t i) { return has_changed[m_samples[i].face]; }));
  }

  // Where faces that were measured again, or walking, may have hidden closer points it is too soon to give up.
  template <typename ConcurrencyTag>
  void measure_exactly()
  {
    search<ConcurrencyTag>(all_samples());
  }

  // with the vertices at the initial points
  template <typename ConcurrencyTag>
  Approximation_error initial_error() const
  {
    return error<ConcurrencyTag>(&Sample::initial_distance, m_initial_maximum);
  }

  template <typename ConcurrencyTag>
  Approximation_error error() const
  {
    if(m_samples.empty())
      return {};
    return error<ConcurrencyTag>(&Sample::distance, maximum(make_face_tree(m_remesh, m_remesh.next_points)));
  }

  double initial_mean() const { return mean_of(&Sample::initial_distance); }
  double mean() const { return mean_of(&Sample::distance); }

  // The integrals of the distance that is closest to each face at first: there, and by how much they have grown.
  std::pair<std::vector<double>, std::vector<double>> initial_integrals_and_changes() const
  {
    std::vector<double> initial(m_remesh.number_of_faces(), 0), changes = initial;
    for(const Sample& s : m_samples)
    {
      initial[s.initial_face] += double(s.weight) * s.initial_distance;
      changes[s.initial_face] += s.weight * (double(s.distance) - s.initial_distance);
    }
    return { std::move(initial), std::move(changes) };
  }

  // The samples, and points of the reference to which climbing from them leads, whose distance exceeds the largest one with
  // the initial points and what it was there.
  std::vector<Distant_sample> find_distant() const
  {
    std::vector<Far_point> far_points;
    const auto may_be_near_to_one = [&](const Sample& s) { return s.distance > close * m_initial_maximum; };
    if(std::any_of(m_samples.begin(), m_samples.end(), may_be_near_to_one))
    {
      const Tree tree = make_face_tree(m_remesh, m_remesh.next_points);
      for(const Sample& s : m_samples)
        if(may_be_near_to_one(s))
          add_far_point(s, tree, far_points);
    }
    std::vector<Distant_sample> result;
    if(far_points.empty())
      return result;
    const Tree initial_tree = make_face_tree(m_remesh, m_remesh.initial_points); // one tree at a time
    for(const Far_point& q : far_points)
    {
      const Far_point initial = find_closest_face(initial_tree, q.point, q.face);
      if(q.distance > initial.distance)
        result.push_back({ initial.face, q.face });
    }
    return result;
  }

private:
  struct Sample
  {
    Point point;
    float weight;             // the area that it stands for, in any unit; 0 in the corners of the reference
    Index initial_face, face; // where the closest points are
    float initial_distance, distance;
  };

  // The farthest points of a flat reference most often are corners of it. Where it is much finer than the remesh they are too
  // many, and climbing leads to them; where it is coarse the middles of its sides are as far away.
  template <typename ConcurrencyTag, typename HintOfFace>
  void take_samples(const HintOfFace& hint)
  {
    constexpr std::size_t samples_per_face = 5, least = 8192, most = 49152; // they trade time for exactness
    const double area = m_reference.area();
    if(!(area > 0))
      return;
    const std::size_t n = std::clamp(samples_per_face * m_remesh.number_of_faces(), least, most);
    const auto add = [&](const auto& foot, double area_of_sample) {
      m_samples.push_back({ m_reference.point(foot), static_cast<float>(area_of_sample / area * n), 0, 0, 0, 0 });
    };
    m_samples.reserve(n);
    take_area_samples<ConcurrencyTag>(m_reference, m_remesh, n, hint, add);
    constexpr std::size_t most_patches_per_sample = 4; // with half as many corners
    m_has_corners = m_reference.number_of_patches() <= most_patches_per_sample * n;
    if(m_has_corners)
      m_reference.for_each_corner([&](const auto& foot) { add(foot, 0); });
    if constexpr(Reference::walks)
      if(m_reference.number_of_patches() <= n)
        for_each_middle_of_side(m_reference, [&](const Patch_foot& foot) { add(foot, 0); });
  }

  double mean_of(float Sample::*distance) const { return error<Sequential_tag>(distance, 0).mean; }

  template <typename ConcurrencyTag>
  Approximation_error error(float Sample::*distance, const double max) const
  {
    Approximation_error result = sum_over_indices<ConcurrencyTag, Error_integral>(m_samples.size(), [&](std::size_t i) {
                                   const double weight = m_samples[i].weight, d = m_samples[i].*distance;
                                   return Error_integral{ weight, weight * d, weight * square(d), d };
                                 }).error();
    result.max = max;
    return result;
  }

  // The largest distance to the faces in `tree`, of the samples with the largest distances and of the points to which
  // climbing from these leads.
  double maximum(const Tree& tree) const
  {
    constexpr std::size_t max_samples = 256; // it trades time for a maximum that is elsewhere
    const std::vector<Index> all = all_samples();
    std::vector<Index> farthest((std::min)(max_samples, m_samples.size()));
    std::partial_sort_copy(all.begin(), all.end(), farthest.begin(), farthest.end(), [&](Index i, Index j) {
      return std::make_pair(-m_samples[i].distance, i) < std::make_pair(-m_samples[j].distance, j);
    });
    double largest = 0;
    for(Index i : farthest)
    {
      const Sample& s = m_samples[i];
      const double distance = find_closest_face(tree, s.point, s.face).distance;
      largest = (std::max)({ largest, distance, distance >= close * largest ? climb(s, tree, largest).distance : 0 });
    }
    return largest;
  }

  Far_point climb(const Sample& s, const Tree& tree, const double limit) const
  {
    return climb_to_far_point(m_reference, s.point, tree, s.face, !m_has_corners, limit);
  }

  void add_far_point(const Sample& s, const Tree& tree, std::vector<Far_point>& far_points) const
  {
    const Far_point top = climb(s, tree, m_initial_maximum);
    if(top.distance > m_initial_maximum)
      far_points.push_back(top);
  }

  std::vector<Index> all_samples() const
  {
    std::vector<Index> result(m_samples.size());
    std::iota(result.begin(), result.end(), Index(0));
    return result;
  }

  // By walking from the last closest points, where these are near; where walking may have led astray by a search.
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
      const Far_point closest = find_closest_face(tree, s.point, s.face);
      if(closest.face < m_remesh.number_of_faces()) // not one of the surroundings
        s.face = closest.face;
      s.distance = static_cast<float>(closest.distance);
    });
  }

  // relative to the maximum; from samples of less, climbing is not thought to lead above it
  static constexpr double close = 0.6;

  const Reference& m_reference;
  const Remesh& m_remesh;
  std::vector<Sample> m_samples;
  bool m_has_corners = false; // of the reference, among the samples
  double m_initial_maximum = 0;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_DISTANCES_FROM_REFERENCE_H
