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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FEATURE_PLACEMENT_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FEATURE_PLACEMENT_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Placement/find_corner_vertices.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Placement/springs.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Feature_curves.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Places the vertices of constrained edges along the creases and borders of the reference. It has samples of its own, on
// these curves, at the constrained edges.
class Feature_placement
{
  struct Feature_edge
  {
    Index edge;
    Feature_curves::Foot midpoint_foot;
    bool has_foot = false;
    bool is_at_corner = false; // whether one of its ends is a corner vertex
  };

  // a vertex with two constrained edges that pass straight through it
  struct Curve_vertex
  {
    Index vertex;
    std::array<Index, 2> edges; // in m_edges
    std::array<Index, 2> neighbors;
    Vector tangent = NULL_VECTOR; // of the reference's curve at the foot; null: the vertex has no foot
  };

public:
  Feature_placement(const Feature_curves& curves, const Remesh& remesh) : m_curves(curves)
  {
    if(curves.empty())
      return;
    m_corner_vertices = find_corner_vertices(curves, remesh);
    for(Index e : remesh.constraints.edges)
    {
      const std::array<Index, 2>& ends = remesh.edges[e];
      m_edges.push_back({ e, Feature_curves::Foot(), false, is_corner_vertex(ends[0]) || is_corner_vertex(ends[1]) });
    }
    find_curve_vertices(remesh);
  }

  // Samples the curves, and puts these samples in the place of those of the surface: m_ij of a constrained edge and p_i at
  // its ends.
  template <typename ConcurrencyTag, typename Samples>
  void resample(const Remesh& remesh, Samples& vertices, Samples& midpoints)
  {
    for_each_index<ConcurrencyTag>(m_edges.size(), [&](std::size_t k) {
      Feature_edge& edge = m_edges[k];
      find_midpoint_foot(remesh, edge);
      if(edge.has_foot)
        midpoints.set_offset(edge.edge, m_curves.point(edge.midpoint_foot) - remesh.midpoint(edge.edge));
    });
    // one thread: edges share vertices
    for(const Feature_edge& edge : m_edges)
      if(edge.has_foot)
        for(Index i : remesh.edges[edge.edge])
        {
          const Feature_curves::Foot foot = m_curves.project_along(remesh.points[i], edge.midpoint_foot);
          vertices.set_offset(i, m_curves.point(foot) - remesh.points[i]);
        }
  }

  // The fit along the curves: the best line through a parabola, p_i,e = (2 p_i - p_j + 2 m_ij) / 3, weighted by the
  // lengths of the edges. If `across_curve`, only the part of the update across the curve is taken. Corner vertices go to
  // their corners.
  template <typename ConcurrencyTag>
  void place(Remesh& remesh, const bool across_curve)
  {
    for(const Corner_vertex& v : m_corner_vertices)
      remesh.next_points[v.vertex] = v.corner;
    for_each_index<ConcurrencyTag>(m_curve_vertices.size(), [&](std::size_t k) {
      Curve_vertex& v = m_curve_vertices[k];
      v.tangent = NULL_VECTOR;
      const Feature_edge &a = m_edges[v.edges[0]], &b = m_edges[v.edges[1]];
      if(!a.has_foot || !b.has_foot || m_curves.curve(a.midpoint_foot) != m_curves.curve(b.midpoint_foot))
        return;
      const Feature_curves::Foot foot = m_curves.project_along(remesh.points[v.vertex], a.midpoint_foot);
      if(m_curves.is_end(foot))
        return;

      const Point p = m_curves.point(foot);
      double sum_of_lengths = 0;
      Vector sum = NULL_VECTOR;
      for(int side = 0; side < 2; ++side)
      {
        const Point& v_j = remesh.points[v.neighbors[side]];
        const Feature_curves::Foot& midpoint_foot = m_edges[v.edges[side]].midpoint_foot;
        const Point p_j = m_curves.point(m_curves.project_along(v_j, midpoint_foot));
        const double length = norm(v_j - remesh.points[v.vertex]);
        sum = sum + length * (2 * (m_curves.point(midpoint_foot) - p) - (p_j - p)) / 3;
        sum_of_lengths += length;
      }
      if(!(sum_of_lengths > 0))
        return;

      v.tangent = m_curves.tangent(foot);
      Vector update = sum / sum_of_lengths;
      if(across_curve)
        update = update - (update * v.tangent) * v.tangent;
      remesh.next_points[v.vertex] = p + update;
    });
  }

