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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACE_READER_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACE_READER_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Fans.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Mesh_arrays.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The descriptors behind the elements of a `Mesh_arrays`.
template <typename PolygonMesh>
struct Mesh_descriptors
{
  using Graph_traits = boost::graph_traits<PolygonMesh>;

  std::vector<typename Graph_traits::vertex_descriptor> vertices;
  std::vector<typename Graph_traits::edge_descriptor> edges;         // a diagonal has none
  std::vector<typename Graph_traits::halfedge_descriptor> halfedges; // to the first vertex of each face
};

// The halfedges to the corners of face f of the arrays, in its face of the mesh.
template <typename PolygonMesh>
std::array<typename boost::graph_traits<PolygonMesh>::halfedge_descriptor, 3> corner_halfedges(
  const PolygonMesh& pmesh, const Mesh_arrays& mesh, const Mesh_descriptors<PolygonMesh>& descriptors, const std::size_t f)
{
  auto h = descriptors.halfedges[f];
  std::array<decltype(h), 3> halfedges{ { h, h, h } };
  for(int k = 1; k < 3; ++k)
  {
    do
      h = next(h, pmesh);
    while(target(h, pmesh) != descriptors.vertices[mesh.face(f)[k]]);
    halfedges[k] = h;
  }
  return halfedges;
}

// Copies the edges and faces of a mesh whose vertices have been copied, in the order of their first vertices, the smallest
// ones; what begins with the same vertex stays in the order of the mesh. A polygon is read from its smallest vertex on, so
// that the choice of its halfedge in the mesh does not matter.
template <typename PolygonMesh, typename Selection, typename VertexIndexMap>
class Face_reader
{
  using Graph_traits = boost::graph_traits<PolygonMesh>;
  using edge_descriptor = typename Graph_traits::edge_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using Edge_index_map = typename boost::property_map<PolygonMesh, dynamic_edge_property_t<Index>>::const_type;

public:
  Face_reader(const PolygonMesh& pmesh,
              const Selection& selection,
              const VertexIndexMap& vertex_index,
              Mesh_arrays& mesh,
              Mesh_descriptors<PolygonMesh>& descriptors)
    : m_pmesh(pmesh), m_selection(selection), m_vertex_index(vertex_index),
      m_edge_index(get(dynamic_edge_property_t<Index>(), pmesh)), m_mesh(mesh), m_descriptors(descriptors)
  {}

  // returns whether the indices suffice
  bool read()
  {
    if(!allocate())
      return false;
    for(edge_descriptor e : edges(m_pmesh))
      if(m_selection.has_edge(e))
        put(m_edge_index, e, add_edge(vertex(source(e, m_pmesh)), vertex(target(e, m_pmesh)), e));
    Index number = 0;
    for_each_face([&](halfedge_descriptor first) { read_triangle(first, number++); }, [&]() { read_polygon(number++); });
    for(Index c = 0; c < 3 * m_mesh.number_of_faces(); ++c)
      add_edge_corner(c);
    return true;
  }

private:
  template <typename Vertex>
  Index vertex(const Vertex& v) const
  {
    return get(m_vertex_index, v);
  }

  Index edge_index(const halfedge_descriptor& h) const { return get(m_edge_index, edge(h, m_pmesh)); }

  // Calls on_triangle(h) for each triangle, h pointing to its first vertex, and on_polygon() for each other face, whose
  // corners are set then.
  template <typename OnTriangle, typename OnPolygon>
  void for_each_face(const OnTriangle& on_triangle, const OnPolygon& on_polygon)
  {
    for(auto face : faces(m_pmesh))
    {
      if(!m_selection.has_face(face))
        continue;
      const halfedge_descriptor first = halfedge_to_first_vertex(face);
      if(is_triangle(first, m_pmesh))
        on_triangle(first);
      else
      {
        set_corners(first);
        on_polygon();
      }
    }
  }

  template <typename Face>
  halfedge_descriptor halfedge_to_first_vertex(const Face& face) const
  {
    const halfedge_descriptor begin = halfedge(face, m_pmesh);
    halfedge_descriptor first = begin;
    for(halfedge_descriptor h = next(begin, m_pmesh); h != begin; h = next(h, m_pmesh))
      if(vertex(target(h, m_pmesh)) < vertex(target(first, m_pmesh)))
        first = h;
    return first;
  }

  void set_corners(const halfedge_descriptor& first)
  {
    m_corners.clear();
    m_vertices.clear();
    for(halfedge_descriptor h : halfedges_around_face(first, m_pmesh))
    {
      m_corners.push_back(h);
      m_vertices.push_back(vertex(target(h, m_pmesh)));
    }
  }

  const Fans& fans() { return m_fans(static_cast<Index>(m_corners.size())); }

  // the corner of a triangle with its first vertex
  int first_corner(const Fan_triangle& t) const
  {
    const auto is_less = [&](Index a, Index b) { return m_vertices[a] < m_vertices[b]; };
    return static_cast<int>(std::min_element(t.corners.begin(), t.corners.end(), is_less) - t.corners.begin());
  }

