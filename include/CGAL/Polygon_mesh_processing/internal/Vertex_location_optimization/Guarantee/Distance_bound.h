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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_DISTANCE_BOUND_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_DISTANCE_BOUND_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/triangle_coordinates.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// A convex polygon that a triangle is cut to.
class Cut_triangle
{
public:
  Cut_triangle() = default;

  explicit Cut_triangle(const std::array<Point, 3>& t)
  {
    for(const Point& p : t)
      add(p);
  }

  void add(const Point& p) { m_corners.push_back(p); }

  bool is_empty() const { return m_corners.empty(); }
  const Point* begin() const { return m_corners.data(); }
  const Point* end() const { return m_corners.data() + m_corners.size(); }

  // Cuts off where height(p), a linear function, is positive, and returns that. A polygon that has so many corners that
  // there might be no room is left as it is: by rounding a plane may cross all sides of a narrow one.
  template <typename Height>
  Cut_triangle cut(const Height& height)
  {
    std::array<double, max_corners> heights;
    std::transform(begin(), end(), heights.begin(), height);
    const std::size_t size = m_corners.size();
    const auto end_of_heights = heights.begin() + size;
    Cut_triangle inside, outside;
    if(2 * size > max_corners || std::none_of(heights.begin(), end_of_heights, [](double h) { return h > 0; }))
      return outside;
    if(std::none_of(heights.begin(), end_of_heights, [](double h) { return h < 0; }))
    {
      outside = *this;
      *this = inside;
      return outside;
    }
    for(std::size_t i = 0, j = size - 1; i < size; j = i++)
    {
      if((heights[j] < 0 && heights[i] > 0) || (heights[j] > 0 && heights[i] < 0))
      {
        const Point crossing = m_corners[j] + heights[j] / (heights[j] - heights[i]) * (m_corners[i] - m_corners[j]);
        inside.add(crossing);
        outside.add(crossing);
      }
      if(heights[i] <= 0)
        inside.add(m_corners[i]);
      if(heights[i] >= 0)
        outside.add(m_corners[i]);
    }
    *this = inside;
    return outside;
  }

private:
  static constexpr std::size_t max_corners = 24;

  boost::container::static_vector<Point, max_corners> m_corners;
};

// Bounds the distance that points of a triangle have from a remesh and its surroundings. The distance from a single face is
// a convex function: on a polygon it is largest at a corner. So each way to cut the triangle into polygons, and to choose a
// face for each, gives an upper bound. Here it is cut where the remesh has its edges, by the planes that bisect the angles
// there: the bound is the largest distance, then, unless another sheet of the remesh is closer.
class Distance_bound
{
public:
  // a point where the bound is reached, in the triangle
  struct Result
  {
    double distance = 0;
    Point point = ORIGIN;
  };

  // with the vertices of the remesh at `points`
  Distance_bound(const Remesh& remesh, const std::vector<Point>& points) : m_remesh(remesh), m_points(points) {}

  std::array<Point, 3> face(const Index f) const
  {
    const std::size_t n = m_remesh.number_of_faces();
    return f < n ? m_remesh.triangle(f, m_points) : m_remesh.surroundings.triangle(f - n);
  }

  // Begins at face f and goes on where the distance is more than `enough`; appends the faces that it depends on.
  Result operator()(const std::array<Point, 3>& t, const Index f, const double enough, std::vector<Index>& faces) const
  {
    constexpr int max_cells = 96; // it bounds the time around vertices where the planes do not meet
    Result result;
    Cell cell{ Cut_triangle(t), f, no_index };
    std::vector<Cell> cells; // the others
    for(int number = 1;; ++number)
    {
      const std::array<Point, 3> triangle = face(cell.face);
      Result farthest = farthest_corner(cell.polygon, triangle);
      if(farthest.distance > enough && number <= max_cells && cell.face < m_remesh.number_of_faces())
      {
        cut_off_outside(cell, triangle, cells);
        farthest = farthest_corner(cell.polygon, triangle);
      }
      faces.push_back(cell.face);
      if(farthest.distance > result.distance)
        result = farthest;
      if(cells.empty())
        return result;
      cell = cells.back();
      cells.pop_back();
    }
  }

  // The corner opposite to the same edge on its other side; that of a diagonal, too, if its polygon has no other triangles
  // there.
  Index corner_across(const Index corner) const
  {
    const Index e = m_remesh.opposite_edge(corner);
    if(!m_remesh.is_diagonal(e))
      return m_remesh.corner_across(corner);
    const std::array<Index, 2>& c = m_remesh.edge_corners[e];
    return c[0] == corner ? c[1] : c[1] == corner ? c[0] : no_index;
  }

private:
  struct Cell
  {
    Cut_triangle polygon;
    Index face;
    Index entrance; // the corner of the face that is opposite to the edge where the polygon was cut
  };

  static Result farthest_corner(const Cut_triangle& polygon, const std::array<Point, 3>& face)
  {
    Result result;
    const Triangle_plane plane(face);
    for(const Point& p : polygon)
    {
      const double distance2 = squared_distance(p, point_at(face, closest_on_triangle(face, p, plane.project(p))));
      if(distance2 > result.distance)
        result = { distance2, p };
    }
    result.distance = std::sqrt(result.distance);
    return result;
  }

  // Leaves what is between the bisecting planes at the edges of a face; the rest becomes cells of the neighbors.
  void cut_off_outside(Cell& cell, const std::array<Point, 3>& t, std::vector<Cell>& cells) const
  {
    const Vector normal = normalized(area_normal(t[0], t[1], t[2]));
    for(Index k = 0; k < 3 && !cell.polygon.is_empty(); ++k)
    {
      const Index corner = 3 * cell.face + k, across = corner_across(corner);
      if(across == no_index || corner == cell.entrance)
        continue;
      const std::array<Point, 3> other = face(across / 3);
      const Vector bisector = normal + normalized(area_normal(other[0], other[1], other[2]));
      const Point& p = t[(k + 1) % 3];
      const Vector outwards = cross_product(t[(k + 2) % 3] - p, bisector);
      const Cut_triangle outside = cell.polygon.cut([&](const Point& q) { return (q - p) * outwards; });
      if(!outside.is_empty())
        cells.push_back({ outside, across / 3, across });
    }
  }

  const Remesh& m_remesh;
  const std::vector<Point>& m_points;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_DISTANCE_BOUND_H
