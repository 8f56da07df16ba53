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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FEATURE_CURVES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FEATURE_CURVES_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Patch_tree.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Mesh_arrays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// A cubic Bezier curve over an edge of the reference that is a crease or on the border. A patch, see `Patch_tree`, of which
// only the coordinate u counts.
class Curve_piece
{
public:
  Curve_piece() = default;

  // the cubic that passes through p, q, r and s at 0, 1/3, 2/3 and 1
  Curve_piece(const Point& p, const Point& q, const Point& r, const Point& s)
    : b{ { p, p + (18 * (q - p) - 9 * (r - p) + 2 * (s - p)) / 6, p + (18 * (r - p) - 9 * (q - p) - 5 * (s - p)) / 6, s } }
  {}

  Curve_piece reversed() const
  {
    Curve_piece result;
    result.b = { { b[3], b[2], b[1], b[0] } };
    return result;
  }

  Bbox_3 bbox() const { return b[0].bbox() + b[1].bbox() + b[2].bbox() + b[3].bbox(); }

  Point point(const Coordinates& x) const
  {
    const double t = x.u, s = 1 - t;
    return b[0] + (3 * s * s * t * (b[1] - b[0]) + 3 * s * t * t * (b[2] - b[0]) + t * t * t * (b[3] - b[0]));
  }

  Vector derivative(double t) const
  {
    const double s = 1 - t;
    return 3 * (s * s * (b[1] - b[0]) + 2 * s * t * (b[2] - b[1]) + t * t * (b[3] - b[2]));
  }

  Foot_estimate estimate_foot(const Point& query) const
  {
    const Coordinates middle{ 0.5, 0 };
    return { middle, 0, std::sqrt(squared_distance(query, point(middle))) };
  }

  bool improve_foot(const Point& query, Coordinates& x, double& squared_distance_bound) const
  {
    bool improved = false;
    for(double start : { 0.1, 0.5, 0.9 })
      improved = improve_foot_from(query, start, x, squared_distance_bound) || improved;
    return improved;
  }

  bool improve_foot_from(const Point& query, Coordinates& x, double& squared_distance_bound) const
  {
    return improve_foot_from(query, x.u, x, squared_distance_bound);
  }

private:
  // Newton's method on [0, 1]
  bool improve_foot_from(const Point& query, double t, Coordinates& x, double& squared_distance_bound) const
  {
    for(int iteration = 0; iteration < 20; ++iteration)
    {
      const Vector d = point({ t, 0 }) - query, d1 = derivative(t);
      const double slope = d * d1, gauss_newton = d1 * d1;
      const Vector d2 = 6 * ((1 - t) * ((b[2] - b[1]) - (b[1] - b[0])) + t * ((b[3] - b[2]) - (b[2] - b[1])));
      const double curvature = gauss_newton + d * d2 > 0.1 * gauss_newton ? gauss_newton + d * d2 : gauss_newton;
      const double next = curvature > 0 ? (std::min)(1., (std::max)(0., t - slope / curvature)) : t;
      const bool converged = std::abs(next - t) < 1e-12;
      t = next;
      if(converged)
        break;
    }
    const double distance = squared_distance(query, point({ t, 0 }));
    if(!(distance < squared_distance_bound))
      return false;
    squared_distance_bound = distance;
    x = { t, 0 };
    return true;
  }

  std::array<Point, 4> b; // the control points
};

// The creases and borders of a reference, joined to curves. A curve ends at a corner: a vertex that does not have two
// feature edges, or where the two form an angle of less than 120 degrees.
class Feature_curves
{
public:
  using Foot = Patch_foot; // a piece and its coordinate u

  // where curves meet
  struct Corner
  {
    Point point;
    std::size_t number_of_curves; // two or more
    double length;                // of the shortest of them
  };

  Feature_curves() = default;

  // `is_feature(e)` tells the features among the edges of `mesh`, `piece(e)` is the curve over edge e from edges[e][0] to
  // edges[e][1]. CGAL's split_graph_into_polylines() loses one of two edges between the same vertices, and makes it no
  // shorter.
  template <typename IsFeature, typename Piece>
  Feature_curves(const Mesh_arrays& mesh, const IsFeature& is_feature, const Piece& piece)
  {
    const std::vector<Edge_end> ends = find_ends(mesh, is_feature);
    const std::vector<Index> continuation = find_continuations(mesh, ends);
    std::vector<Curve_piece> pieces;
    std::vector<char> is_done(mesh.edges.size(), 0);
    std::vector<double> lengths(mesh.edges.size(), 0); // of the curves of which edges are the first or last
    const auto follow = [&](Index from_end)            // the curve that starts at this end of an edge
    {
      const Index first = static_cast<Index>(pieces.size());
      double length = 0;
      Index last = from_end;
      for(Index end = from_end; end != no_index && !is_done[end / 2]; end = continuation[end ^ 1])
      {
        is_done[end / 2] = 1;
        last = end;
        length += norm(mesh.points[mesh.edges[end / 2][1]] - mesh.points[mesh.edges[end / 2][0]]);
        const Index i = static_cast<Index>(pieces.size());
        pieces.push_back(end % 2 == 0 ? piece(end / 2) : piece(end / 2).reversed());
        m_curve.push_back(first);
        m_next.push_back(i + 1);
        m_previous.push_back(i == first ? no_index : i - 1);
      }
      lengths[from_end / 2] = lengths[last / 2] = length;
      const bool is_closed = continuation[from_end] != no_index;
      m_next.back() = is_closed ? first : no_index;
      if(is_closed)
        m_previous[first] = static_cast<Index>(pieces.size() - 1);
    };
    for(const bool is_closed : { false, true }) // the open curves first: what is left then is closed
      for(const auto& [vertex, end] : ends)
        if(!is_done[end / 2] && (is_closed || continuation[end] == no_index))
          follow(end);
    m_pieces = Patch_tree<Curve_piece>(std::move(pieces));
    find_corners(mesh, ends, continuation, lengths);
  }

