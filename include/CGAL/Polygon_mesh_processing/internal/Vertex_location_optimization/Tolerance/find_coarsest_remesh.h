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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIND_COARSEST_REMESH_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIND_COARSEST_REMESH_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Tolerance/Edge_length_search.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Tolerance/first_edge_length.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Tolerance/Remeshing_attempt.h>

#include <cstddef>
#include <utility>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// the approximate ratio of the tolerated error to the mean error of a uniform remesh, for the first edge length
inline double ratio_to_mean(Tolerated_error kind) { return kind == MAXIMUM_ERROR ? 5 : kind == MEAN_ERROR ? 1 : 1.4; }

// Whether a remesh is a better result: within the tolerance with fewer vertices, or with less error if none is.
inline bool is_better(const Tolerance_report& a, const Tolerance_report& b, Tolerated_error kind)
{
  if(a.is_within_tolerance != b.is_within_tolerance)
    return a.is_within_tolerance;
  const bool has_less_error = tolerated_value(a, kind) < tolerated_value(b, kind);
  if(!a.is_within_tolerance || a.number_of_vertices == b.number_of_vertices)
    return has_less_error;
  return a.number_of_vertices < b.number_of_vertices;
}

struct Search_limits
{
  double edge_length_precision;
  std::size_t number_of_remeshings;
};

// Remeshes with one edge length after the other; the best remesh is the result.
template <typename ConcurrencyTag,
          typename TriangleMesh,
          typename Remesh,
          typename Surface,
          typename NamedParameters,
          typename Visitor>
Tolerance_report find_coarsest_remesh(const Tolerance_setting<TriangleMesh, Surface>& setting,
                                      const Mesh_extent& extent,
                                      const Search_limits& limits,
                                      const Remesh& remesh,
                                      const NamedParameters& np,
                                      Visitor& visitor,
                                      TriangleMesh& result)
{
  const Edge_length_range range =
    find_edge_length_range(extent, setting.input_arrays.number_of_faces(), setting.tolerance, ratio_to_mean(setting.kind));
  Edge_length_search search(range.first, range.shortest, range.longest, limits.edge_length_precision);
  Tolerance_report best;
  TriangleMesh best_mesh;
  std::size_t count = 0;
  while(!search.is_finished() && count < limits.number_of_remeshings && visitor.go_further())
  {
    const double edge_length = search.next_length();
    visitor.start_remeshing(edge_length);
    TriangleMesh mesh = setting.input;
    const auto [report, error] = try_edge_length<ConcurrencyTag>(setting, edge_length, ++count, remesh, np, visitor, mesh);
    visitor.end_remeshing(report);
    search.add({ edge_length, error, report.is_within_tolerance, report.number_of_vertices });
    if(is_better(report, best, setting.kind))
    {
      best = report;
      best_mesh = std::move(mesh);
    }
  }
  best.number_of_remeshings = count;
  if(best.number_of_vertices > 0)
    result = std::move(best_mesh);
  return best;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIND_COARSEST_REMESH_H