  // Springs along the curves, see `relax_springs()`.
  void relax(Remesh& remesh, const std::size_t number_of_steps) const
  {
    std::vector<Vector> forces(m_curve_vertices.size(), NULL_VECTOR);
    for(std::size_t step = 0; step < number_of_steps; ++step)
    {
      for(std::size_t k = 0; k < m_curve_vertices.size(); ++k)
      {
        const Curve_vertex& v = m_curve_vertices[k];
        Vector force = NULL_VECTOR;
        for(Index j : v.neighbors)
          force = force + Spring::force(remesh.next_points[v.vertex] - remesh.next_points[j], remesh.lengths[v.vertex]);
        forces[k] = (force * v.tangent) * v.tangent;
      }
      for(std::size_t k = 0; k < m_curve_vertices.size(); ++k)
        if(!remesh.is_at_rest(m_curve_vertices[k].vertex))
          remesh.next_points[m_curve_vertices[k].vertex] = remesh.next_points[m_curve_vertices[k].vertex] + forces[k];
    }
  }

private:
  bool is_corner_vertex(const Index i) const
  {
    const auto is_less = [](const Corner_vertex& v, Index j) { return v.vertex < j; };
    const auto v = std::lower_bound(m_corner_vertices.begin(), m_corner_vertices.end(), i, is_less);
    return v != m_corner_vertices.end() && v->vertex == i;
  }

  void find_curve_vertices(const Remesh& remesh)
  {
    std::vector<std::vector<Index>> edges_of_vertex(remesh.points.size());
    for(Index k = 0; k < m_edges.size(); ++k)
      for(Index i : remesh.edges[m_edges[k].edge])
        edges_of_vertex[i].push_back(k);

    for(Index i = 0; i < remesh.points.size(); ++i)
    {
      if(remesh.constraints.kinds[i] != Vertex_kind::ON_CURVE || edges_of_vertex[i].size() != 2 || is_corner_vertex(i))
        continue;
      Curve_vertex v{ i, { edges_of_vertex[i][0], edges_of_vertex[i][1] }, {} };
      for(int side = 0; side < 2; ++side)
      {
        const std::array<Index, 2>& ends = remesh.edges[m_edges[v.edges[side]].edge];
        v.neighbors[side] = ends[0] == i ? ends[1] : ends[0];
      }
      const Point& p = remesh.points[i];
      if(Feature_curves::goes_straight_through(remesh.points[v.neighbors[0]] - p, remesh.points[v.neighbors[1]] - p))
        m_curve_vertices.push_back(v);
    }
  }

  // The foot of the midpoint of an edge. The first foot decides which curve the edge follows, unless the edge cuts off a
  // corner that one of its ends moves to. There is no foot if the edge differs from the curve in direction, extends beyond
  // the end of the curve, or is farther from it than a quarter of its length.
  void find_midpoint_foot(const Remesh& remesh, Feature_edge& edge) const
  {
    const Point &p = remesh.points[remesh.edges[edge.edge][0]], &q = remesh.points[remesh.edges[edge.edge][1]];
    const Point m = midpoint(p, q);
    Feature_curves::Foot& foot = edge.midpoint_foot;
    const bool is_undecided = foot.patch == no_index || (edge.is_at_corner && !edge.has_foot);
    foot = is_undecided ? m_curves.project(m) : m_curves.project_along(m, foot);

    const Vector along = q - p;
    edge.has_foot = !m_curves.is_end(foot) && 16 * squared_distance(m, m_curves.point(foot)) < along.squared_length() &&
                    std::abs(m_curves.tangent(foot) * along) > 0.5 * norm(along);
  }

  const Feature_curves& m_curves;
  std::vector<Feature_edge> m_edges;
  std::vector<Curve_vertex> m_curve_vertices;
  std::vector<Corner_vertex> m_corner_vertices; // by increasing indices
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FEATURE_PLACEMENT_H
