// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_NEW_INTERSECTIONS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_NEW_INTERSECTIONS_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_mesh.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Finds the pairs of faces of `tmesh` that intersect if its vertices are elsewhere.
template <typename ConcurrencyTag, typename TriangleMesh>
class Self_intersection_test
{
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;

public:
  using Face_pair = std::pair<Index, Index>;

  // If not `is_enabled`, none are found.
  Self_intersection_test(const TriangleMesh& tmesh, const Mesh_descriptors<TriangleMesh>& descriptors, const bool is_enabled)
    : m_tmesh(tmesh), m_descriptors(descriptors), m_is_enabled(is_enabled)
  {}

  // the pairs, sorted
  std::vector<Face_pair> operator()(const std::vector<Point>& points) const
  {
    if(!m_is_enabled)
      return {};

    using Test_kernel = Exact_predicates_inexact_constructions_kernel;
    auto vertex_point = get(dynamic_vertex_property_t<Test_kernel::Point_3>(), m_tmesh);
    for(std::size_t i = 0; i < points.size(); ++i)
      put(vertex_point, m_descriptors.vertices[i], convert<Test_kernel::Point_3>(points[i]));
    auto face_index = get(dynamic_face_property_t<Index>(), m_tmesh);
    for(std::size_t f = 0; f < m_descriptors.halfedges.size(); ++f)
      put(face_index, face(m_descriptors.halfedges[f], m_tmesh), static_cast<Index>(f));

    std::vector<std::pair<face_descriptor, face_descriptor>> faces;
    self_intersections<ConcurrencyTag>(m_tmesh, std::back_inserter(faces),
                                       parameters::vertex_point_map(vertex_point).geom_traits(Test_kernel()));

    std::vector<Face_pair> pairs;
    pairs.reserve(faces.size());
    for(const auto& f : faces)
      pairs.push_back(std::minmax({ get(face_index, f.first), get(face_index, f.second) }));
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

private:
  const TriangleMesh& m_tmesh;
  const Mesh_descriptors<TriangleMesh>& m_descriptors;
  const bool m_is_enabled;
};

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

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_NEW_INTERSECTIONS_H
