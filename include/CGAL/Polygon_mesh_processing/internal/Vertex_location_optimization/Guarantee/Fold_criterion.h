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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FOLD_CRITERION_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FOLD_CRITERION_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// A face violates it if one of its edges is a spike: folded more sharply than all edges at its two ends were at first, and
// than the reference turns under its two faces. `ReferenceNormals` is a functor f -> normals of the reference under face f.
// A model of the criteria of `shorten_moves()`.
//
// At an edge between polygons several triangles of their fans meet, whose folds differ as little as the polygons are planar.
// The two of `edge_corners` stand for all of them, and are those that violate the criterion. A diagonal is not a fold: the
// criterion ignores how far a polygon is from planar.
template <typename ReferenceNormals>
class Fold_criterion
{
public:
  Fold_criterion(const Remesh& remesh, const ReferenceNormals& reference_normals)
    : m_remesh(remesh), m_reference_normals(reference_normals), m_sharpest(remesh.points.size(), 1)
  {
    for(Index e = 0; e < remesh.edges.size(); ++e)
      if(may_fold(e) && is_folded(e, remesh.initial_points, cosine_of_relevant))
      {
        const double cosine = cosine_of_fold(e, remesh.initial_points);
        for(Index i : remesh.edges[e])
          m_sharpest[i] = (std::min)(m_sharpest[i], cosine);
      }
  }

  bool is_violated_by(std::size_t f) const
  {
    const std::array<Index, 3>& edges = m_remesh.face_edges[f];
    return std::any_of(edges.begin(), edges.end(), [&](Index e) { return folds_at(f, e) && is_spike(e); });
  }

private:
  bool may_fold(Index e) const { return !m_remesh.is_border(e) && !m_remesh.is_diagonal(e); }

  // whether face f, at edge e, is one of the two between which the fold is measured
  bool folds_at(std::size_t f, Index e) const
  {
    const auto [c, d] = m_remesh.edge_corners[e];
    return may_fold(e) && (c / 3 == f || d / 3 == f);
  }

  bool is_spike(Index e) const
  {
    constexpr double slack = CGAL_PI / 36, margin = CGAL_PI / 18; // 5 and 10 degrees, the latter for what is between samples
    if(!is_folded(e, m_remesh.next_points, 0))                    // less than a right angle is no spike
      return false;
    const double fold = std::acos((std::max)(cosine_of_fold(e, m_remesh.next_points), -1.));
    const auto [i, j] = m_remesh.edges[e];
    if(fold <= slack + std::acos(std::clamp((std::min)(m_sharpest[i], m_sharpest[j]), -1., 1.)))
      return false;
    const auto [c, d] = m_remesh.edge_corners[e];
    const auto of_one = m_reference_normals(c / 3), of_other = m_reference_normals(d / 3);
    const double limit = std::cos(fold - margin);
    return std::none_of(of_one.begin(), of_one.end(), [&](const Vector& m) {
      return std::any_of(of_other.begin(), of_other.end(), [&](const Vector& n) { return m * n <= limit; });
    });
  }

  // whether an edge is folded so much that the cosine is less than `limit`; faster than the cosine
  bool is_folded(Index e, const std::vector<Point>& points, double limit) const
  {
    const auto [c, d] = m_remesh.edge_corners[e];
    const Vector m = m_remesh.area_normal(c / 3, points), n = m_remesh.area_normal(d / 3, points);
    const double product = m * n;
    return product < 0 || (limit > 0 && square(product) < square(limit) * (m.squared_length() * n.squared_length()));
  }

  double cosine_of_fold(Index e, const std::vector<Point>& points) const
  {
    const auto [c, d] = m_remesh.edge_corners[e];
    return normalized(m_remesh.area_normal(c / 3, points)) * normalized(m_remesh.area_normal(d / 3, points));
  }

  static constexpr double cosine_of_relevant = 0.1; // of 84 degrees: sharper than less by the slack is no spike

  const Remesh& m_remesh;
  const ReferenceNormals m_reference_normals;
  std::vector<double> m_sharpest; // the cosine of the sharpest fold at each vertex at first
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FOLD_CRITERION_H
