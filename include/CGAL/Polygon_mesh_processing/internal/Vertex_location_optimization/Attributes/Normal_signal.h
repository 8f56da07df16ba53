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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_NORMAL_SIGNAL_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_NORMAL_SIGNAL_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/Attribute_value.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/project_near_or_far.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/corner_normals.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

inline Vector to_vector(const Signal_value<3>& x) { return Vector(x[0], x[1], x[2]); }
inline Signal_value<3> to_signal_value(const Vector& v) { return { { v.x(), v.y(), v.z() } }; }

// The direction of `n` unless it turns away from the sample `otherwise`, which it replaces; never without a length.
inline Vector unit_normal_or(const Vector& n, const Vector& otherwise)
{
  if(n * otherwise > 0 && normalized(n) != NULL_VECTOR)
    return normalized(n);
  return otherwise != NULL_VECTOR ? otherwise : Vector(0, 0, 1);
}

// The normals of a reference surface as a signal. At a crease of the remesh the reference has two normals: each face takes
// that of its own side.
template <typename ReferenceAccess>
class Normal_signal
{
public:
  using Reference = ReferenceAccess;
  using Value = Signal_value<3>;
  using Foot = typename Reference::Foot;

  // how a face of the remesh takes samples
  struct Face_sampler
  {
    std::size_t face;
    Foot last;  // that of the last sample
    double far; // a foot that walking finds farther away than this is searched in all of the surface
    boost::container::small_vector<Vector, 4> beyond; // the normals of the faces across the creases around it
  };

  Normal_signal(const Mesh_arrays& mesh, const Reference& reference, const std::vector<char>& is_crease)
    : m_mesh(mesh), m_reference(reference), m_is_crease(is_crease), m_sectors(mesh, is_crease),
      m_face_normals(compute_polygon_normals<Sequential_tag>(mesh)), m_is_on_crease(mesh.points.size(), 0)
  {
    for(std::size_t e = 0; e < mesh.edges.size(); ++e)
      if(is_crease[e])
        for(Index i : mesh.edges[e])
          m_is_on_crease[i] = 1;
  }

  const Reference& reference() const { return m_reference; }

  // the creases of the remesh are its seams, and the reference has no others
  static constexpr bool has_seams() { return false; }
  bool is_between_sides(const Point&, const Face_sampler&, const Face_sampler&) const { return false; }

  Value at(const Foot& foot) const { return to_signal_value(normalized(m_reference.normal(foot))); }

  // whether the faces around a vertex may have different samples there
  bool is_split_at(Index vertex) const { return m_is_on_crease[vertex] != 0; }

  Face_sampler make_face_sampler(std::size_t f, const Foot& anchor, double far) const
  {
    Face_sampler face{ f, anchor, far, {} };
    for(Index k = 0; k < 3; ++k)
      if(const Index corner = static_cast<Index>(3 * f + k); m_is_on_crease[m_mesh.vertex(corner)])
        m_sectors.for_each_corner(corner, [&](Index c) { add_normals_beyond(c, face.beyond); });
    return face;
  }

  // The normal near the point p of a face, on the side of the face: as near as the reference has a normal that is closer to
  // that of the face than to those beyond the creases.
  Value sample(Face_sampler& face, const Point& p) const
  {
    const Vector at_p = normal_at(face, p);
    if(is_on_side(face, at_p))
      return to_signal_value(at_p);
    const Vector to_inside = m_mesh.barycenter(face.face) - p;
    for(const double step : { 1 / 16., 1 / 8., 1 / 4., 1 / 2., 1. })
    {
      const Vector n = normal_at(face, p + step * to_inside);
      if(is_on_side(face, n))
        return to_signal_value(n);
    }
    return to_signal_value(at_p);
  }

private:
  Vector normal_at(Face_sampler& face, const Point& p) const
  {
    face.last = project_near_or_far(m_reference, p, face.last, face.far);
    return normalized(m_reference.normal(face.last));
  }

  bool is_on_side(const Face_sampler& face, const Vector& n) const
  {
    if(face.beyond.empty())
      return true;
    const double cosine = n * m_face_normals[face.face];
    return n != NULL_VECTOR &&
           std::none_of(face.beyond.begin(), face.beyond.end(), [&](const Vector& other) { return cosine < n * other; });
  }

  // appends the normals of the faces across the creases at the corner c
  template <typename Normals>
  void add_normals_beyond(Index c, Normals& normals) const
  {
    for(Index opposite : { Mesh_arrays::next(c), Mesh_arrays::previous(c) })
      if(m_is_crease[m_mesh.opposite_edge(opposite)])
        if(const Index across = m_mesh.corner_across(opposite); across != no_index)
          normals.push_back(m_face_normals[across / 3]);
  }

  const Mesh_arrays& m_mesh;
  const Reference& m_reference;
  const std::vector<char>& m_is_crease;
  const Sectors m_sectors;
  const std::vector<Vector> m_face_normals;
  std::vector<char> m_is_on_crease;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_NORMAL_SIGNAL_H
