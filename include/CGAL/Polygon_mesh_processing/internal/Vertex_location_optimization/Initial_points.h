// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_INITIAL_POINTS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_INITIAL_POINTS_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <CGAL/Kernel_traits.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// The points of the remesh, which are needed now and then only: they are read again from the user's mesh, to save memory.
// But they are kept if their coordinates are not of a floating point type: lazy numbers are approximated differently when
// they have been evaluated.
template <typename TriangleMesh, typename VertexPointMap>
class Initial_points
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using User_point = typename boost::property_traits<VertexPointMap>::value_type;
  static constexpr bool are_kept = !std::is_floating_point<typename Kernel_traits<User_point>::Kernel::FT>::value;

public:
  // `points` are those of `vertices`; these and `vpm` must remain
  Initial_points(const std::vector<vertex_descriptor>& vertices,
                 const VertexPointMap& vpm,
                 const std::vector<Point>& points)
    : m_vertices(vertices), m_vpm(vpm), m_kept(are_kept ? points : std::vector<Point>())
  {}

  Point operator()(std::size_t i) const
  {
    if constexpr(are_kept)
      return m_kept[i];
    else
      return convert<Point>(get(m_vpm, m_vertices[i]));
  }

  std::vector<Point> all() const
  {
    std::vector<Point> points;
    points.reserve(m_vertices.size());
    for(std::size_t i = 0; i < m_vertices.size(); ++i)
      points.push_back((*this)(i));
    return points;
  }

private:
  const std::vector<vertex_descriptor>& m_vertices;
  const VertexPointMap& m_vpm;
  std::vector<Point> m_kept;
};

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_INITIAL_POINTS_H
