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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIND_FACES_TO_SPLIT_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIND_FACES_TO_SPLIT_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Mesh_arrays.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

inline Index find_longest_side(const Mesh_arrays& mesh, std::size_t f)
{
  const auto length = [&](Index e) {
    return squared_distance(mesh.points[mesh.edges[e][0]], mesh.points[mesh.edges[e][1]]);
  };
  const auto& sides = mesh.face_edges[f];
  return *std::max_element(sides.begin(), sides.end(), [&](Index d, Index e) { return length(d) < length(e); });
}

// the faces that deviate by more than `limit`, the worst first
inline std::vector<std::size_t> find_faces_beyond(double limit, const std::vector<double>& deviations)
{
  std::vector<std::size_t> faces;
  for(std::size_t f = 0; f < deviations.size(); ++f)
    if(deviations[f] > limit)
      faces.push_back(f);
  std::sort(faces.begin(), faces.end(), [&](std::size_t f, std::size_t g) {
    return std::make_tuple(-deviations[f], f) < std::make_tuple(-deviations[g], g);
  });
  return faces;
}

// Selects faces to be split at their longest sides, in the given order, but none next to the two faces of a side that is
// already selected. A split and the fit that follows often improve the faces around as well; otherwise, these are split in a
// later round.
inline std::vector<std::size_t> find_faces_to_split(const Mesh_arrays& mesh, const std::vector<std::size_t>& faces)
{
  std::vector<char> is_near(mesh.number_of_faces(), false);
  const auto for_each_face_of = [&](Index e, const auto& f) {
    for(Index corner : mesh.edge_corners[e])
      if(corner != no_index)
        f(corner / 3);
  };
  std::vector<std::size_t> result;
  for(std::size_t f : faces)
    if(!is_near[f])
    {
      result.push_back(f);
      for_each_face_of(find_longest_side(mesh, f), [&](Index g) {
        for(Index side : mesh.face_edges[g])
          for_each_face_of(side, [&](Index neighbor) { is_near[neighbor] = true; });
      });
    }
  return result;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIND_FACES_TO_SPLIT_H
