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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIND_CORNER_VERTICES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIND_CORNER_VERTICES_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Feature_curves.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Patch_tree.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// A patch that is a point, see `Patch_tree`.
struct Point_patch
{
  Bbox_3 bbox() const { return p.bbox(); }
  Point point(const Coordinates&) const { return p; }

  Foot_estimate estimate_foot(const Point& query) const
  {
    const double distance = std::sqrt(squared_distance(query, p));
    return { Coordinates(), 0, distance };
  }

  bool improve_foot(const Point& query, Coordinates&, double& squared_distance_bound) const
  {
    const double distance2 = squared_distance(query, p);
    const bool is_closer = distance2 < squared_distance_bound;
    squared_distance_bound = (std::min)(distance2, squared_distance_bound);
    return is_closer;
  }

  Point p;
};

// A vertex of the remesh that the corner of the reference's curves belongs to.
struct Corner_vertex
{
  Index vertex;
  Point corner;
};

// Finds the vertices that move to corners cut off by the remesh: for each corner, the closest vertex of constrained edges,
// if it is free to move along them, has as many of them as the corner has curves, and is near. Vertices already at a corner
// are not included, and corners of curves shorter than edges of the remesh are ignored as noise.
class Corner_search
{
  // the constrained edges at a vertex
  struct Edges_at_vertex
  {
    std::size_t number = 0;
    double length = 0; // of the longest
  };

public:
  explicit Corner_search(const Remesh& remesh) : m_remesh(remesh)
  {
    for(Index e : remesh.constraints.edges)
      for(Index i : remesh.edges[e])
      {
        Edges_at_vertex& at_vertex = m_edges[i];
        ++at_vertex.number;
        at_vertex.length =
          (std::max)(at_vertex.length, norm(remesh.points[remesh.edges[e][1]] - remesh.points[remesh.edges[e][0]]));
      }
    std::vector<Point_patch> points;
    for(const auto& [i, at_vertex] : m_edges)
    {
      m_vertices.push_back(i);
      points.push_back({ remesh.points[i] });
    }
    m_tree = Patch_tree<Point_patch>(std::move(points));
  }

  // by the vertices; if several corners have the same vertex, the closest one keeps it
  std::vector<Corner_vertex> find(const std::vector<Feature_curves::Corner>& corners) const
  {
    std::map<Index, Point> corner_of_vertex;
    for(const Feature_curves::Corner& corner : corners)
    {
      const Index i = m_vertices[m_tree.project(corner.point).patch];
      if(!is_suitable(i, corner))
        continue;
      const auto [it, is_new] = corner_of_vertex.emplace(i, corner.point);
      const Point& p = m_remesh.points[i];
      if(!is_new && squared_distance(p, corner.point) < squared_distance(p, it->second))
        it->second = corner.point;
    }
    std::vector<Corner_vertex> result;
    result.reserve(corner_of_vertex.size());
    for(const auto& [i, corner] : corner_of_vertex)
      result.push_back({ i, corner });
    return result;
  }

private:
  bool is_suitable(const Index i, const Feature_curves::Corner& corner) const
  {
    // relative to the longest constrained edge; one that cuts off a right angle evenly is 0.71 of its length away
    constexpr double farthest = 0.75, at_corner = 1e-6;
    const Edges_at_vertex& edges = m_edges.at(i);
    const double distance2 = squared_distance(m_remesh.points[i], corner.point);
    return m_remesh.constraints.kinds[i] == Vertex_kind::ON_CURVE && edges.number == corner.number_of_curves &&
           corner.length >= edges.length && distance2 <= square(farthest * edges.length) &&
           distance2 > square(at_corner * edges.length);
  }

  const Remesh& m_remesh;
  std::map<Index, Edges_at_vertex> m_edges;
  std::vector<Index> m_vertices; // of the constrained edges, as in the tree
  Patch_tree<Point_patch> m_tree;
};

inline std::vector<Corner_vertex> find_corner_vertices(const Feature_curves& curves, const Remesh& remesh)
{
  if(curves.corners().empty() || remesh.constraints.edges.empty())
    return {};
  return Corner_search(remesh).find(curves.corners());
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIND_CORNER_VERTICES_H
