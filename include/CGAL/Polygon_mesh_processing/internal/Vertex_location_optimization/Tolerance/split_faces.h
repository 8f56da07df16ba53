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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SPLIT_FACES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SPLIT_FACES_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Reference_access.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/properties.h>

#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

template <typename TriangleMesh, typename VertexPointMap>
double squared_length(typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h,
                      const TriangleMesh& mesh,
                      const VertexPointMap& vpm)
{
  return squared_distance(convert<Point>(get(vpm, source(h, mesh))), convert<Point>(get(vpm, target(h, mesh))));
}

template <typename TriangleMesh, typename VertexPointMap>
auto find_longest_side(typename boost::graph_traits<TriangleMesh>::face_descriptor f,
                       const TriangleMesh& mesh,
                       const VertexPointMap& vpm)
{
  auto longest = halfedge(f, mesh);
  for(auto h = next(longest, mesh); h != halfedge(f, mesh); h = next(h, mesh))
    if(squared_length(h, mesh, vpm) > squared_length(longest, mesh, vpm))
      longest = h;
  return longest;
}

// The point that splits an edge: that of the crease of the reference if the edge is constrained and one is near; else the
// midpoint, so that the surface does not change and does not come to intersect itself. The fit that follows moves it.
template <typename Reference>
Point find_split_point(const Point& p, const Point& q, bool is_constrained, const Reference& reference)
{
  const Point middle = midpoint(p, q);
  const Feature_curves& curves = reference.feature_curves();
  if(!is_constrained || curves.empty())
    return middle;
  const Point on_curve = curves.point(curves.project(middle));
  return squared_distance(on_curve, middle) < squared_distance(p, q) / 16 ? on_curve : middle;
}

// Splits an edge, and the faces at it, in two. The halves are constrained if the edge is. Returns the new vertex.
template <typename TriangleMesh, typename VertexPointMap, typename EdgeIsConstrainedMap, typename Reference>
auto split_edge_and_faces(typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h,
                          TriangleMesh& mesh,
                          const VertexPointMap& vpm,
                          const EdgeIsConstrainedMap& is_constrained,
                          const Reference& reference)
{
  const bool constrained = get(is_constrained, edge(h, mesh));
  const Point point = find_split_point(convert<Point>(get(vpm, source(h, mesh))), convert<Point>(get(vpm, target(h, mesh))),
                                       constrained || is_border_edge(h, mesh), reference);
  const auto half = Euler::split_edge(h, mesh); // to the new vertex
  put(vpm, target(half, mesh), convert<typename boost::property_traits<VertexPointMap>::value_type>(point));
  put(is_constrained, edge(half, mesh), constrained);
  for(auto g : { half, prev(opposite(half, mesh), mesh) })
    if(!is_border(g, mesh))
      put(is_constrained, edge(Euler::split_face(g, next(next(g, mesh), mesh), mesh), mesh), false);
  return target(half, mesh);
}

// Splits the longest sides of the faces. The longest side of two of them is split once. Returns the vertices around.
template <typename TriangleMesh, typename VertexPointMap, typename EdgeIsConstrainedMap, typename Reference>
std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>
split_longest_sides(const std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor>& faces,
                    TriangleMesh& mesh,
                    const VertexPointMap& vpm,
                    const EdgeIsConstrainedMap& is_constrained,
                    const Reference& reference)
{
  std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> sides;
  {
    auto is_found = get(dynamic_edge_property_t<bool>(), mesh);
    for(auto e : edges(mesh))
      put(is_found, e, false);
    for(auto f : faces)
    {
      const auto h = find_longest_side(f, mesh, vpm);
      if(!get(is_found, edge(h, mesh)))
        sides.push_back(h);
      put(is_found, edge(h, mesh), true);
    }
  }
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> around;
  for(auto h : sides)
  {
    const auto v = split_edge_and_faces(h, mesh, vpm, is_constrained, reference);
    around.push_back(v);
    for(auto g : halfedges_around_target(v, mesh))
      around.push_back(source(g, mesh));
  }
  return around;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SPLIT_FACES_H
