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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PATCH_TREE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PATCH_TREE_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Patch_order.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/triangle_coordinates.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/compatibility.h>

#include <boost/container/small_vector.hpp>
#include <boost/range/adaptor/transformed.hpp>
#include <boost/range/irange.hpp>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// A point of a reference surface: its patch and the coordinates in the patch.
struct Patch_foot
{
  Index patch = no_index;
  Coordinates coordinates;
};

// What is kept of a foot as a hint: its patch.
class Patch_hint
{
public:
  Patch_hint() = default;
  Patch_hint(const Patch_foot& foot) : m_patch(foot.patch) {}

  operator Patch_foot() const { return { m_patch, Coordinates() }; }

private:
  Index m_patch = no_index;
};

inline double squared_distance_to_box(const Point& p, const Bbox_3& box)
{
  const auto to_slab = [](double x, double min, double max) { return x - (std::min)((std::max)(x, min), max); };
  return square(to_slab(p.x(), box.xmin(), box.xmax())) + square(to_slab(p.y(), box.ymin(), box.ymax())) +
         square(to_slab(p.z(), box.zmin(), box.zmax()));
}

// Patches in an AABB tree, for closest points. A patch is a parameterized part of a surface or curve with
//   - bbox(), a box that contains it;
//   - point(x), its point with the coordinates x;
//   - estimate_foot(q), which is cheap;
//   - improve_foot(q, x, d2): if the patch has a point that is closer to q than sqrt(d2), sets x, which must be those of
//     the estimate, to its coordinates and d2 to its squared distance, and returns true;
//   - improve_foot_from(q, x, d2), the same with any x near the foot.
template <typename Patch>
class Patch_tree
{
  // an AABB primitive: a patch, which the tree knows by its box
  class Primitive
  {
  public:
    using Id = const Patch*;
    using Point = vertex_location::Point;
    using Datum = Kernel::Iso_cuboid_3;
    using Datum_reference = Datum;

    Primitive() = default;
    template <typename Iterator>
    explicit Primitive(Iterator it) : m_patch(&*it)
    {}

    Id id() const { return m_patch; }
    Datum datum() const { return Datum(m_patch->bbox()); }
    Point reference_point() const { return (datum().min)(); }

  private:
    const Patch* m_patch = nullptr;
  };

  using Tree = AABB_tree<AABB_traits_for<Kernel, Primitive>>;

public:
  Patch_tree() = default;

  template <typename ConcurrencyTag = Sequential_tag>
  explicit Patch_tree(std::vector<Patch> patches, const ConcurrencyTag& tag = ConcurrencyTag())
    : m_patches(std::move(patches))
  {
    if(m_patches.empty())
      return;
    const Patch_order<Patch> order(m_patches, tag);
    const auto places = boost::irange<std::size_t>(0, m_patches.size());
    const auto patch_at = [&](std::size_t place) -> const Patch& { return m_patches[order[place]]; };
    const auto patches_in_order = places | boost::adaptors::transformed(patch_at);
    m_tree.insert(patches_in_order.begin(), patches_in_order.end());
#if CGAL_VERSION_NR < 1060200000 // later versions may ask for the boxes in another order
    auto box = order.boxes_of_nodes().begin();
    const auto next_box = [&](const auto&, const auto&) { return *box++; };
    m_tree.custom_build(next_box, [](const auto&, const auto&, const auto&) {});
#else
    m_tree.build();
#endif
  }

  bool empty() const { return m_patches.empty(); }
  const std::vector<Patch>& patches() const { return m_patches; }
  const Patch& patch(Index i) const { return m_patches[i]; }
  Point point(const Patch_foot& foot) const { return m_patches[foot.patch].point(foot.coordinates); }

  // The closest point of the surface, which must not be empty. A patch nearby as hint makes the search faster.
  Patch_foot project(const Point& query, const Index hint = no_index) const
  {
    Patch_foot foot{ 0, Coordinates() }; // what remains where squared distances overflow
    double distance2 = (std::numeric_limits<double>::max)();
    if(hint != no_index)
      foot = project_to_patch(query, hint, distance2);

    Find_candidates find_candidates(m_patches, distance2);
    m_tree.traversal_with_priority(query, find_candidates);
    for(const Candidate& candidate : find_candidates.sorted())
    {
      if(square(candidate.estimate.lower_bound) >= distance2)
        break;
      Coordinates x = candidate.estimate.coordinates;
      if(candidate.patch != hint && m_patches[candidate.patch].improve_foot(query, x, distance2))
        foot = { candidate.patch, x };
    }
    return foot;
  }

  // the closest point of patch i, and its squared distance
  Patch_foot project_to_patch(const Point& query, const Index i, double& squared_distance) const
  {
    Coordinates x = m_patches[i].estimate_foot(query).coordinates;
    squared_distance = (std::numeric_limits<double>::max)();
    m_patches[i].improve_foot(query, x, squared_distance);
    return { i, x };
  }

  // Moves `foot`, with its squared distance, to patch i if that has a point that is closer; returns whether it has.
  bool improve_foot(const Point& query, const Index i, Patch_foot& foot, double& squared_distance) const
  {
    const Foot_estimate estimate = m_patches[i].estimate_foot(query);
    Coordinates x = estimate.coordinates;
    if(square(estimate.lower_bound) >= squared_distance || !m_patches[i].improve_foot(query, x, squared_distance))
      return false;
    foot = { i, x };
    return true;
  }

private:
  // a patch that may have the closest point
  struct Candidate
  {
    Index patch;
    Foot_estimate estimate;
  };

  // Traverses the tree, the nearer child first, and collects the patches that may be closer than what is known so far.
  // Their estimates, which are cheap, suffice for that.
  class Find_candidates
  {
  public:
    using Priority = double;
    using Candidates = boost::container::small_vector<Candidate, 16>;

    Find_candidates(const std::vector<Patch>& patches, const double squared_distance_bound)
      : m_patches(patches), m_squared_distance_bound(squared_distance_bound)
    {}

    // by increasing lower bounds of their distances
    const Candidates& sorted()
    {
      std::sort(m_candidates.begin(), m_candidates.end(),
                [](const Candidate& a, const Candidate& b) { return a.estimate.lower_bound < b.estimate.lower_bound; });
      return m_candidates;
    }

    bool go_further() const { return true; }

    void intersection(const Point& query, const Primitive& primitive)
    {
      const Patch& patch = *primitive.id();
      if(!is_near(query, patch.bbox()))
        return;
      const Foot_estimate estimate = patch.estimate_foot(query);
      if(!(square(estimate.lower_bound) <= m_squared_distance_bound))
        return;
      m_candidates.push_back({ static_cast<Index>(&patch - m_patches.data()), estimate });
      m_squared_distance_bound = (std::min)(m_squared_distance_bound, square(estimate.upper_bound));
    }

    template <typename Node>
    bool do_intersect(const Point& query, const Node& node) const
    {
      return is_near(query, node.bbox());
    }

    template <typename Node>
    std::pair<bool, Priority> do_intersect_with_priority(const Point& query, const Node& node) const
    {
      const double distance = squared_distance_to_box(query, node.bbox());
      return { distance <= m_squared_distance_bound, -distance };
    }

  private:
    bool is_near(const Point& query, const Bbox_3& box) const
    {
      return squared_distance_to_box(query, box) <= m_squared_distance_bound;
    }

    const std::vector<Patch>& m_patches;
    Candidates m_candidates;
    double m_squared_distance_bound;
  };

  std::vector<Patch> m_patches;
  Tree m_tree;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PATCH_TREE_H
