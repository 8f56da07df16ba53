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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_SIGNAL_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_SIGNAL_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/face_lattice.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/sample_faces.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Mesh_arrays.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Polygon_centers.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The samples of a signal, as the faces of a mesh see them.
template <typename Value>
struct Signal_samples
{
  std::vector<Value> at_vertices;
  std::vector<Value> at_corners;          // the same for all faces around a vertex, but at seams
  std::vector<unsigned char> pieces;      // those of face f are the points of the lattice of pieces[f],
  std::vector<std::size_t> first_of_face; // in_faces[first_of_face[f]], ..., in_faces[first_of_face[f + 1] - 1]
  std::vector<Value> in_faces;
  std::vector<char> is_seam; // the edges whose faces have different samples
};

// Calls f(x, value) for each sample in face f and its coordinates.
template <typename Value, typename F>
void for_each_sample(const Signal_samples<Value>& samples, std::size_t face, const F& f)
{
  auto value = samples.in_faces.begin() + samples.first_of_face[face];
  for_each_lattice_point(samples.pieces[face], [&](const Coordinates& x) { f(x, *value++); });
}

// Takes the samples of a signal on a mesh.
template <typename Signal>
class Signal_sampler
{
  using Foot = typename Signal::Foot;
  using Value = typename Signal::Value;

public:
  Signal_sampler(const Mesh_arrays& mesh, const Signal& signal) : m_mesh(mesh), m_signal(signal) {}

  // The seams are those given and, if the signal has any, those where the faces at an edge are on different sides of one.
  template <typename ConcurrencyTag>
  Signal_samples<Value> sample(const std::vector<char>& is_seam)
  {
    Signal_samples<Value> samples;
    find_feet<ConcurrencyTag>();
    samples.at_vertices.resize(m_mesh.points.size());
    for_each_index<ConcurrencyTag>(m_mesh.points.size(),
                                   [&](std::size_t i) { samples.at_vertices[i] = m_signal.at(m_vertex_feet[i]); });

    allocate(samples);
    for_each_index<ConcurrencyTag>(m_mesh.number_of_faces(), [&](std::size_t f) { sample_face(f, samples); });

    samples.is_seam = is_seam;
    if(m_signal.has_seams())
      for_each_index<ConcurrencyTag>(m_mesh.edges.size(), [&](std::size_t e) {
        if(!is_seam[e] && !m_mesh.is_border(e) && !m_mesh.is_diagonal(e) && is_between_sides(e))
          samples.is_seam[e] = 1;
      });
    return samples;
  }

private:
  // the feet of the vertices and of the centers
  template <typename ConcurrencyTag>
  void find_feet()
  {
    m_vertex_feet = project_vertices<ConcurrencyTag>(m_mesh.points, m_signal.reference());
    const Polygon_centers center(m_mesh);
    m_anchors.resize(m_mesh.number_of_faces());
    for_each_index<ConcurrencyTag>(m_anchors.size(), [&](std::size_t f) {
      m_anchors[f] = m_signal.reference().project(center(f), m_vertex_feet[m_mesh.first_vertex(f)]);
    });
  }

  // At least half as many samples as the reference has faces, so that details finer than the faces of the mesh are averaged.
  std::size_t pieces_of(std::size_t f) const
  {
    double area = m_signal.reference().area_at(m_anchors[f]);
    for(Index i : m_mesh.face(f))
      area += m_signal.reference().area_at(m_vertex_feet[i]);
    const double faces_of_reference = area > 0 ? m_mesh.triangle_area(f) / (area / 4) : 1;
    return number_of_pieces(std::isfinite(faces_of_reference) ? faces_of_reference / 2 : 1);
  }

  void allocate(Signal_samples<Value>& samples) const
  {
    const std::size_t n = m_mesh.number_of_faces();
    samples.at_corners.resize(3 * n);
    samples.pieces.resize(n);
    samples.first_of_face.assign(n + 1, 0);
    for(std::size_t f = 0; f < n; ++f)
    {
      const std::size_t pieces = pieces_of(f);
      samples.pieces[f] = static_cast<unsigned char>(pieces);
      samples.first_of_face[f + 1] = samples.first_of_face[f] + number_of_lattice_points(pieces);
    }
    samples.in_faces.resize(samples.first_of_face[n]);
  }

  auto make_face_sampler(std::size_t f) const
  {
    constexpr double far = 0.05; // relative to the edge length
    return m_signal.make_face_sampler(f, m_anchors[f], far * std::sqrt(2 * m_mesh.triangle_area(f)));
  }

  void sample_face(std::size_t f, Signal_samples<Value>& samples)
  {
    const std::array<Point, 3> t = m_mesh.triangle(f);
    auto sampler = make_face_sampler(f);
    auto value = samples.in_faces.begin() + samples.first_of_face[f];
    for_each_lattice_point(samples.pieces[f],
                           [&](const Coordinates& x) { *value++ = m_signal.sample(sampler, point_at(t, x)); });
    const std::array<Index, 3> vertices = m_mesh.face(f);
    for(int k = 0; k < 3; ++k)
      samples.at_corners[3 * f + k] =
        m_signal.is_split_at(vertices[k]) ? m_signal.sample(sampler, t[k]) : samples.at_vertices[vertices[k]];
  }

  // whether the faces at an edge are on different sides of a seam of the signal, at its midpoint
  bool is_between_sides(std::size_t e) const
  {
    const std::array<Index, 2>& corners = m_mesh.edge_corners[e];
    return m_signal.is_between_sides(m_mesh.midpoint(e), make_face_sampler(corners[0] / 3),
                                     make_face_sampler(corners[1] / 3));
  }

  const Mesh_arrays& m_mesh;
  const Signal& m_signal;
  std::vector<Foot> m_vertex_feet;
  std::vector<Foot> m_anchors; // the feet of the centers of the polygons
};

template <typename ConcurrencyTag, typename Signal>
Signal_samples<typename Signal::Value>
sample_signal(const Mesh_arrays& mesh, const Signal& signal, const std::vector<char>& is_seam)
{
  return Signal_sampler<Signal>(mesh, signal).template sample<ConcurrencyTag>(is_seam);
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_SIGNAL_H
