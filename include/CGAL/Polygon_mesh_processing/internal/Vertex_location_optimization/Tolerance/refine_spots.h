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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_REFINE_SPOTS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_REFINE_SPOTS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/New_intersections.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_mesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Tolerance/find_faces_to_split.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Tolerance/flip_sides.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Tolerance/pull_vertices.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Tolerance/split_faces.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Changes a mesh at faces that are beyond the tolerance, for a fit to follow. Three things help:
//   - a flip, where faces join the wrong vertices;
//   - a pull, where a vertex itself exceeds the tolerance, for example on a fold that is not closest to any point of the
//     reference;
//   - a split, where there are too few vertices.
template <typename ConcurrencyTag,
          typename TriangleMesh,
          typename VertexPointMap,
          typename EdgeIsConstrainedMap,
          typename Reference>
class Spot_refinement
{
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Faces = std::vector<face_descriptor>;
  using Vertices = std::vector<vertex_descriptor>;

public:
  // `mesh` and `descriptors` are those of `tmesh`.
  Spot_refinement(const Mesh_arrays& mesh,
                  const Mesh_descriptors<TriangleMesh>& descriptors,
                  const Reference& reference,
                  TriangleMesh& tmesh,
                  const VertexPointMap& vpm,
                  const EdgeIsConstrainedMap& is_constrained)
    : m_mesh(mesh), m_descriptors(descriptors), m_reference(reference), m_tmesh(tmesh), m_vpm(vpm),
      m_is_constrained(is_constrained), m_find_self_intersections(tmesh, vpm, descriptors, true)
  {}

  // Refines at faces of `mesh`, the worst ones first, which are farther than `limit` from the reference, once. Returns the
  // faces around what has changed, whose vertices should be fitted again.
  Faces refine(const std::vector<std::size_t>& faces_beyond, const double limit)
  {
    Faces faces;
    for(std::size_t f : faces_beyond)
      faces.push_back(face(m_descriptors.halfedges[f], m_tmesh));
    Vertices changed;
    const Faces flipped = flip(faces, changed);
    for(Index i : pull_vertices(find_far_vertices(faces_beyond, limit), m_mesh, m_descriptors, m_vpm,
                                m_find_self_intersections, m_reference))
      changed.push_back(m_descriptors.vertices[i]);
    split(faces_beyond, faces, flipped, changed);
    return faces_around(changed);
  }

private:
  // returns the faces of the flipped edges
  Faces flip(const Faces& faces, Vertices& changed) const
  {
    const Side_flips<TriangleMesh, VertexPointMap, EdgeIsConstrainedMap, Reference> flips(m_tmesh, m_vpm, m_is_constrained,
                                                                                          m_reference);
    Faces flipped;
    for(auto h : flips.flip(faces, m_mesh.points, m_find_self_intersections))
      for(auto g : { h, opposite(h, m_tmesh) })
      {
        flipped.push_back(face(g, m_tmesh));
        for(auto v : vertices_around_face(g, m_tmesh))
          changed.push_back(v);
      }
    return flipped;
  }

  // the vertices of the faces that are near the limit or beyond themselves, but for those of creases and borders
  std::vector<Index> find_far_vertices(const std::vector<std::size_t>& faces_beyond, const double limit) const
  {
    constexpr double part = 0.9; // of the limit; a fit leaves vertices of good faces off the surface, too
    std::vector<char> is_done(m_mesh.points.size(), false);
    for(std::size_t e = 0; e < m_mesh.edges.size(); ++e)
      if(m_mesh.is_border(e) || get(m_is_constrained, m_descriptors.edges[e]))
        for(Index i : m_mesh.edges[e])
          is_done[i] = true;
    std::vector<Index> result;
    for(std::size_t f : faces_beyond)
      for(Index i : m_mesh.face(f))
      {
        const Point& p = m_mesh.points[i];
        if(!is_done[i] && squared_distance(p, m_reference.point(m_reference.project(p))) > square(part * limit))
          result.push_back(i);
        is_done[i] = true;
      }
    return result;
  }

  void split(const std::vector<std::size_t>& faces_beyond, const Faces& faces, const Faces& flipped, Vertices& changed) const
  {
    const std::set<face_descriptor> is_flipped(flipped.begin(), flipped.end());
    std::vector<std::size_t> candidates;
    std::map<std::size_t, face_descriptor> descriptor;
    for(std::size_t k = 0; k < faces.size(); ++k)
      if(is_flipped.count(faces[k]) == 0)
      {
        candidates.push_back(faces_beyond[k]);
        descriptor[faces_beyond[k]] = faces[k];
      }
    Faces faces_to_split;
    for(std::size_t f : find_faces_to_split(m_mesh, candidates))
      faces_to_split.push_back(descriptor[f]);
    for(auto v : split_longest_sides(faces_to_split, m_tmesh, m_vpm, m_is_constrained, m_reference))
      changed.push_back(v);
  }

  // some rings of faces: with fewer, the fit has no room; with more, it spoils good faces elsewhere
  Faces faces_around(const Vertices& changed) const
  {
    constexpr int number_of_rings = 3;
    const auto is_found = get(dynamic_face_property_t<bool>(), m_tmesh);
    for(auto f : faces(m_tmesh))
      put(is_found, f, false);
    Faces result;
    const auto add_faces_at = [&](vertex_descriptor v) {
      for(auto h : halfedges_around_target(v, m_tmesh))
        if(!is_border(h, m_tmesh) && !get(is_found, face(h, m_tmesh)))
        {
          put(is_found, face(h, m_tmesh), true);
          result.push_back(face(h, m_tmesh));
        }
    };
    for(auto v : changed)
      add_faces_at(v);
    std::size_t first = 0;
    for(int ring = 1; ring < number_of_rings; ++ring)
      for(const std::size_t end = result.size(); first < end; ++first)
        for(auto v : vertices_around_face(halfedge(result[first], m_tmesh), m_tmesh))
          add_faces_at(v);
    return result;
  }

  const Mesh_arrays& m_mesh;
  const Mesh_descriptors<TriangleMesh>& m_descriptors;
  const Reference& m_reference;
  TriangleMesh& m_tmesh;
  const VertexPointMap& m_vpm;
  const EdgeIsConstrainedMap& m_is_constrained;
  const Self_intersection_test<ConcurrencyTag, TriangleMesh, VertexPointMap> m_find_self_intersections;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_REFINE_SPOTS_H
