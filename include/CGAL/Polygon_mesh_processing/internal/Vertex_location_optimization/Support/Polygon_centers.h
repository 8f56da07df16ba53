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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_POLYGON_CENTERS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_POLYGON_CENTERS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Mesh_arrays.h>

#include <cstddef>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The centroid of the vertices of the polygon that each face of a mesh is of.
class Polygon_centers
{
public:
  explicit Polygon_centers(const Mesh_arrays& mesh) : m_mesh(mesh)
  {
    if(!mesh.has_polygons())
      return;
    m_centers.assign(mesh.number_of_polygons(), ORIGIN);
    std::vector<double> degrees(m_centers.size(), 0);
    for(Index c = 0; c < mesh.ears.size(); ++c)
      if(mesh.ear(c) == c)
      {
        Point& center = m_centers[mesh.polygons[c / 3]];
        center = center + (mesh.points[mesh.vertex(c)] - center) / ++degrees[mesh.polygons[c / 3]];
      }
  }

  Point operator()(std::size_t f) const
  {
    return m_mesh.has_polygons() ? m_centers[m_mesh.polygons[f]] : m_mesh.barycenter(f);
  }

private:
  const Mesh_arrays& m_mesh;
  std::vector<Point> m_centers; // of the polygons, if there are any
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_POLYGON_CENTERS_H
