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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CLOSEST_POINTS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CLOSEST_POINTS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The tolerances of the samples between the first and the last iteration. Lengths are relative to those of the edges of the
// remesh around each query.
struct Sampling_tolerance
{
  double travel;   // how far a query may move before its closest point is searched again
  double distance; // how much farther away the point found may be than the closest one
  bool slides;     // whether a sample moves along with its query in the tangent plane until then
};

// Where the samples are, seen from their queries, and where to search for them again.
template <typename Hint>
struct Sample_offsets
{
  std::vector<Vector> offsets;
  std::vector<Hint> hints; // from the last feet
};

// The points and normals of the reference that are closest to queries, which move from iteration to iteration. There are
// four samples a vertex, and they make most of the memory: what need not be exact is kept in less.
template <typename Hint>
class Closest_points
{
public:
  Closest_points() = default;

  Closest_points(const std::size_t n, const bool has_normals)
    : m_samples{ std::vector<Vector>(n, NULL_VECTOR), std::vector<Hint>(n) }, m_normals(has_normals ? n : 0, NULL_VECTOR),
      m_travels(n, 0)
  {}

  std::size_t size() const { return m_travels.size(); }
  bool empty() const { return m_travels.empty(); }

  const Vector& offset(std::size_t i) const { return m_samples.offsets[i]; } // from the query to the point
  const Vector& normal(std::size_t i) const { return m_normals[i]; }         // unit or null
  const Hint& hint(std::size_t i) const { return m_samples.hints[i]; }       // for the foot

  // the samples for good, without what is needed to go on
  Sample_offsets<Hint> take_offsets() && { return std::move(m_samples); }

  // moves the point of sample i off its foot
  void set_offset(std::size_t i, const Vector& offset) { m_samples.offsets[i] = offset; }

  // takes sample i at the closest point to `query`; `hint` is the foot of a point nearby
  template <typename Reference>
  void project(std::size_t i, const Reference& reference, const Point& query, const Hint& hint)
  {
    set_foot(i, reference, query, reference.project(query, hint));
  }

  // takes sample i at `foot`, that of `query`
  template <typename Reference, typename Foot>
  void set_foot(std::size_t i, const Reference& reference, const Point& query, const Foot& foot)
  {
    m_samples.offsets[i] = reference.point(foot) - query;
    if(!m_normals.empty())
      m_normals[i] = reference.normal(foot);
    m_samples.hints[i] = foot;
    m_travels[i] = 0;
  }

  // Tells sample i that its query, where the edges have the length `length`, has moved by `displacement`; returns whether
  // the closest point must be searched again, with `update()`. For a sample without a normal, `off_tangent_plane()` is the
  // normal component of the displacement.
  template <typename OffTangentPlane>
  bool move(std::size_t i,
            const Sampling_tolerance& tolerance,
            const Vector& displacement,
            const double length,
            const OffTangentPlane& off_tangent_plane)
  {
    const double travel = m_travels[i] * travel_unit + norm(displacement) / length;
    if(!(travel <= tolerance.travel))
      return true;
    m_travels[i] = static_cast<Travel>((std::min)(max_travel, std::ceil(travel / travel_unit)));

    Vector& offset = m_samples.offsets[i];
    if(!tolerance.slides)
      offset = offset - displacement;
    else if(m_normals.empty())
      offset = offset - off_tangent_plane();
    else
      offset = offset - (displacement * normal(i)) * normal(i);
    return false;
  }

  // Moves sample i to the point closest to `query` around the last one. The whole reference is searched only if that is so
  // far away that the closest point may be nearer by more than the tolerance.
  template <typename Reference>
  void update(
    std::size_t i, const Reference& reference, const Sampling_tolerance& tolerance, const Point& query, const double length)
  {
    set_foot(i, reference, query, reference.project_locally(query, hint(i)));
    if(!(norm(offset(i)) <= tolerance.distance * length))
      project(i, reference, query, hint(i));
  }

private:
  // how far a query has gone since its closest point was found, in units; no tolerance may be as large as a quarter
  using Travel = std::uint16_t;
  static constexpr double max_travel = (std::numeric_limits<Travel>::max)(), travel_unit = 0.25 / max_travel;

  Sample_offsets<Hint> m_samples;
  std::vector<Vector> m_normals;
  std::vector<Travel> m_travels;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CLOSEST_POINTS_H
