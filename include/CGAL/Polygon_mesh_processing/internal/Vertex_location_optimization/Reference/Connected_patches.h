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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CONNECTED_PATCHES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CONNECTED_PATCHES_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Patch_tree.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/prefetch.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/triangle_coordinates.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Surface patches on the faces of a mesh, and closest points of them: by searching in their tree, or by walking from patch
// to patch. Besides what `Patch_tree` asks of a patch they have
//   - normal(x), a unit vector, or the null vector where the patch has none;
//   - area(), an approximation;
//   - flat_coordinates(q), those of the projection to the plane of the corners, which may be beyond the sides;
//   - sides_farther_than(x, d2): whether the sides are farther from the point with coordinates x than sqrt(d2).
template <typename Patch>
class Connected_patches
{
  struct Can_cross_all
  {
    bool operator()(Index, Index) const { return true; }
  };

public:
  using Foot = Patch_foot;
  using Hint = Patch_hint;
  using Feet = boost::container::small_vector<Foot, 8>;

  static constexpr bool walks = true;

  Connected_patches() = default;

  // `neighbors[i][k]` is the corner on the other side of the side of patch i that is opposite to its corner k, where the
  // surface may turn by more than a right angle if bit k of `folds[i]` is set
  Connected_patches(Patch_tree<Patch> tree, std::vector<std::array<Index, 3>> neighbors, std::vector<unsigned char> folds)
    : m_tree(std::move(tree)), m_neighbors(std::move(neighbors)), m_folds(std::move(folds))
  {}

  bool is_empty() const { return m_tree.empty(); }
  std::size_t number_of_patches() const { return m_neighbors.size(); }
  const std::vector<Patch>& patches() const { return m_tree.patches(); }
  const Patch& patch(Index i) const { return m_tree.patch(i); }

  Foot project(const Point& query) const { return in_first_patch(m_tree.project(query)); }

  Foot project(const Point& query, const Foot& hint) const
  {
    Coordinates x;
    return in_first_patch(
      m_tree.project(query, hint.patch == no_index ? no_index : approach(query, hint.patch, Can_cross_all(), x)));
  }

  Foot project_locally(const Point& query, const Foot& hint) const
  {
    double distance2;
    Foot foot = foot_in_approached(query, hint.patch, distance2);
    walk([&] { return step_to_neighbor(query, foot, distance2); }, foot, distance2);
    return in_first_patch(foot);
  }

  // The same, but the walk leaves a patch from its inside, too: beyond a concave edge the next patch may be closer. From a
  // corner it goes on in any patch there: along a boundary, the next one may have no side in common with the last.
  Foot project_among_neighbors(const Point& query, const Foot& hint) const
  {
    double distance2;
    Foot foot = foot_in_approached(query, hint.patch, distance2);
    const auto step_to_closer = [&] {
      return step_to_neighbor(query, foot, distance2) || step_across_sides(query, foot, distance2) ||
             (is_at_corner(foot) && step_around(query, foot, distance2, Can_cross_all()));
    };
    walk(step_to_closer, foot, distance2);
    return in_first_patch(foot);
  }

  // Like `project_locally()`, but the walk crosses the side k of a patch only if can_cross(patch, k). At such sides it goes
  // on in any patch around the foot.
  template <typename CanCross>
  Foot project_locally(const Point& query, const Foot& hint, const CanCross& can_cross) const
  {
    double distance2;
    Foot foot = foot_in_approached(query, hint.patch, distance2, can_cross);
    walk([&] { return step_around(query, foot, distance2, can_cross); }, foot, distance2);
    return foot;
  }

  void prefetch(const Foot& hint) const
  {
    vertex_location::prefetch(m_tree.patch(hint.patch));
    vertex_location::prefetch(m_neighbors[hint.patch]);
  }

  Point point(const Foot& foot) const { return m_tree.patch(foot.patch).point(foot.coordinates); }
  Vector normal(const Foot& foot) const { return m_tree.patch(foot.patch).normal(foot.coordinates); }

  // If the foot is on a side or in a corner of its patch, there are several: those reached across sides k of patches with
  // can_cross(patch, k).
  template <typename CanCross = Can_cross_all>
  Feet feet_at(const Foot& foot, const CanCross& can_cross = CanCross()) const
  {
    Feet feet{ foot };
    for(std::size_t i = 0; i < feet.size(); ++i)
      for(Index k = 0; k < 3; ++k)
      {
        const Foot other = foot_across(feet[i], k);
        const auto is_other = [&](const Foot& f) { return f.patch == other.patch; };
        if(other.patch != no_index && can_cross(feet[i].patch, k) && std::none_of(feet.begin(), feet.end(), is_other))
          feet.push_back(other);
      }
    return feet;
  }

  // the corner on the other side of side k of a patch
  Index corner_across(Index patch, Index k) const { return m_neighbors[patch][k]; }

