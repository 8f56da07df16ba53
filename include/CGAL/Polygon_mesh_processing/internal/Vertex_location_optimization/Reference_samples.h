// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_REFERENCE_SAMPLES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_REFERENCE_SAMPLES_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/geometry.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

template <typename Surface, typename = void>
struct Can_project_near : std::false_type {};

template <typename Surface>
struct Can_project_near<Surface, std::void_t<decltype(std::declval<const Surface&>().project_near(
                                   std::declval<typename Surface::Point_3>(), std::declval<typename Surface::Foot>()))>>
  : std::true_type {};

// The closest point to `query` as far as walking from `hint` leads, where the reference surface can do that.
template <typename ReferenceSurface>
typename ReferenceSurface::Foot
project_near(const ReferenceSurface& reference, const Point& query, const typename ReferenceSurface::Foot& hint)
{
  const auto q = convert<typename ReferenceSurface::Point_3>(query);
  if constexpr(Can_project_near<ReferenceSurface>::value)
    return reference.project_near(q, hint);
  else
    return reference.project(q, hint);
}

// When a foot is computed anew.
struct Sampling_tolerance
{
  double path;     // not before its query has gone so far
  double distance; // by so much it may be farther away than the closest point
  bool slides;     // whether it moves along with its query in the tangent plane until then
};

// The points and normals of the reference at the feet of queries, which move from iteration to iteration.
template <typename Foot>
class Reference_samples
{
public:
  explicit Reference_samples(std::size_t n)
    : points(n), normals(n, NULL_VECTOR), feet(n), m_distance_bounds(n, 0), m_paths(n, 0)
  {}

  // takes sample i at the closest point to `query`; `hint` is the foot of a point nearby
  template <typename ReferenceSurface, typename... Hint>
  void project(std::size_t i, const ReferenceSurface& reference, const Point& query, const Hint&... hint)
  {
    set_closest(i, reference, query, reference.project(convert<typename ReferenceSurface::Point_3>(query), hint...));
  }

  // takes sample i at `foot`, the closest point to `query`
  template <typename ReferenceSurface>
  void set_closest(std::size_t i, const ReferenceSurface& reference, const Point& query, const Foot& foot)
  {
    set(i, reference, foot);
    m_distance_bounds[i] = norm(points[i] - query);
    m_paths[i] = 0;
  }

  // Moves sample i to the foot of `query`, which has moved by `displacement`: to where walking from the last foot leads. The
  // tree is asked only if that point may be farther away than the closest one by more than the tolerance. The distance of a
  // query to the reference changes by no more than the query moves: what it was when the tree was asked last, less the
  // displacements since, is a lower bound.
  template <typename ReferenceSurface>
  void update(std::size_t i,
              const ReferenceSurface& reference,
              const Sampling_tolerance& tolerance,
              const Point& query,
              const Vector& displacement)
  {
    const double length = norm(displacement);
    m_distance_bounds[i] = (std::max)(0., m_distance_bounds[i] - length);
    m_paths[i] += length;
    if(m_paths[i] <= tolerance.path)
    {
      if(tolerance.slides)
        points[i] = points[i] + (displacement - (displacement * normals[i]) * normals[i]);
      return;
    }

    set(i, reference, project_near(reference, query, feet[i]));
    m_paths[i] = 0;
    if(!(norm(points[i] - query) <= m_distance_bounds[i] + tolerance.distance))
      project(i, reference, query, feet[i]);
  }

  std::vector<Point> points;
  std::vector<Vector> normals; // unit or null
  std::vector<Foot> feet;      // where the points are, or were before they moved in the tangent plane

private:
  template <typename ReferenceSurface>
  void set(std::size_t i, const ReferenceSurface& reference, const Foot& foot)
  {
    feet[i] = foot;
    points[i] = convert<Point>(reference.point(foot));
    normals[i] = convert<Vector>(reference.normal(foot));
  }

  std::vector<double> m_distance_bounds; // from the queries to the reference
  std::vector<double> m_paths;           // of the queries since their feet were computed
};

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_REFERENCE_SAMPLES_H