  // Counts, and makes room; returns whether the indices suffice.
  bool allocate()
  {
    std::vector<std::size_t> edges_at(m_mesh.points.size() + 1, 0), faces_at(m_mesh.points.size() + 1, 0);
    for(edge_descriptor e : edges(m_pmesh))
      if(m_selection.has_edge(e))
        ++edges_at[1 + (std::min)(vertex(source(e, m_pmesh)), vertex(target(e, m_pmesh)))];
    bool has_polygons = false;
    const auto count_triangle = [&](halfedge_descriptor first) { ++faces_at[1 + vertex(target(first, m_pmesh))]; };
    for_each_face(count_triangle, [&]() {
      has_polygons = true;
      for(const std::array<Index, 2>& ends : fans().diagonals)
        ++edges_at[1 + (std::min)(m_vertices[ends[0]], m_vertices[ends[1]])];
      for(const Fan_triangle& t : fans().triangles)
        ++faces_at[1 + m_vertices[t.corners[first_corner(t)]]];
    });
    std::partial_sum(edges_at.begin(), edges_at.end(), edges_at.begin());
    std::partial_sum(faces_at.begin(), faces_at.end(), faces_at.begin());
    const std::size_t number_of_edges = edges_at.back(), number_of_faces = faces_at.back();
    if(number_of_edges >= no_index || number_of_faces >= no_index / 3)
      return false;

    m_next_edge.assign(edges_at.begin(), edges_at.end());
    m_next_face.assign(faces_at.begin(), faces_at.end());
    m_mesh.edges.resize(number_of_edges);
    m_mesh.edge_corners.resize(number_of_edges, { no_index, no_index });
    m_descriptors.edges.resize(number_of_edges);
    m_mesh.faces.resize(number_of_faces);
    m_mesh.face_edges.resize(number_of_faces);
    m_descriptors.halfedges.resize(number_of_faces);
    if(has_polygons)
    {
      m_mesh.diagonals.resize(number_of_edges, 0);
      m_mesh.weights.resize(number_of_faces);
      m_mesh.polygons.resize(number_of_faces);
      m_mesh.ears.resize(3 * number_of_faces);
    }
    return true;
  }

  Index add_edge(const Index i, const Index j, const edge_descriptor& e)
  {
    const Index index = m_next_edge[(std::min)(i, j)]++;
    m_mesh.edges[index] = { (std::min)(i, j), (std::max)(i, j) };
    m_descriptors.edges[index] = e;
    return index;
  }

  void read_triangle(const halfedge_descriptor& first, const Index number)
  {
    const halfedge_descriptor second = next(first, m_pmesh), third = next(second, m_pmesh);
    const Index i = vertex(target(first, m_pmesh)), f = m_next_face[i]++;
    m_descriptors.halfedges[f] = first;
    m_mesh.faces[f] = { i, vertex(target(second, m_pmesh)), vertex(target(third, m_pmesh)) };
    m_mesh.face_edges[f] = { edge_index(third), edge_index(first), edge_index(second) };
    if(m_mesh.has_polygons())
    {
      m_mesh.weights[f] = 1;
      m_mesh.polygons[f] = number;
      for(Index c = 3 * f; c < 3 * f + 3; ++c)
        m_mesh.ears[c] = c;
    }
  }

  void read_polygon(const Index number)
  {
    const std::size_t n = m_corners.size();
    m_sides.clear();
    for(std::size_t i = 0; i < n; ++i)
      m_sides.push_back(edge_index(m_corners[(i + 1) % n]));
    for(const std::array<Index, 2>& ends : fans().diagonals)
    {
      m_sides.push_back(add_edge(m_vertices[ends[0]], m_vertices[ends[1]], edge_descriptor()));
      m_mesh.diagonals[m_sides.back()] = 1;
    }

    m_corners_of_triangles.clear();
    for(const Fan_triangle& t : fans().triangles)
    {
      const int first = first_corner(t);
      const Index f = m_next_face[m_vertices[t.corners[first]]]++;
      m_descriptors.halfedges[f] = m_corners[t.corners[first]];
      std::array<Index, 3> corners;
      for(int k = 0; k < 3; ++k)
      {
        const int c = (first + k) % 3;
        m_mesh.faces[f][k] = m_vertices[t.corners[c]];
        m_mesh.face_edges[f][k] = m_sides[t.sides[c]];
        corners[c] = 3 * f + k;
      }
      m_corners_of_triangles.push_back(corners);
    }
    describe_polygon(number);
  }

  void describe_polygon(const Index number)
  {
    const std::vector<Fan_triangle>& triangles = fans().triangles;
    const std::size_t n = m_corners.size();
    for(std::size_t i = 0; i < triangles.size(); ++i)
    {
      const Index f = m_corners_of_triangles[i][0] / 3;
      m_mesh.weights[f] = triangles[i].weight;
      m_mesh.polygons[f] = number;
      for(int k = 0; k < 3; ++k)
      {
        const Index corner = m_corners_of_triangles[i][k];
        m_mesh.ears[corner] = m_corners_of_triangles[(triangles[i].corners[k] + n - 1) % n][1];
      }
    }
  }

  // Each side of an edge refers to the first corner opposite to it; for a diagonal, any two triangles will do.
  void add_edge_corner(const Index corner)
  {
    const Index e = m_mesh.opposite_edge(corner);
    auto& [here, across] = m_mesh.edge_corners[e];
    if(here == no_index)
      here = corner;
    else if(!m_mesh.has_polygons() || m_mesh.is_diagonal(e) || m_mesh.polygons[here / 3] != m_mesh.polygons[corner / 3])
      across = across == no_index || !m_mesh.has_polygons() ? corner : across;
  }

  const PolygonMesh& m_pmesh;
  const Selection& m_selection;
  const VertexIndexMap& m_vertex_index;
  Edge_index_map m_edge_index;
  Mesh_arrays& m_mesh;
  Mesh_descriptors<PolygonMesh>& m_descriptors;
  Fans_by_degree m_fans;
  std::vector<Index> m_next_edge, m_next_face; // the next one that begins with each vertex

  // of the current polygon
  std::vector<halfedge_descriptor> m_corners; // to them
  std::vector<Index> m_vertices;
  std::vector<Index> m_sides;                               // the edges, as those of `Fan_triangle`
  std::vector<std::array<Index, 3>> m_corners_of_triangles; // of the faces
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACE_READER_H
