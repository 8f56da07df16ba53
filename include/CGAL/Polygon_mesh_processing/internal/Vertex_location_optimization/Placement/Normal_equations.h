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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_NORMAL_EQUATIONS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_NORMAL_EQUATIONS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <CGAL/Default_diagonalize_traits.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The normal equations of a vertex, H d = g, for its displacement d.
class Normal_equations
{
  using Diagonalize_traits = Default_diagonalize_traits<double, 3>;

public:
  Normal_equations() = default;

  // Those of a sample at the vertex: along `normal` it should move by `offset`, from the remesh to the reference. `area` is
  // what the sample stands for. Reweighting replaces the squares of the distances, except for the smallest, by the power 2 -
  // `reweighting`. It lowers the mean distance at the same regularity, as a few bad places have less influence.
  Normal_equations(
    const Vector& normal, const Vector& offset, const double area, const double length, const double reweighting)
  {
    constexpr double smallest_residual = 1e-4; // relative to `length`, that of edges
    const double residual = normal * offset;
    const double weight = area / power(smallest_residual + std::abs(residual) / length, reweighting);
    const Vector m = weight * normal;
    m_H = { m.x() * normal.x(), m.x() * normal.y(), m.x() * normal.z(),
            m.y() * normal.y(), m.y() * normal.z(), m.z() * normal.z() };
    m_g = residual * m;
    m_area = area;
    m_sum_of_residuals = area * std::abs(residual);
  }

  // adds those of a sample that moves by `lambda` times the displacement of the vertex
  void add(const Normal_equations& of_sample, const double lambda)
  {
    for(int k = 0; k < 6; ++k)
      m_H[k] += lambda * lambda * of_sample.m_H[k];
    m_g = m_g + lambda * of_sample.m_g;
    m_area += lambda * of_sample.m_area;
    m_sum_of_residuals += lambda * of_sample.m_sum_of_residuals;
  }

  Normal_equations& operator+=(const Normal_equations& other)
  {
    for(int k = 0; k < 6; ++k)
      m_H[k] += other.m_H[k];
    m_g = m_g + other.m_g;
    m_area += other.m_area;
    m_sum_of_residuals += other.m_sum_of_residuals;
    return *this;
  }

  // The solution with the vertex pulled in the directions that the rows hardly determine: along a smooth surface, but not
  // across a crease. `epsilon` is small beside the weights and keeps the system regular.
  Vector solve(const Vector& pull, const double pull_weight, const double epsilon) const
  {
    Diagonalize_traits::Vector h; // the eigenvalues, in increasing order
    Diagonalize_traits::Matrix e;
    if(!Diagonalize_traits::diagonalize_selfadjoint_covariance_matrix(m_H, h, e) || !(h[2] > 0))
      return NULL_VECTOR;

    // no pull in directions determined at least half as well as the best determined one
    constexpr double softness = 2;
    Vector d = NULL_VECTOR;
    for(int k = 0; k < 3; ++k)
    {
      const Vector direction(e[3 * k], e[3 * k + 1], e[3 * k + 2]);
      const double weight = pull_weight * (1 - (std::min)(1., softness * h[k] / h[2]));
      d = d + ((m_g * direction + weight * (pull * direction)) / (h[k] + weight + epsilon)) * direction;
    }
    return d;
  }

  const Vector& right_hand_side() const { return m_g; }

  // of the distances along the normals, over the area that the samples stand for
  double mean_residual() const { return m_area > 0 ? m_sum_of_residuals / m_area : 0; }

private:
  static double power(const double x, const double exponent)
  {
    return exponent == 0.5 ? std::sqrt(x) : std::pow(x, exponent); // most often the former, which is much faster
  }

  Diagonalize_traits::Covariance_matrix m_H{ { 0, 0, 0, 0, 0, 0 } }; // the upper triangle, row by row
  Vector m_g = NULL_VECTOR;
  double m_area = 0, m_sum_of_residuals = 0;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_NORMAL_EQUATIONS_H
