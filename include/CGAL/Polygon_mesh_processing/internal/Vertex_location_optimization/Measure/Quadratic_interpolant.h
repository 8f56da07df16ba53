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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_QUADRATIC_INTERPOLANT_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_QUADRATIC_INTERPOLANT_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/triangle_coordinates.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The quadratic function on a triangle with given values at its corners and at the midpoints of the sides opposite to them.
class Quadratic_interpolant
{
public:
  Quadratic_interpolant(const std::array<double, 3>& at_corners, const std::array<double, 3>& at_midpoints)
    : m_corners(at_corners), m_midpoints(at_midpoints), m_changes_sign(changes_sign())
  {}

  // the mean over the triangle of its absolute value
  double mean_of_absolute() const { return m_changes_sign ? mean_of_absolute_pieces() : std::abs(mean()); }

  // the mean over the triangle of its square
  double mean_of_square() const
  {
    double sum = 0;
    for(int k = 0; k < 3; ++k)
    {
      const int l = (k + 1) % 3;
      sum += 6 * m_corners[k] * m_corners[k] + 32 * m_midpoints[k] * m_midpoints[k] - 2 * m_corners[k] * m_corners[l] +
             32 * m_midpoints[k] * m_midpoints[l] - 8 * m_corners[k] * m_midpoints[k];
    }
    return (std::max)(0., sum / 180);
  }

  // what `mean_of_absolute()` is the mean of; not the absolute value where only rounding or overshooting changes the sign
  double absolute_at(const Coordinates& x) const
  {
    return m_changes_sign ? std::abs(piecewise_linear_at(x)) : std::copysign(1., mean()) * value_at(x);
  }

  double square_at(const Coordinates& x) const { return square(value_at(x)); }

  // how much it bends: the sum of the squares of its differences, at the midpoints, from the linear function with the same
  // values at the corners
  double squared_bend() const
  {
    double sum = 0;
    for(int k = 0; k < 3; ++k)
      sum += square(m_midpoints[k] - (m_corners[(k + 1) % 3] + m_corners[(k + 2) % 3]) / 2);
    return sum;
  }

private:
  static constexpr int level = 4; // the sides are cut into so many pieces where the function changes its sign
  template <typename T>
  using Lattice = std::array<T, (level + 1) * (level + 2) / 2>;
  using Weights = std::array<double, 6>;

  double mean() const { return (m_midpoints[0] + m_midpoints[1] + m_midpoints[2]) / 3; }

  bool changes_sign() const
  {
    const double least = (std::min)(*std::min_element(m_corners.begin(), m_corners.end()),
                                    *std::min_element(m_midpoints.begin(), m_midpoints.end()));
    const double largest = (std::max)(*std::max_element(m_corners.begin(), m_corners.end()),
                                      *std::max_element(m_midpoints.begin(), m_midpoints.end()));
    constexpr double rounding = 1e-9; // at vertices on the reference
    return least < -rounding * largest && largest > -rounding * least;
  }

  double value_at(const Coordinates& x) const { return value(weights_at(x.u, x.v)); }

  double value(const Weights& w) const
  {
    return w[0] * m_corners[0] + w[1] * m_corners[1] + w[2] * m_corners[2] + w[3] * m_midpoints[0] + w[4] * m_midpoints[1] +
           w[5] * m_midpoints[2];
  }

  static Weights weights_at(double u, double v)
  {
    const double w = 1 - u - v;
    return { w * (2 * w - 1), u * (2 * u - 1), v * (2 * v - 1), 4 * u * v, 4 * v * w, 4 * w * u };
  }

  // Cuts the triangle into congruent ones on which the function is nearly linear. The error of the linear function there is
  // the same in all of them, as the second derivatives are constant.
  double mean_of_absolute_pieces() const
  {
    Lattice<double> values;
    for(std::size_t i = 0; i < values.size(); ++i)
      values[i] = value_on_lattice(i);
    double sum = 0;
    for(int i = 0; i < level; ++i)
      for(int j = 0; j < level - i; ++j)
      {
        const double a = values[on_lattice(i + 1, j)], b = values[on_lattice(i, j + 1)];
        sum += mean_of_absolute_linear(values[on_lattice(i, j)], a, b);
        if(i + j + 1 < level)
          sum += mean_of_absolute_linear(values[on_lattice(i + 1, j + 1)], a, b);
      }
    return sum / (level * level);
  }

  // the piecewise linear function whose absolute value `mean_of_absolute_pieces()` integrates
  double piecewise_linear_at(const Coordinates& x) const
  {
    const int i = (std::min)(static_cast<int>(level * x.u), level - 1);
    const int j = (std::min)(static_cast<int>(level * x.v), level - 1 - i);
    const double u = level * x.u - i, v = level * x.v - j;
    const double a = value_on_lattice(on_lattice(i + 1, j)), b = value_on_lattice(on_lattice(i, j + 1));
    if(u + v <= 1 || i + j + 1 == level)
      return (1 - u - v) * value_on_lattice(on_lattice(i, j)) + u * a + v * b;
    return (u + v - 1) * value_on_lattice(on_lattice(i + 1, j + 1)) + (1 - v) * a + (1 - u) * b;
  }

  double value_on_lattice(const std::size_t i) const
  {
    static const Lattice<Weights> weights = weights_on_lattice();
    return value(weights[i]) + linear_error();
  }

  double linear_error() const { return (mean() - (m_corners[0] + m_corners[1] + m_corners[2]) / 3) / (level * level); }

  // of the linear function with these values at the corners
  static double mean_of_absolute_linear(double a, double b, double c)
  {
    // a is the one whose sign differs
    if((b > 0) == (a > 0))
      std::swap(a, (c > 0) == (a > 0) ? a : c);
    else if((c > 0) == (a > 0))
      std::swap(a, b);
    const double mean = (a + b + c) / 3, product = (a - b) * (a - c);
    if((b > 0) == (a > 0) || !(product > 0))
      return std::abs(mean);
    return std::abs(2 * a * a * a / (3 * product) - mean);
  }

  static constexpr std::size_t on_lattice(int i, int j) { return i * (2 * level + 3 - i) / 2 + j; }

  static Lattice<Weights> weights_on_lattice()
  {
    Lattice<Weights> weights;
    for(int i = 0; i <= level; ++i)
      for(int j = 0; j <= level - i; ++j)
        weights[on_lattice(i, j)] = weights_at(double(i) / level, double(j) / level);
    return weights;
  }

  std::array<double, 3> m_corners, m_midpoints;
  bool m_changes_sign;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_QUADRATIC_INTERPOLANT_H
