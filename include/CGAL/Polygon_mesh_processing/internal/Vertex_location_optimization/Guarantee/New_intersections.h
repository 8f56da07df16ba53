// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_NEW_INTERSECTIONS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_NEW_INTERSECTIONS_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// Finds the pairs of faces that intersect with the next points and do not with the initial ones. `FindSelfIntersections` is
// a `Self_intersection_test`.
template <typename FindSelfIntersections>
class New_intersections
{
  using Face_pairs = std::vector<typename FindSelfIntersections::Face_pair>;

public:
  New_intersections(const Remesh& remesh, const FindSelfIntersections& find) : m_remesh(remesh), m_find(find) {}

  // the vertices of these faces, in increasing order
  std::set<Index> find_vertices()
  {
    std::set<Index> vertices;
    for(const auto& pair : find_pairs())
      for(Index f : { pair.first, pair.second })
        vertices.insert(m_remesh.face(f).begin(), m_remesh.face(f).end());
    return vertices;
  }

private:
  Face_pairs find_pairs()
  {
    const Face_pairs next = m_find(m_remesh.next_points);
    if(next.empty())
      return {};
    if(!m_knows_initial)
      m_initial = m_find(m_remesh.initial_points);
    m_knows_initial = true;
    Face_pairs result;
    std::set_difference(next.begin(), next.end(), m_initial.begin(), m_initial.end(), std::back_inserter(result));
    return result;
  }

  const Remesh& m_remesh;
  const FindSelfIntersections& m_find;
  bool m_knows_initial = false; // the initial points are tested only where the next ones intersect
  Face_pairs m_initial;
};

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_NEW_INTERSECTIONS_H
