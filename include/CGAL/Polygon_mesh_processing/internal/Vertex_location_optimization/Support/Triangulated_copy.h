// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_TRIANGULATED_COPY_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_TRIANGULATED_COPY_H

#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
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
    triangulate_faces(mesh, parameters::visitor(Visitor(faces)));
    cut_off_triangles();
  }

private:
  // keeps track of the faces
  struct Visitor : Triangulate_faces::Default_visitor<Mesh>
  {
    explicit Visitor(std::vector<typename Graph_traits::face_descriptor>& f) : faces(&f) {}

    void before_subface_creations(Mesh::Face_index f) { current = (*faces)[f]; }
    void after_subface_creations() {}
    void after_subface_created(Mesh::Face_index f)
    {
      faces->resize((std::max)(faces->size(), static_cast<std::size_t>(f) + 1));
      (*faces)[f] = current;
    }

    std::vector<typename Graph_traits::face_descriptor>* faces;
    typename Graph_traits::face_descriptor current{};
  };

  // Where two triangulations are equally good the first corner decides: it is not that of the mesh.
  void begin_at_smallest_vertices()
  {
    for(const Mesh::Face_index f : mesh.faces())
    {
      const auto around = halfedges_around_face(mesh.halfedge(f), mesh);
      mesh.set_halfedge(
        f, *std::min_element(around.begin(), around.end(), [&](auto g, auto h) { return mesh.target(g) < mesh.target(h); }));
    }
  }

  // Makes triangles of what has no plane to be triangulated in, one after the other.
  void cut_off_triangles()
  {
    Visitor visitor(faces);
    const std::vector<Mesh::Face_index> all(mesh.faces().begin(), mesh.faces().end());
    for(const Mesh::Face_index f : all)
    {
      visitor.before_subface_creations(f);
      const Mesh::Halfedge_index h = mesh.halfedge(f);
      while(!is_triangle(h, mesh))
      {
        const Mesh::Halfedge_index diagonal = Euler::split_face(h, mesh.next(mesh.next(h)), mesh);
        visitor.after_subface_created(mesh.face(mesh.opposite(diagonal)));
        visitor.after_subface_created(mesh.face(diagonal));
      }
    }
  }
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_TRIANGULATED_COPY_H
