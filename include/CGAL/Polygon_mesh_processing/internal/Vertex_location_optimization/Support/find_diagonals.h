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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIND_DIAGONALS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIND_DIAGONALS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

// The triangulations are those of `triangulate_faces()`, a call of which takes longer to compile than all of this, since it
// fills holes of any shape, too.

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

using Diagonal = std::array<std::size_t, 2>; // the corners that it joins

// The pair of triangles of a quad with the larger scalar product of the normals: its triangles are similar in size and
// orientation.
inline Diagonal find_diagonal_of_quad(const std::vector<Point>& p)
{
  const double product_02 = area_normal(p[0], p[1], p[2]) * area_normal(p[0], p[2], p[3]);
  const double product_13 = area_normal(p[0], p[1], p[3]) * area_normal(p[1], p[2], p[3]);
  return product_02 > product_13 ? Diagonal{ 0, 2 } : Diagonal{ 1, 3 };
}

// The constrained Delaunay triangulation of a polygon in its plane.
class Polygon_triangulation
{
  using Traits = Exact_predicates_inexact_constructions_kernel;
  using Vertex_base = Triangulation_vertex_base_with_info_2<std::size_t, Traits>;
  using Info_base = Triangulation_face_base_with_info_2<bool, Traits>; // whether the face is outside
  using Face_base = Constrained_triangulation_face_base_2<Traits, Info_base>;
  using Triangulation = Constrained_Delaunay_triangulation_2<Traits,
                                                             Triangulation_data_structure_2<Vertex_base, Face_base>,
                                                             No_constraint_intersection_tag>;

public:
  // `normal` is a unit vector.
  Polygon_triangulation(const std::vector<Point>& points, const Vector& normal) : m_number_of_corners(points.size())
  {
    const bool is_x_small = std::abs(normal.x()) < 0.5;
    const Vector x_axis = normalized(cross_product(normal, is_x_small ? Vector(1, 0, 0) : Vector(0, 1, 0)));
    const Vector y_axis = cross_product(normal, x_axis);
    std::vector<Triangulation::Vertex_handle> corners;
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      const Vector v = points[i] - points[0];
      corners.push_back(m_triangulation.insert(Traits::Point_2(v * x_axis, v * y_axis)));
      corners.back()->info() = i;
    }
    if(m_triangulation.number_of_vertices() == points.size())
      m_is_polygon = insert_sides(corners);
  }

  // none if the polygon has no triangulation in its plane
  std::vector<Diagonal> diagonals()
  {
    std::vector<Diagonal> result;
    if(!m_is_polygon || m_triangulation.dimension() != 2)
      return result;
    mark_outside();
    for(auto e = m_triangulation.finite_edges_begin(); e != m_triangulation.finite_edges_end(); ++e)
      if(!e->first->info() && !m_triangulation.is_constrained(*e))
        result.push_back({ e->first->vertex(Triangulation::cw(e->second))->info(),
                           e->first->vertex(Triangulation::ccw(e->second))->info() });
    if(result.size() + 3 != m_number_of_corners)
      result.clear();
    return result;
  }

private:
  // Returns whether the sides do not intersect.
  bool insert_sides(const std::vector<Triangulation::Vertex_handle>& corners)
  {
    try
    {
      for(std::size_t i = 0; i < corners.size(); ++i)
        m_triangulation.insert_constraint(corners[i], corners[(i + 1) % corners.size()]);
    }
    catch(const Triangulation::Intersection_of_constraints_exception&)
    {
      return false;
    }
    return true;
  }

  void mark_outside()
  {
    for(auto f : m_triangulation.all_face_handles())
      f->info() = false;
    std::vector<Triangulation::Face_handle> stack{ m_triangulation.infinite_face() };
    while(!stack.empty())
    {
      const Triangulation::Face_handle f = stack.back();
      stack.pop_back();
      if(f->info())
        continue;
      f->info() = true;
      for(int k = 0; k < 3; ++k)
        if(!f->is_constrained(k))
          stack.push_back(f->neighbor(k));
    }
  }

  const std::size_t m_number_of_corners;
  bool m_is_polygon = false;
  Triangulation m_triangulation;
};

// The diagonals that make triangles of a polygon; none if it has no plane, or no triangulation there.
inline std::vector<Diagonal> find_diagonals(const std::vector<Point>& points)
{
  Vector area(NULL_VECTOR);
  for(std::size_t i = 2; i < points.size(); ++i)
    area = area + area_normal(points[0], points[i - 1], points[i]);
  const Vector normal = normalized(area);
  if(normal == NULL_VECTOR)
    return {};
  if(points.size() == 4)
    return { find_diagonal_of_quad(points) };
  return Polygon_triangulation(points, normal).diagonals();
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIND_DIAGONALS_H
