// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_REFERENCE_SAMPLES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_REFERENCE_SAMPLES_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/memory.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
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

// What is kept of a foot to be the hint for the next one: the foot, unless the surface says that less is enough.
template <typename Surface, typename = void>
struct Hint_type
{
  using type = typename Surface::Foot;
};

template <typename Surface>
struct Hint_type<Surface, std::enable_if_t<std::is_convertible<typename Surface::Hint, typename Surface::Foot>::value>>
{
  using type = typename Surface::Hint;
};

template <typename Surface>
using Hint_of = typename Hint_type<Surface>::type;

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

// asks for what the above reads first
template <typename ReferenceSurface>
void prefetch_near(const ReferenceSurface& reference, const typename ReferenceSurface::Foot& hint)
{
  if constexpr(Can_project_near<ReferenceSurface>::value)
    reference.prefetch(hint);
}

// When a foot is computed anew.
struct Sampling_tolerance
{
  double path;     // not before its query has gone so far
  double distance; // by so much it may be farther away than the closest point
  bool slides;     // whether it moves along with its query in the tangent plane until then
};

// The points and normals of the reference at the feet of queries, which move from iteration to iteration. There are four
// samples a vertex, and they make most of the memory: what need not be exact is kept in less.
template <typename Hint>
class Reference_samples
{
public:
  // no tolerance may let a query go as far as a quarter of `mean_edge_length`
  Reference_samples(const std::size_t n, const double mean_edge_length, const bool has_normals)
    : m_path_unit((std::max)(0.25 * mean_edge_length / max_path, (std::numeric_limits<double>::min)())),
      m_offsets(n, NULL_VECTOR), m_normals(has_normals ? n : 0, NULL_VECTOR), m_hints(n), m_paths(n, 0)
  {}

  std::size_t size() const { return m_hints.size(); }
  bool empty() const { return m_hints.empty(); }

  const Vector& offset(std::size_t i) const { return m_offsets[i]; } // from the query to the point
  const Vector& normal(std::size_t i) const { return m_normals[i]; } // unit or null
  const Hint& hint(std::size_t i) const { return m_hints[i]; } // for the foot

  // keeps the offsets and hints alone
  void end_updates()
  {
    release(m_normals);
    release(m_paths);
  }

  // moves the point of sample i off its foot
  void set_offset(std::size_t i, const Vector& offset) { m_offsets[i] = offset; }

  // takes sample i at the closest point to `query`; `hint` is the foot of a point nearby
  template <typename ReferenceSurface, typename... Hints>
  void project(std::size_t i, const ReferenceSurface& reference, const Point& query, const Hints&... hint)
  {
    set_foot(i, reference, query, reference.project(convert<typename ReferenceSurface::Point_3>(query), hint...));
  }

  // takes sample i at `foot`, that of `query`
  template <typename ReferenceSurface, typename Foot>
  void set_foot(std::size_t i, const ReferenceSurface& reference, const Point& query, const Foot& foot)
  {
    m_offsets[i] = convert<Point>(reference.point(foot)) - query;
    if(!m_normals.empty())
      m_normals[i] = convert<Vector>(reference.normal(foot));
    m_hints[i] = foot;
    m_paths[i] = 0;
  }

  // Tells sample i that its query has moved by `displacement`; returns whether the foot must be computed anew, with
  // `update()`. For a sample without a normal `off_tangent_plane()` is the part of the displacement off the tangent plane.
  template <typename OffTangentPlane>
  bool move(std::size_t i,
            const Sampling_tolerance& tolerance,
            const Vector& displacement,
            const OffTangentPlane& off_tangent_plane)
  {
    const double path = m_paths[i] * m_path_unit + norm(displacement);
    if(!(path <= tolerance.path))
      return true;
    m_paths[i] = static_cast<Path>((std::min)(max_path, std::ceil(path / m_path_unit)));

    if(!tolerance.slides)
      m_offsets[i] = m_offsets[i] - displacement;
    else if(m_normals.empty())
      m_offsets[i] = m_offsets[i] - off_tangent_plane();
    else
      m_offsets[i] = m_offsets[i] - (displacement * normal(i)) * normal(i);
    return false;
  }

  // Moves sample i to the foot of `query`: to where walking from the last foot leads. The tree is asked only if that point
  // is so far away that the closest one may be nearer by more than the tolerance.
  template <typename ReferenceSurface>
  void update(std::size_t i, const ReferenceSurface& reference, const Sampling_tolerance& tolerance, const Point& query)
  {
    set_foot(i, reference, query, project_near(reference, query, hint(i)));
    if(!(norm(offset(i)) <= tolerance.distance))
      project(i, reference, query, hint(i));
  }

private:
  // how far a query has gone since its foot was computed, in units
  using Path = std::uint16_t;
  static constexpr double max_path = (std::numeric_limits<Path>::max)();

  double m_path_unit;
  std::vector<Vector> m_offsets;
  std::vector<Vector> m_normals;
  std::vector<Hint> m_hints; // from the last feet
  std::vector<Path> m_paths;
};

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_REFERENCE_SAMPLES_H
