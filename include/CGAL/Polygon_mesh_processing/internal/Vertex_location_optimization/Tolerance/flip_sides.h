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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FLIP_SIDES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FLIP_SIDES_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// how well faces fit the reference
struct Fit_of_faces
{
  double distance;  // the largest one, at some points
  double alignment; // the smallest cosine of the angle between their normals and those of the reference

  Fit_of_faces operator+(const Fit_of_faces& other) const
  {
    return { (std::max)(distance, other.distance), (std::min)(alignment, other.alignment) };
  }
};

template <typename Reference>
Fit_of_faces measure_fit(const std::array<Point, 3>& t, const Reference& reference)
{
  constexpr int n = 6; // pieces of a side: as coarse as finds the face that fits
  double distance2 = 0;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; i + j <= n; ++j)
    {
      const Point p = t[0] + (double(i) / n) * (t[1] - t[0]) + (double(j) / n) * (t[2] - t[0]);
      distance2 = (std::max)(distance2, squared_distance(p, reference.point(reference.project(p))));
    }
  const Vector normal = area_normal(t[0], t[1], t[2]);
  const double area = norm(normal);
  const Vector normal_of_reference = reference.normal(reference.project(centroid(t[0], t[1], t[2])));
  return { std::sqrt(distance2), area > 0 ? normal * normal_of_reference / area : -1 };
}

// Flips sides of faces where the two faces of the flipped edge are closer to the reference, so that, for example, vertices
// on a ridge are joined along the ridge and not across it.
template <typename TriangleMesh, typename VertexPointMap, typename EdgeIsConstrainedMap, typename Reference>
class Side_flips
{
  using graph_traits = boost::graph_traits<TriangleMesh>;
  using face_descriptor = typename graph_traits::face_descriptor;
  using halfedge_descriptor = typename graph_traits::halfedge_descriptor;
  using vertex_descriptor = typename graph_traits::vertex_descriptor;
  using Halfedges = std::vector<halfedge_descriptor>;

public:
  Side_flips(TriangleMesh& mesh,
             const VertexPointMap& vpm,
             const EdgeIsConstrainedMap& is_constrained,
             const Reference& reference)
    : m_mesh(mesh), m_vpm(vpm), m_is_constrained(is_constrained), m_reference(reference)
  {}

  // Flips at most one side of each of the faces, the first ones first, but none with which faces intersect that did not
  // before. Returns the flipped edges. `find_self_intersections` is a `Self_intersection_test`.
  template <typename FindSelfIntersections>
  Halfedges flip(const std::vector<face_descriptor>& faces,
                 const std::vector<Point>& points,
                 const FindSelfIntersections& find_self_intersections) const
  {
    const auto pairs_before = find_self_intersections(points);
    Halfedges flipped = flip_best_sides(faces);
    for(bool is_changed = !flipped.empty(); is_changed;)
    {
      const auto pairs = find_self_intersections(points);
      std::set<Index> numbers; // of the faces that have come to intersect
      for(const auto& pair : pairs)
        if(!std::binary_search(pairs_before.begin(), pairs_before.end(), pair))
          numbers.insert({ pair.first[0], pair.second[0] });
      is_changed = !numbers.empty() && flip_back(numbers, flipped);
    }
    return flipped;
  }

private:
  Halfedges flip_best_sides(const std::vector<face_descriptor>& faces_to_flip) const
  {
    const auto is_flipped = get(dynamic_face_property_t<bool>(), m_mesh);
    for(auto f : faces(m_mesh))
      put(is_flipped, f, false);
    Halfedges flipped;
    for(auto f : faces_to_flip)
    {
      if(get(is_flipped, f))
        continue;
      double least_ratio = largest_ratio;
      halfedge_descriptor best = graph_traits::null_halfedge();
      for(auto h : halfedges_around_face(halfedge(f, m_mesh), m_mesh))
      {
        if(!can_flip(h) || get(is_flipped, face(opposite(h, m_mesh), m_mesh)))
          continue;
        const double ratio = ratio_of_distances(h);
        if(ratio < least_ratio)
          best = h;
        least_ratio = (std::min)(least_ratio, ratio);
      }
      if(best == graph_traits::null_halfedge())
        continue;
      put(is_flipped, f, true);
      put(is_flipped, face(opposite(best, m_mesh), m_mesh), true);
      Euler::flip_edge(best, m_mesh);
      flipped.push_back(best);
    }
    return flipped;
  }

  bool can_flip(halfedge_descriptor h) const
  {
    if(is_border_edge(h, m_mesh) || get(m_is_constrained, edge(h, m_mesh)))
      return false;
    const auto v = opposite_vertex(h), w = opposite_vertex(opposite(h, m_mesh));
    return v != w && !halfedge(v, w, m_mesh).second && degree(source(h, m_mesh), m_mesh) > 3 &&
           degree(target(h, m_mesh), m_mesh) > 3;
  }

  // Of the faces of the flipped edge to those of the edge; infinite where they are worse aligned with the reference.
  double ratio_of_distances(halfedge_descriptor h) const
  {
    constexpr double good_alignment = 0.5;
    const Point p = point(source(h, m_mesh)), q = point(target(h, m_mesh)), r = point(opposite_vertex(h)),
                s = point(opposite_vertex(opposite(h, m_mesh)));
    const Fit_of_faces before = measure_fit({ p, q, r }, m_reference) + measure_fit({ q, p, s }, m_reference);
    const Fit_of_faces after = measure_fit({ p, s, r }, m_reference) + measure_fit({ s, q, r }, m_reference);
    return after.alignment < (std::min)(before.alignment, good_alignment) ? std::numeric_limits<double>::infinity()
                                                                          : after.distance / before.distance;
  }

  // takes back the flips of edges at the faces with these numbers, in the order of the mesh; returns whether there are any
  bool flip_back(const std::set<Index>& numbers, Halfedges& flipped) const
  {
    std::set<face_descriptor> intersecting;
    Index number = 0;
    for(auto f : faces(m_mesh))
      if(numbers.count(number++) > 0)
        intersecting.insert(f);
    const auto is_kept = [&](halfedge_descriptor h) {
      return intersecting.count(face(h, m_mesh)) == 0 && intersecting.count(face(opposite(h, m_mesh), m_mesh)) == 0;
    };
    const auto end = std::stable_partition(flipped.begin(), flipped.end(), is_kept);
    const bool is_changed = end != flipped.end();
    std::for_each(end, flipped.end(), [&](halfedge_descriptor h) { Euler::flip_edge(h, m_mesh); });
    flipped.erase(end, flipped.end());
    return is_changed;
  }

  vertex_descriptor opposite_vertex(halfedge_descriptor h) const { return target(next(h, m_mesh), m_mesh); }
  Point point(vertex_descriptor v) const { return convert<Point>(get(m_vpm, v)); }

  static constexpr double largest_ratio = 0.9; // a flip that gains less may be undone by the fit that follows

  TriangleMesh& m_mesh;
  const VertexPointMap& m_vpm;
  const EdgeIsConstrainedMap& m_is_constrained;
  const Reference& m_reference;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FLIP_SIDES_H
