// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_TAKE_BACK_HARM_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_TAKE_BACK_HARM_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/correct_flips.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Flat_triangle.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// The distance to the reference of the targets' surface, sampled at the vertices, the midpoints of the edges and the
// barycenters of the faces. With the weights 1/20, 2/15 and 9/20 these points integrate cubics exactly.
template <typename ReferenceSurface>
class Sampled_error
{
  using Foot = typename ReferenceSurface::Foot;
  using State = Optimization_state<Foot>;

public:
  Sampled_error(const ReferenceSurface& reference, const State& state) : m_reference(reference), m_state(state) {}

  template <typename ConcurrencyTag>
  void sample()
  {
    const Mesh_arrays& mesh = m_state.mesh;
    m_at_vertex.resize(mesh.points.size());
    m_at_midpoint.resize(mesh.edges.size());
    m_at_barycenter.resize(mesh.faces.size());
    m_opposes.resize(mesh.faces.size());
    for_each_index<ConcurrencyTag>(mesh.points.size(), [&](std::size_t i) { sample_vertex(i); });
    for_each_index<ConcurrencyTag>(mesh.edges.size(), [&](std::size_t e) { sample_midpoint(e); });
    for_each_index<ConcurrencyTag>(mesh.faces.size(), [&](std::size_t f) { sample_barycenter(f); });
  }

  // samples anew what has changed with the target of vertex i
  void update(std::size_t i)
  {
    sample_vertex(i);
    m_state.for_each_corner(i, [&](Index c)
    {
      sample_midpoint(m_state.mesh.opposite_edge(Mesh_arrays::next(c)));
      sample_midpoint(m_state.mesh.opposite_edge(Mesh_arrays::previous(c)));
      sample_barycenter(c / 3);
    });
  }

  double area(std::size_t f) const
  {
    const std::array<Point, 3> t = triangle(f);
    return norm(area_normal(t[0], t[1], t[2])) / 2;
  }

  // integral of the distance over face f
  double integral(std::size_t f) const
  {
    double at_vertices = 0, at_midpoints = 0;
    for(int k = 0; k < 3; ++k)
    {
      at_vertices += m_at_vertex[m_state.mesh.faces[f][k]];
      at_midpoints += m_at_midpoint[m_state.mesh.face_edges[f][k]];
    }
    return area(f) * (at_vertices / 20 + at_midpoints * 2 / 15 + m_at_barycenter[f] * 9 / 20);
  }

  template <typename ConcurrencyTag>
  double mean() const
  {
    const std::size_t n = m_state.mesh.faces.size();
    const double total_area = sum_over_indices<ConcurrencyTag, double>(n, [&](std::size_t f) { return area(f); });
    const double total = sum_over_indices<ConcurrencyTag, double>(n, [&](std::size_t f) { return integral(f); });
    return total_area > 0 ? total / total_area : 0;
  }

  template <typename ConcurrencyTag>
  double maximum() const
  {
    double sampled = 0;
    for(const std::vector<double>* distances : { &m_at_vertex, &m_at_midpoint, &m_at_barycenter })
      for(double d : *distances)
        sampled = (std::max)(sampled, d);

    std::vector<double> maxima(m_state.mesh.faces.size());
    for_each_index<ConcurrencyTag>(maxima.size(), [&](std::size_t f) { maxima[f] = maximum(f, sampled); });
    return maxima.empty() ? 0 : *std::max_element(maxima.begin(), maxima.end());
  }

  // Whether the normal of face f opposes that of the reference at the foot of the barycenter.
  bool opposes_reference(std::size_t f) const { return m_opposes[f] != 0; }

