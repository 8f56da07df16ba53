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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FLIP_CRITERION_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FLIP_CRITERION_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The smallest angles of the faces of M_0.
class Smallest_angles
{
public:
  explicit Smallest_angles(const Mesh_arrays& mesh) : m_at_vertices(mesh.points.size(), 1)
  {
    for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      for(Index i : mesh.face(f))
        m_at_vertices[i] = (std::min)(m_at_vertices[i], static_cast<float>(squared_sine(mesh.triangle(f))));
  }

  // Whether a face has collapsed, given the squared sines of its smallest angle: to less than 10 degrees, less than half of
  // its initial value, and less than the initial ones of all faces around it.
  bool has_collapsed(const std::array<Index, 3>& face, const double sine2, const double initial_sine2) const
  {
    constexpr double sine_of_collapse = 0.17364817766693036; // of 10 degrees
    if(sine2 >= square(sine_of_collapse))
      return false;
    const double initial_cosine = std::sqrt((std::max)(0., 1 - initial_sine2));
    return sine2 < initial_sine2 / (2 * (1 + initial_cosine)) && // of half the angle
           std::all_of(face.begin(), face.end(), [&](Index i) { return sine2 < m_at_vertices[i]; });
  }

  // the squared sine of the smallest angle, which is between the two longest sides; not a number if these have no length
  static double squared_sine(const std::array<Point, 3>& t)
  {
    const double a = squared_distance(t[0], t[1]), b = squared_distance(t[1], t[2]), c = squared_distance(t[2], t[0]);
    return area_normal(t[0], t[1], t[2]).squared_length() / (std::max)({ a * b, b * c, c * a });
  }

private:
  std::vector<float> m_at_vertices; // the squared sine of the smallest angle of the faces at each vertex
};

// A face violates it if it is flipped: the next points turn its normal by more than 60 degrees from that of the initial
// ones; or if it collapses. A face without an initial area never violates it. A model of the criteria of `shorten_moves()`.
class Flip_criterion
{
public:
  Flip_criterion(const Remesh& remesh, const Smallest_angles& angles) : m_remesh(remesh), m_angles(angles) {}

  bool is_violated_by(std::size_t f) const
  {
    constexpr double cosine_of_flip = 0.5;

    const std::array<Point, 3> before = m_remesh.triangle(f, m_remesh.initial_points),
                               after = m_remesh.triangle(f, m_remesh.next_points);
    const Vector m = area_normal(before[0], before[1], before[2]), n = area_normal(after[0], after[1], after[2]);
    const double area_before = norm(m), area_after = norm(n);
    if(!(area_before > 0))
      return false;
    return !(m * n > cosine_of_flip * area_before * area_after) ||
           m_angles.has_collapsed(m_remesh.face(f), Smallest_angles::squared_sine(after),
                                  Smallest_angles::squared_sine(before));
  }

private:
  const Remesh& m_remesh;
  const Smallest_angles& m_angles;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FLIP_CRITERION_H
