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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_BOUNDARY_CURVES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_BOUNDARY_CURVES_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/sector_normals.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The boundary curve of the patches at an edge, a cubic Bezier curve: by how much its inner control points lie off the
// edge. Both patches have the same curve.
struct Boundary_curve
{
  std::array<Vector, 2> offsets{ { NULL_VECTOR, NULL_VECTOR } }; // near the first and the second end of the edge
  std::array<bool, 2> is_limited{ { false, false } };            // whether the tangent planes would require larger ones
};

// The offset of the control point near an end of an edge, by which the curve is tangent to the plane with this normal.
inline Vector tangential_offset(const Vector& edge, const Vector& normal) { return ((edge * normal) / -3) * normal; }

// The offset of the control point near the end `from` of the edge `to - from`, by which the curve is tangent to the planes
// with the given normals, those of both sides of the edge.
inline Vector tangential_offset(const Vector& edge, const Vector& normal, const Vector& normal_across)
{
  const Vector t = cross_product(normal, normal_across);
  const double t2 = t.squared_length();
  if(t2 > 0.01)
  {
    const Vector offset = (((edge * t) / t2) * t - edge) / 3;
    // the flatter the crease, the farther off their intersection may be
    const double distance = norm(offset);
    const double limit = 2. / 3 * (std::max)(std::abs(edge * normal), std::abs(edge * normal_across));
    return distance > limit ? (limit / distance) * offset : offset;
  }

  // the planes are nearly the same: below some 6 degrees, their intersection is unreliable
  return tangential_offset(edge, normalized(normal + normal_across));
}

// How an edge may bend, according to the surface beyond one of its ends.
struct Bend
{
  bool goes_on;        // the surface bends there, too
  double length_limit; // the curve must not leave the edge farther than that of an edge of this length would
};

// Beyond the end of an edge that leaves `sector`; at least what matters to one that is bent already.
inline Bend bend_beyond(const Sector_graph& graph,
                        const std::vector<Vector>& normals,
                        const Index sector,
                        const Vector& edge,
                        const double length,
                        const bool is_bent)
{
  constexpr double cosine = 0.6;        // an edge continues another one if it turns by less than 53 degrees
  constexpr double least_slope = 0.125; // relative to that of the edge
  constexpr double longest = 4;         // relative to the edge that continues this one

  const Vector& n = normals[sector];
  const double slope = n * edge;
  Bend bend{ is_bent, 0 };
  for(const Sector_graph::Edge& other : graph.edges(sector))
  {
    const Vector along = graph.point(other.other) - graph.point(sector);
    const double product = along * edge, length2 = along.squared_length();
    if(product >= 0 || square(product) < square(cosine * length) * length2)
      continue;
    const double length_of_other = std::sqrt(length2);
    bend.goes_on = bend.goes_on || slope * (n * along) * length > least_slope * square(slope) * length_of_other;
    bend.length_limit = (std::max)(bend.length_limit, longest * length_of_other);
    if(bend.goes_on && bend.length_limit >= length)
      return bend; // which other edges would not change
  }
  return bend.length_limit > 0 ? bend : Bend{ true, (std::numeric_limits<double>::max)() }; // nothing continues the edge
}

// The boundary curve of the patches at edge e, which is not in a facet. It is tangent to the planes at its ends as far as
// these agree:
//   - at one end a curve leaves its edge at most three times as far as at the other one: it does not leave an edge one end
//     of which is flat;
//   - it leaves an edge only if the surface bends beyond one of its ends as well: a single facet between flat ones is a
//     chamfer, not a rounding;
//   - it leaves an edge at most as far as one four times as long as the edge that continues it: a facet is not bent because
//     of much smaller ones beside it.
inline Boundary_curve make_boundary_curve(const Mesh_arrays& mesh,
                                          const Sector_graph& graph,
                                          const std::vector<Vector>& normals,
                                          const std::size_t e)
{
  constexpr double largest_ratio = 3;

  Boundary_curve curve;
  const Vector d = mesh.points[mesh.edges[e][1]] - mesh.points[mesh.edges[e][0]];
  const double length = norm(d);
  if(mesh.edge_corners[e][0] == no_index || !(length > 0))
    return curve;

  std::array<double, 2> distances, limits{ { 0, 0 } };
  bool is_bent = false;
  for(int end = 0; end < 2; ++end)
  {
    const Vector from_end = end == 0 ? d : -d;
    const std::array<Index, 2> sectors = graph.sectors_at_end(mesh, e, end);
    const bool is_crease = sectors[0] != sectors[1];
    curve.offsets[end] = is_crease ? tangential_offset(from_end, normals[sectors[0]], normals[sectors[1]])
                                   : tangential_offset(from_end, normals[sectors[0]]);
    distances[end] = norm(curve.offsets[end]);
    for(int side = 0; side < (is_crease ? 2 : 1); ++side)
    {
      const Bend bend = bend_beyond(graph, normals, sectors[side], from_end, length, is_bent);
      is_bent = is_bent || bend.goes_on;
      limits[end] = (std::max)(limits[end], distances[end] * (std::min)(1., bend.length_limit / length));
    }
  }
  for(int end = 0; end < 2; ++end)
  {
    const double limit = is_bent ? (std::min)(limits[end], largest_ratio * limits[1 - end]) : 0;
    curve.is_limited[end] = limit < distances[end];
    if(curve.is_limited[end])
      curve.offsets[end] = (limit / distances[end]) * curve.offsets[end];
  }
  return curve;
}

