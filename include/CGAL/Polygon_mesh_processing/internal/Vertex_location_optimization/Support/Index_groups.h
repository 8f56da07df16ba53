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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_INDEX_GROUPS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_INDEX_GROUPS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <cstddef>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The indices 0, ..., n - 1 in groups, in increasing order in each of them.
class Index_groups
{
public:
  Index_groups() = default;

  // index i belongs to the group `group_of(i)` of `number_of_groups`; a counting sort
  template <typename GroupOf>
  Index_groups(std::size_t number_of_groups, std::size_t n, const GroupOf& group_of)
    : m_first(number_of_groups + 1, 0), m_members(n)
  {
    for(Index i = 0; i < n; ++i)
      ++m_first[group_of(i) + 1];
    for(std::size_t g = 0; g < number_of_groups; ++g)
      m_first[g + 1] += m_first[g];
    std::vector<Index> end(m_first.begin(), m_first.end() - 1);
    for(Index i = 0; i < n; ++i)
      m_members[end[group_of(i)]++] = i;
  }

  // calls f(i) for each index i of a group
  template <typename F>
  void for_each(std::size_t group, const F& f) const
  {
    for(Index k = m_first[group]; k < m_first[group + 1]; ++k)
      f(m_members[k]);
  }

  const std::vector<Index>& members() const { return m_members; } // group by group

private:
  std::vector<Index> m_first; // the members of group g are m_members[m_first[g]], ..., m_members[m_first[g + 1] - 1]
  std::vector<Index> m_members;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_INDEX_GROUPS_H
