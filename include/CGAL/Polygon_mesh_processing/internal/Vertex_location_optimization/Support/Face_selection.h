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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACE_SELECTION_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACE_SELECTION_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Which elements of a mesh are read: all of them. An edge or vertex is read if it has a face that is.
struct All_faces
{
  static constexpr bool is_whole_mesh = true;

  template <typename Element>
  static constexpr bool has_face(const Element&)
  {
    return true;
  }
  template <typename Element>
  static constexpr bool has_edge(const Element&)
  {
    return true;
  }
  template <typename Element>
  static constexpr bool has_vertex(const Element&)
  {
    return true;
  }
  template <typename Element>
  static constexpr bool has_all_faces_at(const Element&)
  {
    return true;
  }
};

// The faces of a range; it does not matter in which order or how often they are there.
template <typename PolygonMesh>
class Face_selection
{
  using Graph_traits = boost::graph_traits<PolygonMesh>;
  using Face_map = typename boost::property_map<PolygonMesh, dynamic_face_property_t<char>>::const_type;
  using Vertex_map = typename boost::property_map<PolygonMesh, dynamic_vertex_property_t<char>>::const_type;

public:
  static constexpr bool is_whole_mesh = false;

  template <typename FaceRange>
  Face_selection(const FaceRange& range, const PolygonMesh& pmesh)
    : m_pmesh(pmesh), m_is_face(get(dynamic_face_property_t<char>(), pmesh)),
      m_is_vertex(get(dynamic_vertex_property_t<char>(), pmesh))
  {
    for(auto f : faces(pmesh))
      put(m_is_face, f, 0);
    for(auto v : vertices(pmesh))
      put(m_is_vertex, v, 0);
    for(auto f : range)
    {
      put(m_is_face, f, 1);
      for(auto v : vertices_around_face(halfedge(f, pmesh), pmesh))
        put(m_is_vertex, v, 1);
    }
  }

  bool has_face(const typename Graph_traits::face_descriptor& f) const
  {
    return f != Graph_traits::null_face() && get(m_is_face, f);
  }

  bool has_edge(const typename Graph_traits::edge_descriptor& e) const
  {
    const auto h = halfedge(e, m_pmesh);
    return has_face(face(h, m_pmesh)) || has_face(face(opposite(h, m_pmesh), m_pmesh));
  }

  bool has_vertex(const typename Graph_traits::vertex_descriptor& v) const { return get(m_is_vertex, v); }

  // of a vertex that the selection has
  bool has_all_faces_at(const typename Graph_traits::vertex_descriptor& v) const
  {
    const auto around = halfedges_around_target(halfedge(v, m_pmesh), m_pmesh);
    return std::all_of(around.begin(), around.end(), [&](const auto& h) {
      const auto f = face(h, m_pmesh);
      return f == Graph_traits::null_face() || has_face(f);
    });
  }

private:
  const PolygonMesh& m_pmesh;
  Face_map m_is_face;
  Vertex_map m_is_vertex;
};

// The faces that a selection does not have. Vertices and edges without such faces may be there, too.
template <typename Selection>
struct Other_faces : All_faces
{
  explicit Other_faces(const Selection& s) : selection(s) {}

  template <typename Face>
  bool has_face(const Face& f) const
  {
    return !selection.has_face(f);
  }

  const Selection& selection;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACE_SELECTION_H
