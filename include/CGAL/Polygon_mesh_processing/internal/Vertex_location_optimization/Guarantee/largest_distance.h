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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_LARGEST_DISTANCE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_LARGEST_DISTANCE_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Face_sampling.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Farthest_point.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <boost/range/irange.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The largest distance of face f with its corners at `t`, if it is larger than `bound`; otherwise `bound`. It may be at a
// sample where the search has not found it: `sampled_maximum` is that of the samples and the barycenter, or larger if walking
// has missed closer points. `feet` are hints.
template <typename Reference>
double largest_distance_on_face(const Reference& reference,
                                const Face_sampling& sampling,
                                const std::size_t f,
                                const std::array<Point, 3>& t,
                                const Face_feet<typename Reference::Foot>& feet,
                                const double sampled_maximum,
                                const double bound,
                                const bool is_any_enough = false)
{
  const double found = Farthest_point<Reference>(reference)(t, feet.of_corners, bound, is_any_enough);
  if(sampled_maximum <= found)
    return found;
  const Point barycenter = point_at(t, barycenter_coordinates);
  const double at_barycenter = distance_to_foot(barycenter, reference, reference.project(barycenter, feet.of_midpoints[0]));
  return (std::max)({ found, at_barycenter, sampling.largest_distance(reference, f, t, feet) });
}

// The largest distance of the faces with the largest samples. `largest_on_face(f, bound)` is that of face f, or `bound`.
template <typename SampledMaximum, typename LargestOnFace>
double largest_distance(const Remesh& remesh, const SampledMaximum& sampled_maximum, const LargestOnFace& largest_on_face)
{
  constexpr int max_faces = 64; // it trades time for a maximum that is elsewhere
  const auto all = boost::irange<std::size_t>(0, remesh.number_of_faces());
  std::array<std::size_t, max_faces> faces;
  const auto end =
    std::partial_sort_copy(all.begin(), all.end(), faces.begin(), faces.end(), [&](std::size_t f, std::size_t g) {
      return std::make_pair(-sampled_maximum(f), f) < std::make_pair(-sampled_maximum(g), g);
    });

  double maximum = 0;
  for(auto f = faces.begin(); f != end; ++f)
    maximum = largest_on_face(*f, maximum);
  return maximum;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_LARGEST_DISTANCE_H
