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
  std::array<bool, 2> is_limited{ { false, false } };            // whether the tangent planes ask for more
};

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

  // the planes are nearly the same: below some 6 degrees their intersection says little
  const Vector n = normalized(normal + normal_across);
  return ((edge * n) / -3) * n;
}

// What the surface beyond the end of an edge says about how the edge bends.
struct Bend
{
  bool goes_on;        // the surface bends there, too
  double length_limit; // the curve must not leave the edge farther than that of an edge of this length would
};

// Beyond the end of an edge that leaves `sector` in this direction.
inline Bend
bend_beyond(const Sector_graph& graph, const std::vector<Vector>& normals, const Index sector, const Vector& direction)
{
  constexpr double cosine = 0.6;        // an edge continues another one if it turns by less than 53 degrees
  constexpr double least_slope = 0.125; // relative to that of the edge
  constexpr double longest = 4;         // relative to the edge that continues this one

  const Vector& n = normals[sector];
  const double slope = n * direction;
  Bend bend{ false, 0 };
  graph.for_each_edge(sector, [&](Index, const Vector& other, const Sector_graph::Edge& edge) {
    if(other * direction > -cosine)
      return;
    bend.goes_on = bend.goes_on || slope * (n * other) > least_slope * square(slope);
    bend.length_limit = (std::max)(bend.length_limit, longest * edge.length);
  });
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
    curve.offsets[end] = tangential_offset(from_end, normals[sectors[0]], normals[sectors[1]]);
    distances[end] = norm(curve.offsets[end]);
    for(int side = 0; side < (sectors[0] == sectors[1] ? 1 : 2); ++side)
    {
      const Bend bend = bend_beyond(graph, normals, sectors[side], from_end / length);
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

// Where the boundary curve that ends the facet of a corner leaves the vertex, going around it one way or the other; the
// null vector inside the facet. Says, too, whether the curve is limited.
inline Vector boundary_tangent(const Mesh_arrays& mesh,
                               const Facets& facets,
                               const std::vector<Boundary_curve>& curves,
                               const Index corner,
                               const bool forward,
                               bool& is_limited)
{
  Index c = corner;
  do
  {
    const Index far = forward ? Mesh_arrays::previous(c) : Mesh_arrays::next(c);
    const Index e = mesh.opposite_edge(forward ? Mesh_arrays::next(c) : Mesh_arrays::previous(c));
    if(!facets.contain(mesh, e))
    {
      const int end = mesh.edges[e][0] == mesh.vertex(c) ? 0 : 1;
      is_limited = is_limited || curves[e].is_limited[end];
      return (mesh.points[mesh.vertex(far)] - mesh.points[mesh.vertex(c)]) / 3 + curves[e].offsets[end];
    }
    c = forward ? mesh.corner_across_next(c) : mesh.corner_across_previous(c);
  }
  while(c != corner);
  return NULL_VECTOR;
}

// The boundary curves and the normals at the corners of the patches.
struct Patch_boundaries
{
  std::vector<Boundary_curve> curves; // of the edges
  std::vector<Vector> normals;        // of the corners
};

// The normal at a corner is that of its sector, unless the boundary curves of the facet are limited and so have another
// tangent plane there. The curves inside a facet are orthogonal to these normals, so that its triangulation does not show.
template <typename ConcurrencyTag>
Patch_boundaries compute_patch_boundaries(const Mesh_arrays& mesh,
                                          const Facets& facets,
                                          const Sector_graph& graph,
                                          const std::vector<Vector>& sector_normals)
{
  std::vector<Boundary_curve> curves(mesh.edges.size());
  for_each_index<ConcurrencyTag>(curves.size(), [&](std::size_t e) {
    if(!facets.contain(mesh, e))
      curves[e] = make_boundary_curve(mesh, graph, sector_normals, e);
  });

  std::vector<Vector> normals(3 * mesh.number_of_faces());
  for_each_index<ConcurrencyTag>(normals.size(), [&](std::size_t i) {
    const Index c = static_cast<Index>(i);
    bool is_limited = false;
    const Vector to_next = boundary_tangent(mesh, facets, curves, c, false, is_limited);
    const Vector to_previous = boundary_tangent(mesh, facets, curves, c, true, is_limited);
    normals[i] =
      is_limited ? orthogonal_normal(facets.normal[c / 3], to_next, to_previous) : sector_normals[graph.sector(c)];
  });

  for_each_index<ConcurrencyTag>(curves.size(), [&](std::size_t e) {
    if(!facets.contain(mesh, e))
      return;
    const Index corner = mesh.edge_corners[e][0];
    for(Index c : { Mesh_arrays::next(corner), Mesh_arrays::previous(corner) })
    {
      const int end = mesh.edges[e][0] == mesh.vertex(c) ? 0 : 1;
      const Vector d = mesh.points[mesh.edges[e][1 - end]] - mesh.points[mesh.edges[e][end]];
      curves[e].offsets[end] = tangential_offset(d, normals[c], normals[c]);
    }
  });
  return { std::move(curves), std::move(normals) };
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_BOUNDARY_CURVES_H
