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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_TRIANGULATED_COPY_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_TRIANGULATED_COPY_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/find_diagonals.h>

#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// A copy of a polygon mesh in double precision, each face of which is triangulated, by one of its triangulations.
template <typename PolygonMesh>
struct Triangulated_copy
{
  using Graph_traits = boost::graph_traits<PolygonMesh>;
  using Mesh = Surface_mesh<Exact_predicates_inexact_constructions_kernel::Point_3>;

  Mesh mesh;
  std::vector<typename Graph_traits::vertex_descriptor> vertices; // that each vertex is the copy of
  std::vector<typename Graph_traits::face_descriptor> faces;      // that each triangle is a part of

  template <typename VertexPointMap>
  Triangulated_copy(const PolygonMesh& pmesh, const VertexPointMap& vpm)
  {
    std::vector<std::pair<typename Graph_traits::vertex_descriptor, Mesh::Vertex_index>> vertex_pairs;
    std::vector<std::pair<typename Graph_traits::face_descriptor, Mesh::Face_index>> face_pairs;
    copy_face_graph(pmesh, mesh,
                    parameters::vertex_point_map(vpm)
                      .vertex_to_vertex_output_iterator(std::back_inserter(vertex_pairs))
                      .face_to_face_output_iterator(std::back_inserter(face_pairs)));
    vertices.resize(vertex_pairs.size());
    for(const auto& [v, copy] : vertex_pairs)
      vertices[copy] = v;
    faces.resize(face_pairs.size());
    for(const auto& [f, copy] : face_pairs)
      faces[copy] = f;

    begin_at_smallest_vertices();
    const std::vector<Mesh::Face_index> polygons(mesh.faces().begin(), mesh.faces().end());
    for(const Mesh::Face_index f : polygons)
      if(!is_triangle(mesh.halfedge(f), mesh))
        triangulate(f);
  }

private:
  // Where two triangulations are equally good, the first corner decides, which is not that of the mesh.
  void begin_at_smallest_vertices()
  {
    for(const Mesh::Face_index f : mesh.faces())
    {
      const auto around = halfedges_around_face(mesh.halfedge(f), mesh);
      mesh.set_halfedge(
        f, *std::min_element(around.begin(), around.end(), [&](auto g, auto h) { return mesh.target(g) < mesh.target(h); }));
    }
  }

  void triangulate(const Mesh::Face_index f)
  {
    const auto around = halfedges_around_face(mesh.halfedge(f), mesh);
    const std::vector<Mesh::Halfedge_index> corners(around.begin(), around.end());
    std::vector<Point> points;
    for(const Mesh::Halfedge_index h : corners)
    {
      const auto& p = mesh.point(mesh.target(h));
      points.emplace_back(p.x(), p.y(), p.z());
    }
    std::vector<Mesh::Face_index> pieces{ f };
    for(const Diagonal& diagonal : find_diagonals(points))
      split(mesh.target(corners[diagonal[0]]), mesh.target(corners[diagonal[1]]), pieces);
    // polygons without a plane
    for(std::size_t i = 0; i < pieces.size(); ++i)
      while(!is_triangle(mesh.halfedge(pieces[i]), mesh))
      {
        const Mesh::Halfedge_index h = mesh.halfedge(pieces[i]);
        split(mesh.target(h), mesh.target(mesh.next(mesh.next(h))), pieces);
      }
    const auto original = faces[f];
    for(const Mesh::Face_index piece : pieces)
    {
      faces.resize((std::max)(faces.size(), static_cast<std::size_t>(piece) + 1));
      faces[piece] = original;
    }
  }

  // Splits the piece of a polygon that has these two vertices.
  void split(const Mesh::Vertex_index v, const Mesh::Vertex_index w, std::vector<Mesh::Face_index>& pieces)
  {
    for(const Mesh::Face_index piece : pieces)
    {
      const auto around = halfedges_around_face(mesh.halfedge(piece), mesh);
      const auto to = [&](const Mesh::Vertex_index end) {
        return std::find_if(around.begin(), around.end(), [&](const auto h) { return mesh.target(h) == end; });
      };
      const auto to_v = to(v), to_w = to(w);
      if(to_v == around.end() || to_w == around.end())
        continue;
      const Mesh::Halfedge_index diagonal = Euler::split_face(*to_v, *to_w, mesh);
      const Mesh::Face_index other = mesh.face(diagonal) == piece ? mesh.face(mesh.opposite(diagonal)) : mesh.face(diagonal);
      pieces.push_back(other);
      return;
    }
  }
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_TRIANGULATED_COPY_H
