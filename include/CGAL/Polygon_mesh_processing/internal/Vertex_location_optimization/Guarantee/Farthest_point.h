// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FARTHEST_POINT_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FARTHEST_POINT_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Reference_access.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/triangle_coordinates.h>

#include <array>
#include <utility>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Finds the point of a triangle that is farthest from the reference.
template <typename Reference>
class Farthest_point
{
  using Foot = typename Reference::Foot;
  using Triangle = std::array<Point, 3>;

public:
  struct Result
  {
    double distance;
    Coordinates coordinates; // in the triangle
    Foot foot;
  };

  static constexpr int default_level = 8; // 45 points

  explicit Farthest_point(const Reference& reference) : m_reference(reference) {}

  // The best of a lattice, with `level` + 1 points on each side. `hint` is for the corner 0.
  Result of_lattice(const Triangle& t, const Foot& hint, const int level = default_level) const
  {
    return of_lattice(t, hint, level, [&](const Point& p, const Foot& h) { return m_reference.project(p, h); });
  }

  // The same, but the distances may be too large, as the closest points are only searched around the last ones.
  Result of_lattice_by_walking(const Triangle& t, const Foot& hint, const int level) const
  {
    return of_lattice(t, hint, level, [&](const Point& p, const Foot& h) { return m_reference.project_locally(p, h); });
  }

  // The point to which climbing from that on the lattice leads.
  Result by_climbing(const Triangle& t, const Foot& hint, const int level = default_level) const
  {
    constexpr int number_of_halvings = 5; // of the step: down to 1/64 of that of the lattice
    Result best = of_lattice(t, hint, level);
    double step = 0.5 / level;
    for(int i = 0; i < number_of_halvings; ++i, step /= 2)
    {
      const Result center = best;
      for(const auto& [u, v] :
          { std::pair(1, 0), std::pair(0, 1), std::pair(-1, 1), std::pair(-1, 0), std::pair(0, -1), std::pair(1, -1) })
      {
        const Coordinates x{ center.coordinates.u + step * u, center.coordinates.v + step * v };
        if(x.u < 0 || x.v < 0 || x.u + x.v > 1)
          continue;
        const Point p = point_at(t, x);
        const Foot foot = m_reference.project(p, center.foot);
        const double distance = distance_to_foot(p, m_reference, foot);
        if(distance > best.distance)
          best = { distance, x, foot };
      }
    }
    return best;
  }

private:
  // From row to row it goes to and fro: each foot is a hint for the next.
  template <typename Project>
  Result of_lattice(const Triangle& t, const Foot& hint, const int level, const Project& project) const
  {
    Foot foot = hint;
    Result best{ -1, barycenter_coordinates, foot };
    for(int i = 0; i <= level; ++i)
      for(int k = 0; k <= level - i; ++k)
      {
        const int j = i % 2 == 0 ? k : level - i - k;
        const Coordinates x{ double(i) / level, double(j) / level };
        const Point p = point_at(t, x);
        foot = project(p, foot);
        const double distance = distance_to_foot(p, m_reference, foot);
        if(distance > best.distance)
          best = { distance, x, foot };
      }
    return best;
  }

  const Reference& m_reference;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FARTHEST_POINT_H
