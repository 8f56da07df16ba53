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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_GEOMETRY_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_GEOMETRY_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Cartesian_converter.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The internals work in double precision, whatever the kernel of the user's points.
using Kernel = Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;

using Index = std::uint32_t;
constexpr Index no_index = (std::numeric_limits<Index>::max)();

inline double norm(const Vector& v) { return std::sqrt(v.squared_length()); }

// v scaled to length 1; the null vector if v has no direction
inline Vector normalized(const Vector& v)
{
  const double length = norm(v);
  return (length > 0 && std::isfinite(length)) ? v / length : Vector(NULL_VECTOR);
}

inline bool is_finite(const Point& p) { return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()); }

// twice the area of the triangle, along its normal
inline Vector area_normal(const Point& p, const Point& q, const Point& r) { return cross_product(q - p, r - p); }

inline double squared_longest_side(const std::array<Point, 3>& t)
{
  return (std::max)({ squared_distance(t[0], t[1]), squared_distance(t[1], t[2]), squared_distance(t[2], t[0]) });
}

// angle at p in radians; well conditioned near 0 and pi, 0 where an edge has no length
inline double angle_at(const Point& p, const Point& q, const Point& r)
{
  const Vector u = q - p, v = r - p;
  return std::atan2(norm(cross_product(u, v)), u * v);
}

// to single precision: what bounds x bounds it still
inline float rounded_up(const double x)
{
  return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity());
}

// a point or vector in another kernel, by way of double precision
template <typename To, typename From>
To convert(const From& p)
{
  if constexpr(std::is_same<To, From>::value)
    return p;
  else
    return Cartesian_converter<typename Kernel_traits<From>::Kernel, typename Kernel_traits<To>::Kernel>()(p);
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_GEOMETRY_H
