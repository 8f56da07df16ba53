// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SELF_INTERSECTION_TEST_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SELF_INTERSECTION_TEST_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_mesh.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// Finds the pairs of faces of `tmesh` that intersect if its vertices are elsewhere.
template <typename ConcurrencyTag, typename TriangleMesh>
class Self_intersection_test
{
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;

public:
  using Face_pair = std::pair<Index, Index>;

  // If not `is_enabled`, none are found.
  Self_intersection_test(const TriangleMesh& tmesh,
                         const Mesh_descriptors<TriangleMesh>& descriptors,
                         const bool is_enabled)
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

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SELF_INTERSECTION_TEST_H
