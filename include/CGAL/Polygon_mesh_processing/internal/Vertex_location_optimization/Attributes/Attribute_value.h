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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_ATTRIBUTE_VALUE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_ATTRIBUTE_VALUE_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/IO/Color.h>
#include <CGAL/number_utils.h>
#include <CGAL/Point_2.h>
#include <CGAL/Point_3.h>
#include <CGAL/tags.h>
#include <CGAL/Vector_2.h>
#include <CGAL/Vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// A value of a signal: as many numbers as the attribute has.
template <std::size_t N>
struct Signal_value
{
  static constexpr std::size_t dimension = N;

  double& operator[](std::size_t i) { return numbers[i]; }
  double operator[](std::size_t i) const { return numbers[i]; }

  Signal_value& operator+=(const Signal_value& other)
  {
    for(std::size_t i = 0; i < N; ++i)
      numbers[i] += other[i];
    return *this;
  }

  friend Signal_value operator+(Signal_value a, const Signal_value& b) { return a += b; }
  friend Signal_value operator-(const Signal_value& a, const Signal_value& b) { return a + (-1) * b; }
  friend Signal_value operator*(double s, Signal_value a)
  {
    for(double& x : a.numbers)
      x *= s;
    return a;
  }

  friend bool is_finite(const Signal_value& a)
  {
    return std::all_of(a.numbers.begin(), a.numbers.end(), [](double x) { return std::isfinite(x); });
  }

  friend double norm(const Signal_value& a)
  {
    if constexpr(N == 1)
      return std::abs(a[0]);
    double sum = 0;
    for(double x : a.numbers)
      sum += x * x;
    return std::sqrt(sum);
  }

  std::array<double, N> numbers{};
};

// a + u (b - a) + v (c - a), which is exact where the three are the same
template <std::size_t N>
Signal_value<N> interpolate(const Signal_value<N>& a, const Signal_value<N>& b, const Signal_value<N>& c, double u, double v)
{
  return a + (u * (b - a) + v * (c - a));
}

template <typename T>
struct Is_number
  : std::bool_constant<!std::is_same<T, bool>::value &&
                       (std::is_arithmetic<T>::value ||
                        !std::is_same<typename Algebraic_structure_traits<T>::Algebraic_category, Null_tag>::value)>
{};

// to the nearest number of an integral type
template <typename T>
T number_from_double(double x)
{
  if constexpr(std::is_integral<T>::value)
  {
    // as doubles, the limits of 64 bits may be beyond what fits
    if(x <= static_cast<double>((std::numeric_limits<T>::min)()))
      return (std::numeric_limits<T>::min)();
    if(x >= static_cast<double>((std::numeric_limits<T>::max)()))
      return (std::numeric_limits<T>::max)();
    return static_cast<T>(std::round(x));
  }
  else
    return static_cast<T>(x);
}

// How the values of an attribute are turned to those of a signal, and back.
template <typename T, typename = void>
struct Attribute_value
{
  static constexpr std::size_t dimension = 0; // not an attribute that can be interpolated
};

template <typename T>
struct Attribute_value<T, std::enable_if_t<Is_number<T>::value>>
{
  static constexpr std::size_t dimension = 1;
  static Signal_value<1> to_signal(const T& x) { return { { to_double(x) } }; }
  static T from_signal(const Signal_value<1>& x) { return number_from_double<T>(x[0]); }
};

template <typename T>
struct Coordinates_2
{
  using FT = typename T::R::FT;
  static constexpr std::size_t dimension = 2;
  static Signal_value<2> to_signal(const T& p) { return { { to_double(p.x()), to_double(p.y()) } }; }
  static T from_signal(const Signal_value<2>& x) { return T(FT(x[0]), FT(x[1])); }
};

template <typename T>
struct Coordinates_3
{
  using FT = typename T::R::FT;
  static constexpr std::size_t dimension = 3;
  static Signal_value<3> to_signal(const T& p) { return { { to_double(p.x()), to_double(p.y()), to_double(p.z()) } }; }
  static T from_signal(const Signal_value<3>& x) { return T(FT(x[0]), FT(x[1]), FT(x[2])); }
};

template <typename K>
struct Attribute_value<Point_2<K>, void> : Coordinates_2<Point_2<K>>
{};
template <typename K>
struct Attribute_value<Vector_2<K>, void> : Coordinates_2<Vector_2<K>>
{};
template <typename K>
struct Attribute_value<Point_3<K>, void> : Coordinates_3<Point_3<K>>
{};
template <typename K>
struct Attribute_value<Vector_3<K>, void> : Coordinates_3<Vector_3<K>>
{};

template <>
struct Attribute_value<CGAL::IO::Color, void>
{
  static constexpr std::size_t dimension = 4;

  static Signal_value<4> to_signal(const CGAL::IO::Color& c)
  {
    return { { double(c.red()), double(c.green()), double(c.blue()), double(c.alpha()) } };
  }

  static CGAL::IO::Color from_signal(const Signal_value<4>& x)
  {
    const auto channel = [&](std::size_t i) { return number_from_double<unsigned char>(x[i]); };
    return CGAL::IO::Color(channel(0), channel(1), channel(2), channel(3));
  }
};

template <typename T, std::size_t N>
struct Attribute_value<std::array<T, N>, std::enable_if_t<Is_number<T>::value>>
{
  static constexpr std::size_t dimension = N;

  static Signal_value<N> to_signal(const std::array<T, N>& a)
  {
    Signal_value<N> x;
    for(std::size_t i = 0; i < N; ++i)
      x[i] = to_double(a[i]);
    return x;
  }

  static std::array<T, N> from_signal(const Signal_value<N>& x)
  {
    std::array<T, N> a;
    for(std::size_t i = 0; i < N; ++i)
      a[i] = number_from_double<T>(x[i]);
    return a;
  }
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_ATTRIBUTE_VALUE_H