  // The largest distance on face f. If the samples come near `threshold`, it is looked for on a finer lattice and by
  // climbing from the best point of that.
  double maximum(std::size_t f, double threshold) const
  {
    constexpr double near = 0.6;
    constexpr int level = 8, number_of_halvings = 5;

    double sampled = m_at_barycenter[f];
    for(int k = 0; k < 3; ++k)
      sampled = (std::max)({ sampled, m_at_vertex[m_state.mesh.faces[f][k]], m_at_midpoint[m_state.mesh.face_edges[f][k]] });
    if(sampled < near * threshold)
      return sampled;

    const std::array<Point, 3> t = triangle(f);
    const Foot& hint = m_state.vertex_feet[m_state.mesh.faces[f][0]];
    Coordinates best{ 0, 0 };
    double result = -1;
    auto try_point = [&](const Coordinates& x)
    {
      if(x.u < 0 || x.v < 0 || x.u + x.v > 1)
        return;
      const double d = distance(point_at(t, x), hint);
      if(d > result)
      {
        result = d;
        best = x;
      }
    };
    for(int i = 0; i <= level; ++i)
      for(int j = 0; j <= level - i; ++j)
        try_point({ double(i) / level, double(j) / level });

    double step = 0.5 / level;
    for(int i = 0; i < number_of_halvings; ++i, step /= 2)
    {
      const Coordinates center = best;
      for(const auto& [u, v] : { std::pair(1, 0), std::pair(0, 1), std::pair(-1, 1),
                                 std::pair(-1, 0), std::pair(0, -1), std::pair(1, -1) })
        try_point({ center.u + step * u, center.v + step * v });
    }
    return (std::max)(sampled, result);
  }

private:
  std::array<Point, 3> triangle(std::size_t f) const
  {
    const std::array<Index, 3>& v = m_state.mesh.faces[f];
    return { m_state.targets[v[0]], m_state.targets[v[1]], m_state.targets[v[2]] };
  }

  double distance(const Point& p, const Foot& hint) const
  {
    const Foot foot = m_reference.project(convert<typename ReferenceSurface::Point_3>(p), hint);
    return norm(convert<Point>(m_reference.point(foot)) - p);
  }

  void sample_vertex(std::size_t i) { m_at_vertex[i] = distance(m_state.targets[i], m_state.vertex_feet[i]); }

  void sample_midpoint(std::size_t e)
  {
    const std::array<Index, 2>& v = m_state.mesh.edges[e];
    m_at_midpoint[e] = distance(midpoint(m_state.targets[v[0]], m_state.targets[v[1]]), m_state.midpoint_feet[e]);
  }

  void sample_barycenter(std::size_t f)
  {
    const std::array<Point, 3> t = triangle(f);
    const Point p = point_at(t, Coordinates());
    const Foot foot = m_reference.project(convert<typename ReferenceSurface::Point_3>(p),
                                          m_state.midpoint_feet[m_state.mesh.face_edges[f][0]]);
    m_at_barycenter[f] = norm(convert<Point>(m_reference.point(foot)) - p);
    m_opposes[f] = area_normal(t[0], t[1], t[2]) * convert<Vector>(m_reference.normal(foot)) < 0;
  }

  const ReferenceSurface& m_reference;
  const State& m_state;
  std::vector<double> m_at_vertex, m_at_midpoint, m_at_barycenter;
  std::vector<char> m_opposes;
};

// What a face of the remesh is compared with.
struct Face_quality
{
  double integral_of_error;
  double max_error;
  bool opposes_reference;
};

// A face is bad if it is flipped, if it opposes the reference and did not, or if its largest error exceeds that of the
// remesh, less a margin for what lies between the samples; if the criterion is strict, also if it has more error in all
// than in the remesh.
template <typename ReferenceSurface>
class Harm_criterion
{
  using State = Optimization_state<typename ReferenceSurface::Foot>;

  static constexpr double sampling_margin = 0.96;

public:
  // measures the remesh, which are the targets at the time of the call
  template <typename ConcurrencyTag>
  static Harm_criterion of_remesh(Sampled_error<ReferenceSurface>& error, const State& state, ConcurrencyTag)
  {
    Harm_criterion result(error, state);
    error.template sample<ConcurrencyTag>();
    result.m_of_remesh.resize(state.mesh.faces.size());
    result.m_mean_error = error.template mean<ConcurrencyTag>();
    result.m_max_error = sampling_margin * error.template maximum<ConcurrencyTag>();
    for_each_index<ConcurrencyTag>(state.mesh.faces.size(), [&](std::size_t f)
    {
      result.m_of_remesh[f] = { error.integral(f), error.maximum(f, result.m_max_error), error.opposes_reference(f) };
    });
    return result;
  }

