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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_NEW_INTERSECTIONS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_NEW_INTERSECTIONS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_mesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Triangulated_copy.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Finds the pairs of faces of `pmesh` that intersect if the vertices of the remesh, some or all of its vertices, are
// elsewhere. A polygon is there as one of its triangulations, always the same one, whose triangles do not count against each
// other.
template <typename ConcurrencyTag, typename PolygonMesh, typename VertexPointMap>
class Self_intersection_test
{
  using Copy = Triangulated_copy<PolygonMesh>;
  using Test_point = Exact_predicates_inexact_constructions_kernel::Point_3;
  using Vertex_index_map = typename boost::property_map<PolygonMesh, dynamic_vertex_property_t<Index>>::const_type;

public:
  using Triangle = std::array<Index, 4>; // its number, and its vertices in the remesh; no_index: not there
  using Face_pair = std::pair<Triangle, Triangle>;

  // If not `is_enabled`, none are found.
  Self_intersection_test(const PolygonMesh& pmesh,
                         const VertexPointMap& vpm,
                         const Mesh_descriptors<PolygonMesh>& descriptors,
                         const bool is_enabled)
    : m_pmesh(pmesh), m_vpm(vpm), m_is_enabled(is_enabled)
  {
    if(!is_enabled)
      return;
    m_vertex_index = get(dynamic_vertex_property_t<Index>(), pmesh);
    for(auto v : vertices(pmesh))
      put(m_vertex_index, v, no_index);
    for(Index i = 0; i < descriptors.vertices.size(); ++i)
      put(m_vertex_index, descriptors.vertices[i], i);
    if(!is_triangle_mesh(pmesh))
      m_copy = std::make_unique<const Copy>(pmesh, vpm);
  }

  // the pairs, sorted
  std::vector<Face_pair> operator()(const std::vector<Point>& points) const
  {
    if(!m_is_enabled)
      return {};
    if(m_copy)
      return find_pairs(
        m_copy->mesh, points, [&](auto v) { return m_copy->vertices[v]; },
        [&](auto f, auto g) { return m_copy->faces[f] == m_copy->faces[g]; });
    return find_pairs(
      m_pmesh, points, [](auto v) { return v; }, [](const auto& f, const auto& g) { return f == g; });
  }

private:
  // `mesh` is the mesh itself or its copy, whose vertex v is `original(v)`. A degenerate triangle intersects itself.
  template <typename Mesh, typename Original, typename AreInOneFace>
  std::vector<Face_pair> find_pairs(const Mesh& mesh,
                                    const std::vector<Point>& points,
                                    const Original& original,
                                    const AreInOneFace& are_in_one_face) const
  {
    using face_descriptor = typename boost::graph_traits<Mesh>::face_descriptor;
    auto vertex_point = get(dynamic_vertex_property_t<Test_point>(), mesh);
    for(auto v : vertices(mesh))
    {
      const Index i = get(m_vertex_index, original(v));
      put(vertex_point, v, convert<Test_point>(i != no_index ? points[i] : convert<Point>(get(m_vpm, original(v)))));
    }
    std::vector<std::pair<face_descriptor, face_descriptor>> faces_found;
    self_intersections<ConcurrencyTag>(
      mesh, std::back_inserter(faces_found),
      parameters::vertex_point_map(vertex_point).geom_traits(Exact_predicates_inexact_constructions_kernel()));
    if(faces_found.empty())
      return {};

    auto face_index = get(dynamic_face_property_t<Index>(), mesh);
    Index number = 0;
    for(auto f : faces(mesh))
      put(face_index, f, number++);
    const auto describe = [&](const face_descriptor& f) {
      Triangle triangle{ get(face_index, f) };
      std::size_t k = 0;
      for(auto v : vertices_around_face(halfedge(f, mesh), mesh))
        triangle[++k] = get(m_vertex_index, original(v));
      return triangle;
    };
    std::vector<Face_pair> pairs;
    for(const auto& [f, g] : faces_found)
      if(f == g || !are_in_one_face(f, g))
        pairs.push_back(std::minmax({ describe(f), describe(g) }));
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

  const PolygonMesh& m_pmesh;
  const VertexPointMap& m_vpm;
  const bool m_is_enabled;
  Vertex_index_map m_vertex_index;    // in the remesh
  std::unique_ptr<const Copy> m_copy; // if there are polygons
};

// Finds the pairs of faces that intersect with the next points and do not with the initial ones. `FindSelfIntersections` is
// a `Self_intersection_test`.
template <typename FindSelfIntersections>
class New_intersections
{
  using Face_pairs = std::vector<typename FindSelfIntersections::Face_pair>;

public:
  New_intersections(const Remesh& remesh, const FindSelfIntersections& find) : m_remesh(remesh), m_find(find) {}

  // the vertices of these faces, in increasing order
  std::set<Index> find_vertices()
  {
    std::set<Index> vertices;
    for(const auto& pair : find_pairs())
      for(const auto& triangle : { pair.first, pair.second })
        vertices.insert(triangle.begin() + 1, triangle.end());
    vertices.erase(no_index);
    return vertices;
  }

private:
  Face_pairs find_pairs()
  {
    const Face_pairs next = m_find(m_remesh.next_points);
    if(next.empty())
      return {};
    if(!m_knows_initial)
      m_initial = m_find(m_remesh.initial_points);
    m_knows_initial = true;
    Face_pairs result;
    std::set_difference(next.begin(), next.end(), m_initial.begin(), m_initial.end(), std::back_inserter(result));
    return result;
  }

  const Remesh& m_remesh;
  const FindSelfIntersections& m_find;
  bool m_knows_initial = false; // the initial points are tested only where the next ones intersect
  Face_pairs m_initial;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_NEW_INTERSECTIONS_H
