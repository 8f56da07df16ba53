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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PATCH_ORDER_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PATCH_ORDER_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The order of patches in an AABB tree, and the boxes of its nodes: those that `AABB_tree` would compute, but with several
// threads, and with each box joined from those of the two halves.
template <typename Patch>
class Patch_order
{
public:
  // one patch or more
  template <typename ConcurrencyTag>
  Patch_order(const std::vector<Patch>& patches, const ConcurrencyTag&)
    : m_patches(patches), m_items(patches.size()), m_boxes(patches.size() - 1)
  {
    for_each_index<ConcurrencyTag>(m_items.size(), [&](std::size_t i) {
      m_items[i] = { center(patches[i].bbox()), static_cast<Index>(i) };
    });
    arrange<ConcurrencyTag>(0, m_items.size(), 0);
  }

  // the patch at place i; the first half of the patches are those of the first child, and so on in the children
  Index operator[](std::size_t i) const { return m_items[i].patch; }

  const std::vector<Bbox_3>& boxes_of_nodes() const { return m_boxes; } // a node before its children

private:
  using Center = std::array<double, 3>;

  struct Item
  {
    Center center;
    Index patch;
  };

  // twice the center of a box; 0 where coordinates overflow
  static Center center(const Bbox_3& box)
  {
    const auto sum = [](double a, double b) { return std::isfinite(a + b) ? a + b : 0; };
    return { sum(box.xmin(), box.xmax()), sum(box.ymin(), box.ymax()), sum(box.zmin(), box.zmax()) };
  }

  // Splits n items from `first` on in halves along the longest axis, and these as well. Returns the box of them, that of
  // `node`.
  template <typename ConcurrencyTag>
  Bbox_3 arrange(const std::size_t first, const std::size_t n, const std::size_t node)
  {
    constexpr std::size_t worth_a_thread = 4096; // patches

    if(n == 1)
      return m_patches[m_items[first].patch].bbox();
    const std::size_t half = n / 2;
    if(n > 2)
      split(m_items.begin() + first, m_items.begin() + first + half, m_items.begin() + first + n);
    std::array<Bbox_3, 2> boxes;
    const auto arrange_first = [&] { boxes[0] = arrange<ConcurrencyTag>(first, half, node + 1); };
    const auto arrange_second = [&] { boxes[1] = arrange<ConcurrencyTag>(first + half, n - half, node + half); };
    if(n < worth_a_thread)
      call_both<Sequential_tag>(arrange_first, arrange_second);
    else
      call_both<ConcurrencyTag>(arrange_first, arrange_second);
    return m_boxes[node] = boxes[0] + boxes[1];
  }

  template <typename Iterator>
  static void split(const Iterator first, const Iterator middle, const Iterator beyond)
  {
    Center low = first->center, high = low;
    for(Iterator it = first; it != beyond; ++it)
      for(int k = 0; k < 3; ++k)
      {
        low[k] = (std::min)(low[k], it->center[k]);
        high[k] = (std::max)(high[k], it->center[k]);
      }
    const Center extent{ high[0] - low[0], high[1] - low[1], high[2] - low[2] };
    const auto axis = std::max_element(extent.begin(), extent.end()) - extent.begin();
    std::nth_element(first, middle, beyond,
                     [axis](const Item& a, const Item& b) { return a.center[axis] < b.center[axis]; });
  }

  const std::vector<Patch>& m_patches;
  std::vector<Item> m_items;
  std::vector<Bbox_3> m_boxes;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PATCH_ORDER_H