  bool is_bad(std::size_t f) const
  {
    return m_flips.is_bad(f) ||
           (m_error.opposes_reference(f) && !m_of_remesh[f].opposes_reference) ||
           (m_is_strict && m_error.integral(f) > m_of_remesh[f].integral_of_error) ||
           m_error.maximum(f, m_max_error) > (std::max)(m_max_error, m_of_remesh[f].max_error);
  }

  void update(std::size_t i) { m_error.update(i); }

  double mean_error() const { return m_mean_error; } // of the remesh
  void make_strict() { m_is_strict = true; }
  bool is_strict() const { return m_is_strict; }

private:
  Harm_criterion(Sampled_error<ReferenceSurface>& error, const State& state) : m_flips(state), m_error(error) {}

  Flip_criterion<typename ReferenceSurface::Foot> m_flips;
  Sampled_error<ReferenceSurface>& m_error;
  std::vector<Face_quality> m_of_remesh;
  double m_mean_error = 0;
  double m_max_error = 0; // what a face must not exceed, unless it did in the remesh
  bool m_is_strict = false;
};

// Halves the moves of the vertices of faces that intersect and did not in the remesh; returns whether there were any.
template <typename Foot, typename FacePairs>
bool separate_faces(Optimization_state<Foot>& state,
                    const FacePairs& of_remesh,
                    const FacePairs& of_targets,
                    std::vector<int>& number_of_halvings,
                    std::vector<char>& is_shortened)
{
  constexpr int max_halvings = 6;

  FacePairs pairs;
  std::set_difference(of_targets.begin(), of_targets.end(), of_remesh.begin(), of_remesh.end(), std::back_inserter(pairs));
  std::set<Index> vertices;
  for(const auto& pair : pairs)
    for(Index f : { pair.first, pair.second })
      vertices.insert(state.mesh.faces[f].begin(), state.mesh.faces[f].end());

  bool separated = false;
  for(Index i : vertices)
    if(state.targets[i] != state.initial_points[i])
    {
      state.targets[i] = ++number_of_halvings[i] > max_halvings ? state.initial_points[i]
                                                                : midpoint(state.initial_points[i], state.targets[i]);
      is_shortened[i] = 1;
      separated = true;
    }
  return separated;
}

// The last word of a run: shortens the moves from the remesh to the result where they do harm, so that neither the
// largest nor the mean error is above that of the remesh, as far as `Sampled_error` sees, no face is flipped and, if
// that is tested, no pair of faces intersects that did not before.
//
// `refuse_moves` takes back the moves that the user does not allow, and returns whether there were any;
// `find_self_intersections` is a `Self_intersection_test`.
template <typename ConcurrencyTag, typename ReferenceSurface, typename RefuseMoves, typename FindSelfIntersections>
void take_back_harm(const ReferenceSurface& reference,
                    Optimization_state<typename ReferenceSurface::Foot>& state,
                    const RefuseMoves& refuse_moves,
                    const FindSelfIntersections& find_self_intersections,
                    std::vector<char>& is_shortened)
{
  Sampled_error<ReferenceSurface> error(reference, state);
  state.targets = state.initial_points;
  auto criterion = Harm_criterion<ReferenceSurface>::of_remesh(error, state, ConcurrencyTag());
  const auto intersections_of_remesh = find_self_intersections(state.initial_points);

  state.targets = state.mesh.points;
  std::vector<int> number_of_halvings(state.targets.size(), 0);
  for(;;)
  {
    do
    {
      error.template sample<ConcurrencyTag>();
      shorten_moves<ConcurrencyTag>(state, state.initial_points, criterion, is_shortened);
    }
    while(refuse_moves());

    if(error.template mean<ConcurrencyTag>() > criterion.mean_error())
    {
      if(criterion.is_strict()) // no face has more error, but their areas have changed
      {
        state.targets = state.initial_points;
        break;
      }
      criterion.make_strict();
    }
    else if(!separate_faces(state, intersections_of_remesh, find_self_intersections(state.targets),
                            number_of_halvings, is_shortened))
      break;
  }
  state.mesh.points = state.targets;
}

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_TAKE_BACK_HARM_H
