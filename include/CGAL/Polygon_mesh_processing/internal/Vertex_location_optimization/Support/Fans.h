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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FANS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FANS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// A triangle of a polygon, by three of its corners in the order around it.
struct Fan_triangle
{
  std::array<Index, 3> corners;
  std::array<Index, 3> sides; // opposite to each corner: side i goes from corner i to the next one; or n + i: diagonal i
  double weight;
};

// The triangles of the fans of a polygon with n corners: one fan from each corner, all with the same weight. Triangles
// shared by several fans are stored once: an ear cuts off one corner and is in two fans; any other triangle is in one.
struct Fans
{
  explicit Fans(const Index n)
  {
    for(Index k = 0; k < n; ++k)
      add_triangle(n, k, (k + 1) % n, (k + 2) % n, n == 3 ? 1. : 2. / n);
    if(n == 3)
      triangles.resize(1);

    // so many that the number of triangles is linear for large polygons
    constexpr Index most_fans = 64;
    const Index stride = (n + most_fans - 1) / most_fans, number_of_fans = (n + stride - 1) / stride;
    for(Index apex = 0; apex < n; apex += stride)
      for(Index k = apex + 2; k + 2 < apex + n; ++k)
        add_triangle(n, apex, k % n, (k + 1) % n, 1. / number_of_fans);
  }

  std::vector<Fan_triangle> triangles; // the first n are the ears: ear i at the corner i + 1; a triangle has only one
  std::vector<std::array<Index, 2>> diagonals;

private:
  void add_triangle(const Index n, const Index a, const Index b, const Index c, const double weight)
  {
    triangles.push_back({ { a, b, c }, { side(n, b, c), side(n, c, a), side(n, a, b) }, weight });
  }

  Index side(const Index n, const Index from, const Index to)
  {
    if(to == (from + 1) % n)
      return from;
    const std::array<Index, 2> ends{ (std::min)(from, to), (std::max)(from, to) };
    const auto [diagonal, is_new] = m_numbers.emplace(ends, static_cast<Index>(diagonals.size()));
    if(is_new)
      diagonals.push_back(ends);
    return n + diagonal->second;
  }

  std::map<std::array<Index, 2>, Index> m_numbers; // of the diagonals
};

// The fans of polygons, made once for each number of corners.
class Fans_by_degree
{
public:
  const Fans& operator()(Index n)
  {
    if(n != m_last_degree)
      m_last = &m_fans.try_emplace(n, n).first->second;
    m_last_degree = n;
    return *m_last;
  }

private:
  std::map<Index, Fans> m_fans;
  Index m_last_degree = 0; // most polygons of a mesh have as many corners as the one before
  const Fans* m_last = nullptr;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FANS_H