  // whether a curve that leaves a vertex in the directions u and v passes through it rather than having a corner there
  static bool goes_straight_through(const Vector& u, const Vector& v) { return u * v < -0.5 * norm(u) * norm(v); }

  bool empty() const { return m_pieces.empty(); }
  const std::vector<Corner>& corners() const { return m_corners; }
  Index curve(const Foot& foot) const { return m_curve[foot.patch]; }
  Point point(const Foot& foot) const { return m_pieces.point(foot); }
  Vector tangent(const Foot& foot) const { return normalized(m_pieces.patch(foot.patch).derivative(foot.coordinates.u)); }

  // whether the foot is an end of its curve
  bool is_end(const Foot& foot) const
  {
    return (foot.coordinates.u <= 0 && m_previous[foot.patch] == no_index) ||
           (foot.coordinates.u >= 1 && m_next[foot.patch] == no_index);
  }

  // the closest point of all curves
  Foot project(const Point& query) const { return m_pieces.project(query); }

  // the closest point of the curve of `hint`, as far as walking from `hint` leads there
  Foot project_along(const Point& query, const Foot& hint) const
  {
    Foot foot = hint;
    double distance = (std::numeric_limits<double>::max)();
    m_pieces.patch(foot.patch).improve_foot_from(query, foot.coordinates, distance);
    for(std::size_t step = 0; step < m_next.size(); ++step)
    {
      const bool forward = foot.coordinates.u >= 1;
      if(!forward && foot.coordinates.u > 0)
        break;
      Foot neighbor{ forward ? m_next[foot.patch] : m_previous[foot.patch], { forward ? 0. : 1., 0. } };
      if(neighbor.patch == no_index ||
         !m_pieces.patch(neighbor.patch).improve_foot_from(query, neighbor.coordinates, distance))
        break;
      foot = neighbor;
    }
    return foot;
  }

private:
  using Edge_end = std::pair<Index, Index>; // a vertex, and end 0 or 1 of an edge e there: 2 e + 0 or 1

  // the ends of the feature edges, vertex by vertex
  template <typename IsFeature>
  static std::vector<Edge_end> find_ends(const Mesh_arrays& mesh, const IsFeature& is_feature)
  {
    std::vector<Edge_end> ends;
    for(Index e = 0; e < mesh.edges.size(); ++e)
      if(is_feature(e))
        for(Index k = 0; k < 2; ++k)
          ends.emplace_back(mesh.edges[e][k], 2 * e + k);
    std::sort(ends.begin(), ends.end());
    return ends;
  }

  // for each end of an edge, that of the next edge where the curve goes on beyond it
  static std::vector<Index> find_continuations(const Mesh_arrays& mesh, const std::vector<Edge_end>& ends)
  {
    std::vector<Index> continuation(2 * mesh.edges.size(), no_index);
    for(std::size_t first = 0, last; first < ends.size(); first = last)
    {
      for(last = first; last < ends.size() && ends[last].first == ends[first].first;)
        ++last;
      if(last - first != 2)
        continue;
      const Index a = ends[first].second, b = ends[first + 1].second;
      const Point& p = mesh.points[ends[first].first];
      const Vector u = mesh.points[mesh.edges[a / 2][1 - a % 2]] - p, v = mesh.points[mesh.edges[b / 2][1 - b % 2]] - p;
      if(goes_straight_through(u, v))
      {
        continuation[a] = b;
        continuation[b] = a;
      }
    }
    return continuation;
  }

  void find_corners(const Mesh_arrays& mesh,
                    const std::vector<Edge_end>& ends,
                    const std::vector<Index>& continuation,
                    const std::vector<double>& lengths)
  {
    for(std::size_t first = 0, last; first < ends.size(); first = last)
    {
      for(last = first; last < ends.size() && ends[last].first == ends[first].first;)
        ++last;
      if(last - first < 2 || continuation[ends[first].second] != no_index)
        continue;
      m_corners.push_back({ mesh.points[ends[first].first], last - first, (std::numeric_limits<double>::max)() });
      for(std::size_t k = first; k < last; ++k)
        m_corners.back().length = (std::min)(m_corners.back().length, lengths[ends[k].second / 2]);
    }
  }

  Patch_tree<Curve_piece> m_pieces;
  std::vector<Corner> m_corners;
  std::vector<Index> m_curve; // of each piece: the first piece of its curve
  std::vector<Index> m_next, m_previous;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FEATURE_CURVES_H
