// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_NORMALS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_NORMALS_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/corner_normals.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The normals of a reference, as the faces of a mesh see them.
struct Normal_samples
{
  std::vector<Vector> at_vertices;
  std::vector<Vector> at_corners;   // n_i; the same for all faces around a vertex that is on no crease
  std::vector<Vector> at_midpoints; // n_ij, at the edge opposite to a corner
};

// Takes the normals of a reference at the vertices and at the midpoints of the edges of a mesh. At a crease the reference
// has two normals: each face takes that of its own side.
template <typename Reference>
class Normal_sampler
{
  using Foot = typename Reference::Foot;

public:
  Normal_sampler(const Mesh_arrays& mesh, const Reference& reference, const std::vector<char>& is_crease)
    : m_mesh(mesh), m_reference(reference), m_is_crease(is_crease), m_sectors(mesh, is_crease),
      m_on_crease(mesh.points.size(), 0)
  {
    for(std::size_t e = 0; e < mesh.edges.size(); ++e)
      if(is_crease[e])
        for(Index i : mesh.edges[e])
          m_on_crease[i] = 1;
  }

  template <typename ConcurrencyTag>
  Normal_samples sample()
  {
    m_face_normals = compute_face_normals<ConcurrencyTag>(m_mesh);

    Normal_samples samples;
    samples.at_vertices.resize(m_mesh.points.size());
    std::vector<Foot> feet(m_mesh.points.size());
    for_each_index<ConcurrencyTag>(m_mesh.points.size(), [&](std::size_t i) {
      feet[i] = m_reference.project(m_mesh.points[i]);
      samples.at_vertices[i] = normal(feet[i]);
    });

    std::vector<Vector> at_edges(m_mesh.edges.size());
    for_each_index<ConcurrencyTag>(m_mesh.edges.size(), [&](std::size_t e) {
      if(!m_is_crease[e])
        at_edges[e] = normal_at(m_mesh.midpoint(e), feet[m_mesh.edges[e][0]]);
    });

    samples.at_corners.resize(3 * m_mesh.number_of_faces());
    samples.at_midpoints.resize(3 * m_mesh.number_of_faces());
    for_each_index<ConcurrencyTag>(samples.at_corners.size(), [&](std::size_t c) {
      const Index corner = static_cast<Index>(c), i = m_mesh.vertex(corner), e = m_mesh.opposite_edge(corner);
      samples.at_corners[c] = m_on_crease[i]
                                ? normal_on_side(c / 3, m_mesh.points[i], feet[i], normals_beyond_sector(corner))
                                : samples.at_vertices[i];
      samples.at_midpoints[c] =
        m_is_crease[e] ? normal_on_side(c / 3, m_mesh.midpoint(e), feet[m_mesh.edges[e][0]], { normal_beyond(c / 3, e) })
                       : at_edges[e];
    });
    return samples;
  }

private:
  Vector normal(const Foot& foot) const { return normalized(m_reference.normal(foot)); }

  Vector normal_at(const Point& p, const Foot& hint) const { return normal(m_reference.project(p, hint)); }

  // The normal near `p`, a point of the face f on a crease, on the side of the face: as near as the reference has a normal
  // that is closer to that of the face than to those beyond the crease.
  Vector normal_on_side(std::size_t f, const Point& p, const Foot& hint, const std::vector<Vector>& beyond) const
  {
    auto is_on_side = [&](const Vector& n) {
      return n != NULL_VECTOR && std::none_of(beyond.begin(), beyond.end(),
                                              [&](const Vector& other) { return n * m_face_normals[f] < n * other; });
    };

    const Vector at_p = normal_at(p, hint);
    if(is_on_side(at_p))
      return at_p;
    const Vector to_inside = m_mesh.barycenter(f) - p;
    for(const double step : { 1 / 16., 1 / 8., 1 / 4., 1 / 2., 1. })
    {
      const Vector n = normal_at(p + step * to_inside, hint);
      if(is_on_side(n))
        return n;
    }
    return at_p;
  }

  // the normal of the face across the edge e of the face f
  Vector normal_beyond(std::size_t f, Index e) const
  {
    if(m_mesh.is_border(e))
      return NULL_VECTOR;
    const std::array<Index, 2>& corners = m_mesh.edge_corners[e];
    return m_face_normals[corners[0] / 3 == f ? corners[1] / 3 : corners[0] / 3];
  }

  // the normals of the faces across the creases that end the sector of `corner`
  std::vector<Vector> normals_beyond_sector(Index corner) const
  {
    std::vector<Vector> normals;
    m_sectors.for_each_corner(corner, [&](Index c) {
      for(Index e : { m_mesh.opposite_edge(Mesh_arrays::next(c)), m_mesh.opposite_edge(Mesh_arrays::previous(c)) })
        if(m_is_crease[e])
          normals.push_back(normal_beyond(c / 3, e));
    });
    return normals;
  }

  const Mesh_arrays& m_mesh;
  const Reference& m_reference;
  const std::vector<char>& m_is_crease;
  const Sectors m_sectors;
  std::vector<char> m_on_crease;
  std::vector<Vector> m_face_normals;
};

template <typename ConcurrencyTag, typename Reference>
Normal_samples sample_normals(const Mesh_arrays& mesh, const Reference& reference, const std::vector<char>& is_crease)
{
  return Normal_sampler<Reference>(mesh, reference, is_crease).template sample<ConcurrencyTag>();
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_NORMALS_H
