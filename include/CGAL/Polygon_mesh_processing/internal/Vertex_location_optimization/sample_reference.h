// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_REFERENCE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_REFERENCE_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Optimization_state.h>

#include <type_traits>
#include <utility>

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

// Moves `foot`, the foot of a point that has moved by `displacement`, to the foot of `query`, where that point is now.
//
// `distance_bound` is a lower bound of the distance from the point to the reference: it was the distance when the tree
// was asked last, and decreases with each displacement, as the distance cannot change faster. As long as walking from
// the old foot leads to a point that is not farther away than this bound and `tolerance` together, the tree is not
// asked: no point of the reference is closer by more than `tolerance`.
template <typename ReferenceSurface>
Point update_foot(const ReferenceSurface& reference,
                  const Point& query,
                  const double displacement,
                  const double tolerance,
                  typename ReferenceSurface::Foot& foot,
                  double& distance_bound)
{
  const auto reference_query = convert<typename ReferenceSurface::Point_3>(query);
  if constexpr(Can_project_near<ReferenceSurface>::value)
  {
    distance_bound -= displacement;
    foot = reference.project_near(reference_query, foot);
    const Point p = convert<Point>(reference.point(foot));
    if(norm(p - query) <= distance_bound + tolerance)
      return p;
  }
  foot = reference.project(reference_query, foot);
  const Point p = convert<Point>(reference.point(foot));
  distance_bound = norm(p - query);
  return p;
}

// Section 3.1: takes p_i and n_i from the reference at the foot of each vertex, m_ij at the foot of the midpoint of each
// edge. The feet may be farther away than the closest points by a tolerance, see `update_foot()`, but not in the first
// iteration nor if `is_exact`.
template <typename ConcurrencyTag, typename ReferenceSurface>
void sample_reference(const ReferenceSurface& reference,
                      Optimization_state<typename ReferenceSurface::Foot>& state,
                      const bool is_first,
                      const bool is_exact)
{
  using Reference_point = typename ReferenceSurface::Point_3;
  const Mesh_arrays& mesh = state.mesh;
  const std::vector<Point>& previous_points = state.targets;
  const double tolerance = is_exact ? 0 : state.foot_tolerance();

  for_each_index<ConcurrencyTag>(mesh.points.size(), [&](std::size_t i)
  {
    auto& foot = state.vertex_feet[i];
    const Point& query = mesh.points[i];
    if(is_first)
    {
      foot = reference.project(convert<Reference_point>(query));
      state.vertex_samples[i] = convert<Point>(reference.point(foot));
      state.vertex_distance_bounds[i] = norm(state.vertex_samples[i] - query);
    }
    else
      state.vertex_samples[i] = update_foot(reference, query, norm(query - previous_points[i]), tolerance, foot,
                                            state.vertex_distance_bounds[i]);
    state.vertex_normals[i] = convert<Vector>(reference.normal(foot));
  });

  for_each_index<ConcurrencyTag>(mesh.edges.size(), [&](std::size_t e)
  {
    const Index i = mesh.edges[e][0], j = mesh.edges[e][1];
    auto& foot = state.midpoint_feet[e];
    const Point query = midpoint(mesh.points[i], mesh.points[j]);
    double displacement = 0;
    if(is_first)
    {
      foot = state.vertex_feet[i];
      state.midpoint_distance_bounds[e] = -1; // nothing is known
    }
    else
      displacement = norm(query - midpoint(previous_points[i], previous_points[j]));
    state.midpoint_samples[e] = update_foot(reference, query, displacement, is_first ? 0 : tolerance, foot,
                                            state.midpoint_distance_bounds[e]);
  });
}

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_REFERENCE_H