// The normal closest to that of the facet that is orthogonal to two tangents; where these are nearly collinear and so say
// nothing in one direction, that of the facet in this direction.
inline Vector orthogonal_normal(const Vector& facet_normal, const Vector& tangent, const Vector& other_tangent)
{
  constexpr double collinear = 1e-2; // square of the sine

  Normal_correction correction;
  for(const Vector& t : { normalized(tangent), normalized(other_tangent) })
    correction.change_slope(1, t, -(facet_normal * t));
  correction.pull(collinear, NULL_VECTOR);
  return normalized(facet_normal + correction.solve());
}

// The boundary curves of the patches, and the normals at their corners.
class Patch_boundaries
{
public:
  template <typename ConcurrencyTag>
  Patch_boundaries(const Mesh_arrays& mesh,
                   const Facets& facets,
                   const Sector_graph& graph,
                   const std::vector<Vector>& sector_normals,
                   const ConcurrencyTag&)
    : m_mesh(mesh), m_facets(facets), m_graph(graph), m_sector_normals(sector_normals), m_curves(mesh.edges.size())
  {
    for_each_index<ConcurrencyTag>(m_curves.size(), [&](std::size_t e) {
      if(!facets.contain(e))
        m_curves[e] = make_boundary_curve(mesh, graph, sector_normals, e);
    });
    // the curves inside a facet are orthogonal to the normals at its corners, so that its triangulation does not show
    for_each_index<ConcurrencyTag>(m_curves.size(), [&](std::size_t e) {
      if(!facets.contain(e))
        return;
      const Index corner = mesh.edge_corners[e][0];
      for(Index c : { Mesh_arrays::next(corner), Mesh_arrays::previous(corner) })
      {
        const int end = end_at(e, c);
        const Vector d = mesh.points[mesh.edges[e][1 - end]] - mesh.points[mesh.edges[e][end]];
        m_curves[e].offsets[end] = tangential_offset(d, normal(c));
      }
    });
  }

  // of the control point of edge e that is next to the corner c
  const Vector& offset(Index e, Index c) const { return m_curves[e].offsets[end_at(e, c)]; }

  // The normal at a corner: that of its sector, unless the boundary curves of the facet are limited and so have another
  // tangent plane there.
  Vector normal(const Index c) const
  {
    const Index before = facet_end(c, false), after = facet_end(c, true);
    const bool is_limited =
      (before != no_index && curve_is_limited(before, false)) || (after != no_index && curve_is_limited(after, true));
    if(!is_limited)
      return m_sector_normals[m_graph.sector(c)];
    return orthogonal_normal(m_facets.normal[c / 3], tangent(before, false), tangent(after, true));
  }

private:
  int end_at(const std::size_t e, const Index c) const { return m_mesh.edges[e][0] == m_mesh.vertex(c) ? 0 : 1; }

  // the edge at corner c beyond which the next corner around the vertex is, or the previous one
  Index edge_at(const Index c, const bool forward) const
  {
    return m_mesh.opposite_edge(forward ? Mesh_arrays::next(c) : Mesh_arrays::previous(c));
  }

  // The last corner of the facet of `corner`, going around the vertex one way or the other; no_index inside the facet.
  Index facet_end(const Index corner, const bool forward) const
  {
    Index c = corner;
    while(m_facets.contain(edge_at(c, forward)))
    {
      c = forward ? m_mesh.corner_across_next(c) : m_mesh.corner_across_previous(c);
      if(c == corner)
        return no_index;
    }
    return c;
  }

  bool curve_is_limited(const Index c, const bool forward) const
  {
    const Index e = edge_at(c, forward);
    return m_curves[e].is_limited[end_at(e, c)];
  }

  // where the curve over this edge leaves the vertex; the null vector if there is no corner c
  Vector tangent(const Index c, const bool forward) const
  {
    if(c == no_index)
      return NULL_VECTOR;
    const Index far = forward ? Mesh_arrays::previous(c) : Mesh_arrays::next(c);
    return (m_mesh.points[m_mesh.vertex(far)] - m_mesh.points[m_mesh.vertex(c)]) / 3 + offset(edge_at(c, forward), c);
  }

  const Mesh_arrays& m_mesh;
  const Facets& m_facets;
  const Sector_graph& m_graph;
  const std::vector<Vector>& m_sector_normals;
  std::vector<Boundary_curve> m_curves; // of the edges
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_BOUNDARY_CURVES_H
