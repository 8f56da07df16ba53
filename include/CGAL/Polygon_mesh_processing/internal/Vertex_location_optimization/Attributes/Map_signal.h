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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MAP_SIGNAL_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MAP_SIGNAL_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/Attribute_value.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/project_near_or_far.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Reference_patches.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The signal that values at the corners of the faces make on `Reference_patches`, linear over each face. Where they differ
// between the sides of an edge the edge is a seam, which no sample crosses: a face of the remesh takes all its samples on
// the side of its barycenter, those beyond a seam at the closest point of that side.
template <typename ReferencePatches, std::size_t N>
class Map_signal
{
public:
  using Reference = ReferencePatches;
  using Value = Signal_value<N>;
  using Foot = typename Reference::Foot;
  using Corner_values = std::array<Value, 3>;

  // how a face of the remesh takes samples
  struct Face_sampler
  {
    Foot anchor; // the foot of its barycenter
    Foot last;   // that of the last sample
    double far;  // a foot that walking finds farther away than this is searched in all of the surface
  };

  Map_signal(const Reference& reference, std::vector<Corner_values> values)
    : m_reference(reference), m_values(std::move(values)), m_range(range()), m_seams(m_values.size(), 0)
  {
    for(Index patch = 0; patch < m_values.size(); ++patch)
      for(Index k = 0; k < 3; ++k)
        if(is_seam(patch, k))
        {
          m_seams[patch] |= static_cast<unsigned char>(1u << k);
          m_has_seams = true;
        }
  }

  const Reference& reference() const { return m_reference; }

  bool has_seams() const { return m_has_seams; }

  // whether the faces around a vertex may have different samples there
  bool is_split_at(Index /* vertex */) const { return m_has_seams; }

  Value at(const Foot& foot) const
  {
    const Corner_values& v = m_values[foot.patch];
    return interpolate(v[0], v[1], v[2], foot.coordinates.u, foot.coordinates.v);
  }

  Face_sampler make_face_sampler(std::size_t /* f */, const Foot& anchor, double far) const
  {
    return { anchor, anchor, far };
  }

  // the signal at the point p of a face
  Value sample(Face_sampler& face, const Point& p) const
  {
    if(!m_has_seams)
    {
      face.last = project_near_or_far(m_reference, p, face.last, face.far);
      return at(face.last);
    }
    const auto can_cross = [&](Index patch, Index k) { return (m_seams[patch] >> k & 1) == 0; };
    const Foot foot = m_reference.project_locally(p, face.last, can_cross);
    face.last = m_seams[foot.patch] == 0 ? foot : face.anchor; // at a seam the search could be caught
    return at(foot);
  }

  // Whether two faces that have the point p in common have so different samples there that they must be on different sides
  // of a seam.
  bool is_between_sides(const Point& p, Face_sampler face, Face_sampler other) const
  {
    return norm(sample(face, p) - sample(other, p)) > 1e-3 * m_range;
  }

private:
  // the largest one of any number of the values
  double range() const
  {
    double range = 0;
    for(std::size_t i = 0; i < N; ++i)
    {
      double min = (std::numeric_limits<double>::max)(), max = std::numeric_limits<double>::lowest();
      for(const Corner_values& corners : m_values)
        for(const Value& value : corners)
        {
          min = (std::min)(min, value[i]);
          max = (std::max)(max, value[i]);
        }
      range = (std::max)(range, max - min);
    }
    return range;
  }

  bool is_seam(Index patch, Index k) const
  {
    const Index across = m_reference.corner_across(patch, k);
    if(across == no_index)
      return false;
    // the common side runs the other way in the neighbor
    const Corner_values &here = m_values[patch], &there = m_values[across / 3];
    const double tolerance = 1e-6 * m_range; // of rounding in files
    return norm(here[(k + 1) % 3] - there[(across + 2) % 3]) > tolerance ||
           norm(here[(k + 2) % 3] - there[(across + 1) % 3]) > tolerance;
  }

  const Reference& m_reference;
  std::vector<Corner_values> m_values;
  double m_range;
  std::vector<unsigned char> m_seams; // bit k: the side opposite to corner k of the patch
  bool m_has_seams = false;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MAP_SIGNAL_H
