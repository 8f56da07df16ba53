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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PIECE_OF_PATCH_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PIECE_OF_PATCH_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Flat_triangle.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Reference_patches.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/triangle_coordinates.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// A triangle of the coordinates of a patch, and the flat triangle between its corners on the patch.
struct Piece_of_patch
{
  std::array<Coordinates, 3> coordinates;
  std::array<Point, 3> corners;

  Point center() const { return centroid(corners[0], corners[1], corners[2]); }

  double length() const { return std::sqrt(squared_longest_side(corners)); }

  double radius() const // around the center
  {
    const Point p = center();
    return std::sqrt(
      (std::max)({ squared_distance(corners[0], p), squared_distance(corners[1], p), squared_distance(corners[2], p) }));
  }

  // in the patch, of the point that has coordinates x in the piece
  Coordinates at(const Coordinates& x) const
  {
    const std::array<Coordinates, 3>& c = coordinates;
    return { c[0].u + x.u * (c[1].u - c[0].u) + x.v * (c[2].u - c[0].u),
             c[0].v + x.u * (c[1].v - c[0].v) + x.v * (c[2].v - c[0].v) };
  }
};

template <typename Reference>
Piece_of_patch piece_of_patch(const Reference& reference, const Index patch, const std::array<Coordinates, 3>& x)
{
  return { x, { reference.point({ patch, x[0] }), reference.point({ patch, x[1] }), reference.point({ patch, x[2] }) } };
}

template <typename Reference>
Piece_of_patch whole_patch(const Reference& reference, const Index patch)
{
  return { { { { 0, 0 }, { 1, 0 }, { 0, 1 } } }, reference.patch(patch).corners() };
}

// How far a piece of a patch is from the flat triangle at most.
inline double sag(const Reference_patches<Flat_triangle>&, Index, const Piece_of_patch&) { return 0; }

// A cubic patch: the control points, whose offsets from their places on the flat triangle bound the offset of the patch,
// follow from its points at the thirds of the sides and in the center.
template <typename Reference>
double sag(const Reference& reference, const Index patch, const Piece_of_patch& piece)
{
  const auto offset_at = [&](double u, double v) {
    const Coordinates x{ u, v };
    return reference.point({ patch, piece.at(x) }) - point_at(piece.corners, x);
  };
  constexpr double third = 1. / 3;
  constexpr std::array<Coordinates, 4> corners{ { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 0, 0 } } };
  double largest2 = 0;
  Vector sum = NULL_VECTOR;
  for(int k = 0; k < 3; ++k)
  {
    const auto offset_beside = [&](const Coordinates& a, const Coordinates& b) {
      return offset_at(a.u + third * (b.u - a.u), a.v + third * (b.v - a.v));
    };
    const Vector first = offset_beside(corners[k], corners[k + 1]), second = offset_beside(corners[k + 1], corners[k]);
    for(const Vector& control_point : { 3 * first - 1.5 * second, 3 * second - 1.5 * first })
    {
      largest2 = (std::max)(largest2, control_point.squared_length());
      sum = sum + control_point;
    }
  }
  const Vector center = (27 * offset_at(third, third) - 3 * sum) / 6;
  return std::sqrt((std::max)(largest2, center.squared_length()));
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PIECE_OF_PATCH_H
