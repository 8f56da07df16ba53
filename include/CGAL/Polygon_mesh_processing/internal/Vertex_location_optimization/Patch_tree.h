// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PATCH_TREE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PATCH_TREE_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/compatibility.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Flat_triangle.h>

#include <boost/range/irange.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// A point of a reference surface: its patch and the coordinates in the patch.
struct Patch_foot
{
  Index patch = no_index;
  Coordinates coordinates;
};

// A box in single precision around one in double precision.
class Outer_box
{
public:
  Outer_box() = default;
  explicit Outer_box(const Bbox_3& box)
  {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for(int i = 0; i < 3; ++i)
    {
      m_min[i] = std::nextafter(static_cast<float>((box.min)(i)), -infinity);
      m_max[i] = std::nextafter(static_cast<float>((box.max)(i)), infinity);
    }
  }

  float min(int i) const { return m_min[i]; }
  float max(int i) const { return m_max[i]; }

private:
  std::array<float, 3> m_min, m_max;
};

// `Box` is a `Bbox_3` or an `Outer_box`.
template <typename Box>
double squared_distance_to_box(const Point& p, const Box& box)
{
  const double dx = (std::max)({ (box.min)(0) - p.x(), 0., p.x() - (box.max)(0) });
  const double dy = (std::max)({ (box.min)(1) - p.y(), 0., p.y() - (box.max)(1) });
  const double dz = (std::max)({ (box.min)(2) - p.z(), 0., p.z() - (box.max)(2) });
  return dx * dx + dy * dy + dz * dz;
}

// Patches (see `Flat_triangle`) in an AABB tree, for closest points.
template <typename Patch>
class Patch_tree
{
  struct Primitive
  {
    using Id = Index;
    using Point = vertex_location::Point;
    using Datum = Patch;
    using Datum_reference = const Patch&;
    struct Shared_data
    {
      const Patch* patches = nullptr;
    };

    Primitive() = default;
    template <typename Iterator>
    Primitive(Iterator it, const Patch* patches) : m_id(static_cast<Id>(*it)), m_box(patches[m_id].bbox()) {}

    Id id() const { return m_id; }
    const Outer_box& box() const { return m_box; }
    const Patch& datum(const Shared_data& data) const { return data.patches[m_id]; }
    Point reference_point(const Shared_data& data) const { return data.patches[m_id].reference_point(); }
    static Shared_data construct_shared_data(const Patch* patches) { return { patches }; }

  private:
    Id m_id = no_index;
    Outer_box m_box; // the tree has none for a primitive, and the patch itself is far away in memory
  };

  using Tree = AABB_tree<AABB_traits_for<Kernel, Primitive>>;

public:
  Patch_tree() = default;

  explicit Patch_tree(std::vector<Patch> patches)
    : m_patches(std::move(patches))
  {
    const auto ids = boost::irange<std::size_t>(0, m_patches.size());
    m_tree.insert(ids.begin(), ids.end(), static_cast<const Patch*>(m_patches.data()));
    m_tree.build();
  }

  bool empty() const { return m_patches.empty(); }
  const Patch& patch(Index i) const { return m_patches[i]; }
  Point point(const Patch_foot& foot) const { return m_patches[foot.patch].point(foot.coordinates); }
  Vector normal(const Patch_foot& foot) const { return m_patches[foot.patch].normal(foot.coordinates); }

  // The closest point of the surface, which must not be empty. A foot of a point nearby as hint makes the search faster.
  Patch_foot project(const Point& query, const Patch_foot& hint = Patch_foot()) const
  {
    Closest_patch closest(m_patches, query, hint);
    m_tree.traversal_with_priority(query, closest);
    return closest.foot();
  }

private:
  // Traverses the tree to the patch with the closest point, the nearer child first.
  class Closest_patch
  {
  public:
    using Priority = double;

    Closest_patch(const std::vector<Patch>& patches, const Point& query, const Patch_foot& hint)
      : m_patches(patches), m_foot(hint)
    {
      if(hint.patch == no_index)
        m_foot.patch = 0; // what remains where squared distances overflow
      else
        m_squared_distance = squared_distance(query, m_patches[hint.patch].point(hint.coordinates));
    }

    const Patch_foot& foot() const { return m_foot; }

    bool go_further() const { return true; }

    void intersection(const Point& query, const Primitive& primitive)
    {
      if(squared_distance_to_box(query, primitive.box()) <= m_squared_distance &&
         m_patches[primitive.id()].improve_foot(query, m_foot.coordinates, m_squared_distance))
        m_foot.patch = primitive.id();
    }

    template <typename Node>
    bool do_intersect(const Point& query, const Node& node) const
    {
      return squared_distance_to_box(query, node.bbox()) <= m_squared_distance;
    }

    template <typename Node>
    std::pair<bool, Priority> do_intersect_with_priority(const Point& query, const Node& node) const
    {
      const double distance = squared_distance_to_box(query, node.bbox());
      return { distance <= m_squared_distance, -distance };
    }

  private:
    const std::vector<Patch>& m_patches;
    Patch_foot m_foot;
    double m_squared_distance = (std::numeric_limits<double>::max)();
  };

  std::vector<Patch> m_patches;
  Tree m_tree;
};

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PATCH_TREE_H