  bool is_closed() const
  {
    return std::all_of(m_neighbors.begin(), m_neighbors.end(), [](const std::array<Index, 3>& corners) {
      return std::find(corners.begin(), corners.end(), no_index) == corners.end();
    });
  }

private:
  // The patch to which going from `patch` straight to `query` leads, as if the patches were flat. Sets the coordinates of
  // `query` there.
  template <typename CanCross>
  Index approach(const Point& query, Index patch, const CanCross& can_cross, Coordinates& coordinates) const
  {
    constexpr int max_steps = 16; // for hints farther away, the steps would cost more than they save
    for(int step = 0;; ++step)
    {
      coordinates = m_tree.patch(patch).flat_coordinates(query);
      const std::array<double, 3> lambda = coordinates.barycentric();
      const auto k = std::min_element(lambda.begin(), lambda.end()) - lambda.begin();
      if(step == max_steps || !(lambda[k] < 0) || m_neighbors[patch][k] == no_index ||
         !can_cross(patch, static_cast<Index>(k)))
        return patch;
      patch = m_neighbors[patch][k] / 3;
    }
  }

  // the foot in the patch that is approached, and its squared distance
  template <typename CanCross = Can_cross_all>
  Foot foot_in_approached(const Point& query,
                          const Index hint,
                          double& squared_distance,
                          const CanCross& can_cross = CanCross()) const
  {
    Coordinates x;
    const Index patch = approach(query, hint, can_cross, x);
    const std::array<double, 3> lambda = x.barycentric();
    if(!std::all_of(lambda.begin(), lambda.end(), [](double l) { return l >= 0; }))
      return m_tree.project_to_patch(query, patch, squared_distance);
    // the estimate of the foot is known
    squared_distance = (std::numeric_limits<double>::max)();
    m_tree.patch(patch).improve_foot(query, x, squared_distance);
    return { patch, x };
  }

  // Where patches meet, each of them has the closest point, and rounding would choose among their normals.
  Foot in_first_patch(const Foot& foot) const
  {
    if(is_inside(foot.coordinates.barycentric()))
      return foot;
    const Feet feet = feet_at(foot);
    return *std::min_element(feet.begin(), feet.end(), [](const Foot& a, const Foot& b) { return a.patch < b.patch; });
  }

  // The same point in the neighbor across side k; in none if the foot is not on that side or there is no neighbor.
  Foot foot_across(const Foot& foot, const Index k) const
  {
    const std::array<double, 3> lambda = foot.coordinates.barycentric();
    const Index corner = m_neighbors[foot.patch][k];
    if(lambda[k] > boundary_tolerance || corner == no_index)
      return {};
    // the common side runs the other way in the neighbor
    std::array<double, 3> mu;
    mu[corner % 3] = 0;
    mu[(corner + 1) % 3] = lambda[(k + 2) % 3];
    mu[(corner + 2) % 3] = lambda[(k + 1) % 3];
    return { corner / 3, { mu[1], mu[2] } };
  }

  // Takes steps, which set the foot and its squared distance, as long as they lead closer. It stops once the distance is
  // negligible: around a vertex at the query, rounding errors would prolong the walk without gain.
  template <typename Step>
  void walk(const Step& step, const Foot& foot, const double& squared_distance) const
  {
    constexpr int enough_steps = 16;
    constexpr double negligible = 1e-28; // relative to the area of a patch
    for(int number = 0; step(); ++number)
      if(number >= enough_steps && squared_distance < negligible * m_tree.patch(foot.patch).area())
        return;
  }

  // Steps across a side that has the foot, if the patch there has a closer point.
  bool step_to_neighbor(const Point& query, Foot& foot, double& squared_distance) const
  {
    for(Index k = 0; k < 3; ++k)
    {
      Foot neighbor = foot_across(foot, k);
      if(neighbor.patch != no_index &&
         m_tree.patch(neighbor.patch).improve_foot_from(query, neighbor.coordinates, squared_distance))
      {
        foot = neighbor;
        return true;
      }
    }
    return false;
  }

  // Steps to any patch that has the foot, if it has a closer point.
  template <typename CanCross>
  bool step_around(const Point& query, Foot& foot, double& squared_distance, const CanCross& can_cross) const
  {
    for(Foot other : feet_at(foot, can_cross))
      if(other.patch != foot.patch &&
         m_tree.patch(other.patch).improve_foot_from(query, other.coordinates, squared_distance))
      {
        foot = other;
        return true;
      }
    return false;
  }

  // Steps across any side, wherever in the patch the foot is, if the patch there has a closer point. Points beyond a side
  // that is farther away than the query are farther away, too, unless the surface folds back there.
  bool step_across_sides(const Point& query, Foot& foot, double& squared_distance) const
  {
    const Index patch = foot.patch;
    const std::array<bool, 3> is_far = m_tree.patch(patch).sides_farther_than(foot.coordinates, squared_distance);
    for(Index k = 0; k < 3; ++k)
    {
      const Index corner = m_neighbors[patch][k];
      if(corner != no_index && (!is_far[k] || (m_folds[patch] >> k & 1)) &&
         m_tree.improve_foot(query, corner / 3, foot, squared_distance))
        return true;
    }
    return false;
  }

  static bool is_at_corner(const Foot& foot)
  {
    const std::array<double, 3> lambda = foot.coordinates.barycentric();
    return *std::max_element(lambda.begin(), lambda.end()) >= 1 - boundary_tolerance;
  }

  Patch_tree<Patch> m_tree;
  std::vector<std::array<Index, 3>> m_neighbors;
  std::vector<unsigned char> m_folds;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CONNECTED_PATCHES_H
