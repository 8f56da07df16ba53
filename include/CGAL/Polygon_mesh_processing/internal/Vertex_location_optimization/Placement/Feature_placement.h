// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FEATURE_EDGES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FEATURE_EDGES_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Feature_curves.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>

#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// The constrained edges of the remesh with their feet on the creases and borders of the reference.
class Feature_edges
{
  struct Feature_edge
  {
    Index edge;
    Feature_curves::Foot midpoint_foot;
    bool has_foot = false;
  };

  // a vertex with two constrained edges that pass straight through it
  struct Curve_vertex
  {
    Index vertex;
    std::array<Index, 2> edges;     // in m_edges
    std::array<Index, 2> neighbors;
    Vector tangent = NULL_VECTOR;   // of the reference's curve at the foot; null: the vertex has no foot
  };

public:
  template <typename State>
  Feature_edges(const Feature_curves& curves, const State& state) : m_curves(curves)
  {
    if(curves.empty())
      return;
    for(Index e : state.constraints.edges)
      m_edges.push_back({ e, Feature_curves::Foot() });
    find_curve_vertices(state);
  }

  // Samples the curves for the constrained edges, instead of the surface: m_ij of such an edge and p_i at its ends.
  template <typename ConcurrencyTag, typename State>
  void sample(State& state)
  {
    const Mesh_arrays& mesh = state.mesh;
    for_each_index<ConcurrencyTag>(m_edges.size(), [&](std::size_t k)
    {
      Feature_edge& edge = m_edges[k];
      find_midpoint_foot(mesh, edge);
      if(edge.has_foot)
        state.midpoint_samples.set_offset(edge.edge, m_curves.point(edge.midpoint_foot) - mesh.midpoint(edge.edge));
    });
    // one thread: edges share vertices
    for(const Feature_edge& edge : m_edges)
      if(edge.has_foot)
        for(Index i : mesh.edges[edge.edge])
        {
          const Feature_curves::Foot foot = m_curves.project_along(mesh.points[i], edge.midpoint_foot);
          state.vertex_samples.set_offset(i, m_curves.point(foot) - mesh.points[i]);
        }
  }

  // The fit along the curves: the best line through a parabola, p_i,e = (2 p_i - p_j + 2 m_ij) / 3, weighted by the
  // lengths of the edges. If `across_curve`, only the part of the update across the curve is taken.
  template <typename ConcurrencyTag, typename State>
  void fit(State& state, const bool across_curve)
  {
    const Mesh_arrays& mesh = state.mesh;
    for_each_index<ConcurrencyTag>(m_curve_vertices.size(), [&](std::size_t k)
    {
      Curve_vertex& v = m_curve_vertices[k];
      v.tangent = NULL_VECTOR;
      const Feature_edge &a = m_edges[v.edges[0]], &b = m_edges[v.edges[1]];
      if(!a.has_foot || !b.has_foot || m_curves.curve(a.midpoint_foot) != m_curves.curve(b.midpoint_foot))
        return;
      const Feature_curves::Foot foot = m_curves.project_along(mesh.points[v.vertex], a.midpoint_foot);
      if(m_curves.is_end(foot))
        return;

      const Point p = m_curves.point(foot);
      double sum_of_lengths = 0;
      Vector sum = NULL_VECTOR;
      for(int side = 0; side < 2; ++side)
      {
        const Point& v_j = mesh.points[v.neighbors[side]];
        const Feature_curves::Foot& midpoint_foot = m_edges[v.edges[side]].midpoint_foot;
        const Point p_j = m_curves.point(m_curves.project_along(v_j, midpoint_foot));
        const double length = norm(v_j - mesh.points[v.vertex]);
        sum = sum + length * (2 * (m_curves.point(midpoint_foot) - p) - (p_j - p)) / 3;
        sum_of_lengths += length;
      }
      if(!(sum_of_lengths > 0))
        return;

      v.tangent = m_curves.tangent(foot);
      Vector update = sum / sum_of_lengths;
      if(across_curve)
        update = update - (update * v.tangent) * v.tangent;
      state.targets[v.vertex] = p + update;
    });
  }

  // Springs along the curves, see `relax_springs()`.
  template <typename State>
  void relax(State& state, const std::size_t number_of_steps) const
  {
    const double two_sigma2 = 2 * state.spring_length * state.spring_length;
    std::vector<Vector> forces(m_curve_vertices.size(), NULL_VECTOR);
    for(std::size_t step = 0; step < number_of_steps && two_sigma2 > 0; ++step)
    {
      for(std::size_t k = 0; k < m_curve_vertices.size(); ++k)
      {
        const Curve_vertex& v = m_curve_vertices[k];
        Vector force = NULL_VECTOR;
        for(Index j : v.neighbors)
        {
          const Vector from_j = state.targets[v.vertex] - state.targets[j];
          force = force + std::exp(-from_j.squared_length() / two_sigma2) * from_j;
        }
        forces[k] = (force * v.tangent) * v.tangent;
      }
      for(std::size_t k = 0; k < m_curve_vertices.size(); ++k)
        if(!state.is_at_rest(m_curve_vertices[k].vertex))
          state.targets[m_curve_vertices[k].vertex] = state.targets[m_curve_vertices[k].vertex] + forces[k];
    }
  }

private:
  template <typename State>
  void find_curve_vertices(const State& state)
  {
    const Mesh_arrays& mesh = state.mesh;
    std::vector<std::vector<Index>> edges_of_vertex(mesh.points.size());
    for(Index k = 0; k < m_edges.size(); ++k)
      for(Index i : mesh.edges[m_edges[k].edge])
        edges_of_vertex[i].push_back(k);

    for(Index i = 0; i < mesh.points.size(); ++i)
    {
      if(state.constraints.kinds[i] != Vertex_kind::ON_CURVE || edges_of_vertex[i].size() != 2)
        continue;
      Curve_vertex v{ i, { edges_of_vertex[i][0], edges_of_vertex[i][1] }, {} };
      for(int side = 0; side < 2; ++side)
      {
        const std::array<Index, 2>& ends = mesh.edges[m_edges[v.edges[side]].edge];
        v.neighbors[side] = ends[0] == i ? ends[1] : ends[0];
      }
      const Point& p = mesh.points[i];
      if(Feature_curves::goes_straight_through(mesh.points[v.neighbors[0]] - p, mesh.points[v.neighbors[1]] - p))
        m_curve_vertices.push_back(v);
    }
  }

  // The foot of the midpoint of an edge. The first one decides which curve the edge follows; there is none where the
  // edge goes another way than the curve, beyond its end, or farther from it than a quarter of its length.
  void find_midpoint_foot(const Mesh_arrays& mesh, Feature_edge& edge) const
  {
    const Point &p = mesh.points[mesh.edges[edge.edge][0]], &q = mesh.points[mesh.edges[edge.edge][1]];
    const Point m = midpoint(p, q);
    Feature_curves::Foot& foot = edge.midpoint_foot;
    foot = foot.patch == no_index ? m_curves.project(m) : m_curves.project_along(m, foot);

    const Vector along = q - p;
    edge.has_foot = !m_curves.is_end(foot) &&
                    16 * squared_distance(m, m_curves.point(foot)) < along.squared_length() &&
                    std::abs(m_curves.tangent(foot) * along) > 0.5 * norm(along);
  }

  const Feature_curves& m_curves;
  std::vector<Feature_edge> m_edges;
  std::vector<Curve_vertex> m_curve_vertices;
};

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FEATURE_EDGES_H
