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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_VOLUME_CORRECTION_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_VOLUME_CORRECTION_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The volume that a closed remesh encloses with its vertices at `points`, signed.
inline double enclosed_volume(const Remesh& remesh, const std::vector<Point>& points)
{
  const Point& apex = remesh.initial_points.front();
  double sum = 0;
  for(std::size_t f = 0; f < remesh.number_of_faces(); ++f)
    sum += remesh.weight(f) * ((points[remesh.first_vertex(f)] - apex) * remesh.area_normal(f, points));
  return sum / 6;
}

// The relative change of the volume from the initial to the next points; 0 if there was none.
inline double volume_change(const Remesh& remesh)
{
  const double before = enclosed_volume(remesh, remesh.initial_points);
  return before == 0 ? 0 : enclosed_volume(remesh, remesh.next_points) / before - 1;
}

// Moves vertices along the normals, all by the same distance, so that the remesh encloses a given volume.
class Volume_correction
{
public:
  // of `points`, the vertices with `can_move(i)`
  template <typename CanMove>
  Volume_correction(const Remesh& remesh, const std::vector<Point>& points, const CanMove& can_move)
    : m_remesh(remesh), m_points(points), m_directions(points.size(), NULL_VECTOR)
  {
    for(std::size_t f = 0; f < remesh.number_of_faces(); ++f)
      for(Index i : remesh.face(f))
        if(can_move(i))
          m_directions[i] = m_directions[i] + remesh.weight(f) * remesh.area_normal(f, points);
    for(Vector& direction : m_directions)
      direction = normalized(direction);
  }

  // Sets `result` to the points that enclose `volume`; returns whether that is possible.
  bool enclose(const double volume, std::vector<Point>& result) const
  {
    constexpr int max_steps = 20;
    constexpr double accuracy = 1e-13, far = 0.1; // relative to the volume, and to the lengths of the edges
    const double limit = far * *std::max_element(m_remesh.lengths.begin(), m_remesh.lengths.end());
    double distance = 0, last_distance = 0, last_error = 0;
    for(int step = 0; step < max_steps; ++step)
    {
      for(std::size_t i = 0; i < result.size(); ++i)
        result[i] = m_points[i] + distance * m_directions[i];
      const double error = enclosed_volume(m_remesh, result) - volume;
      if(std::abs(error) <= accuracy * std::abs(volume))
        return true;
      // by secants, the first one by the area
      const double slope = step == 0 ? growth() : (error - last_error) / (distance - last_distance);
      last_distance = distance;
      last_error = error;
      distance -= error / slope;
      if(!(std::abs(distance) <= limit) || distance == last_distance)
        return false;
    }
    return false;
  }

private:
  // of the volume by the distance
  double growth() const
  {
    double sum = 0;
    for(std::size_t f = 0; f < m_remesh.number_of_faces(); ++f)
      for(Index i : m_remesh.face(f))
        sum += m_remesh.weight(f) * (m_remesh.area_normal(f, m_points) * m_directions[i]);
    return sum / 6;
  }

  const Remesh& m_remesh;
  const std::vector<Point>& m_points;
  std::vector<Vector> m_directions; // the normals of the vertices that can move
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_VOLUME_CORRECTION_H
