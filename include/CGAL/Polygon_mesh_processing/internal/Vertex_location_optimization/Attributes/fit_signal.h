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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIT_SIGNAL_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIT_SIGNAL_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/Corner_nodes.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/sample_signal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The values at nodes whose linear interpolation over the faces of a mesh is closest to the samples of a signal in the least
// squares sense: the solution of M x = b with the mass matrix M of the nodes. The eigenvalues of M, scaled by its diagonal,
// lie between 1/2 and 2 for any mesh (Wathen, Realistic eigenvalue bounds for the Galerkin mass matrix, 1987), so that a
// fixed number of Chebyshev iterations solves it, each of which reduces the error to a third. An iteration is a loop over
// the nodes; it needs no sums over the mesh.
template <typename Value>
class Signal_fit
{
public:
  Signal_fit(const Mesh_arrays& mesh, const Signal_samples<Value>& samples)
    : m_mesh(mesh), m_samples(samples), m_nodes(mesh, samples.is_seam)
  {}

  const Corner_nodes& nodes() const { return m_nodes; }
  const std::vector<Value>& values() const { return m_values; } // of the nodes

  // the samples at the nodes
  const Value& sample(std::size_t node) const { return m_samples.at_corners[m_nodes.first_corner(node)]; }

  // Computes the values; where the faces around a node have no area they are the samples. If `clamp_to_samples`, no value
  // leaves the range of the samples around it.
  template <typename ConcurrencyTag>
  void solve(const bool clamp_to_samples)
  {
    const std::size_t n = m_nodes.size();
    weigh_faces<ConcurrencyTag>();
    std::vector<Value> sampled(n);
    for_each_index<ConcurrencyTag>(n, [&](std::size_t i) { sampled[i] = sample(i); });
    m_values = sampled;
    iterate<ConcurrencyTag>(integrate<ConcurrencyTag>());
    for_each_index<ConcurrencyTag>(n, [&](std::size_t i) {
      if(!is_finite(m_values[i]))
        m_values[i] = sampled[i];
      if(clamp_to_samples)
        clamp(i);
    });
    take_back_harm<ConcurrencyTag>(sampled);
  }

private:
  // the areas of the faces, relative to the largest one
  template <typename ConcurrencyTag>
  void weigh_faces()
  {
    m_weights.resize(m_mesh.number_of_faces());
    for_each_index<ConcurrencyTag>(m_weights.size(), [&](std::size_t f) { m_weights[f] = m_mesh.area(f); });
    const double largest = m_weights.empty() ? 0 : *std::max_element(m_weights.begin(), m_weights.end());
    for(double& w : m_weights)
      w = (largest > 0 && std::isfinite(largest)) ? w / largest : 0;
  }

  double weight_of_sample(std::size_t f) const
  {
    return m_weights[f] / static_cast<double>(number_of_lattice_points(m_samples.pieces[f]));
  }

  // the integrals of the signal times the hat function of each corner
  template <typename ConcurrencyTag>
  std::vector<Value> integrate() const
  {
    std::vector<Value> integrals(3 * m_mesh.number_of_faces());
    for_each_index<ConcurrencyTag>(m_mesh.number_of_faces(), [&](std::size_t f) {
      const double weight = weight_of_sample(f);
      for_each_sample(m_samples, f, [&](const Coordinates& x, const Value& value) {
        const std::array<double, 3> lambda = x.barycentric();
        for(int k = 0; k < 3; ++k)
          integrals[3 * f + k] += (weight * lambda[k]) * value;
      });
    });
    return integrals;
  }

  // The iteration of Chebyshev for M x = b, scaled by the diagonal of M (Saad, Iterative Methods for Sparse Linear Systems,
  // Algorithm 12.1).
  template <typename ConcurrencyTag>
  void iterate(const std::vector<Value>& integrals)
  {
    constexpr int number_of_iterations = 24;       // an error of 1e-11
    constexpr double center = 1.25, radius = 0.75; // of the eigenvalues
    const std::size_t n = m_nodes.size();
    std::vector<Value> steps(n), next(n);
    double rho = 0;
    for(int iteration = 0; iteration < number_of_iterations; ++iteration)
    {
      const double last_rho = rho;
      rho = iteration == 0 ? radius / center : 1 / (2 * center / radius - last_rho);
      for_each_index<ConcurrencyTag>(n, [&](std::size_t i) {
        const Value r = residual(i, integrals);
        steps[i] = iteration == 0 ? (1 / center) * r : (rho * last_rho) * steps[i] + (2 * rho / radius) * r;
        next[i] = m_values[i] + steps[i];
      });
      m_values.swap(next);
    }
  }

  // that of a row of M x = b, divided by the diagonal; 0 where there is no area
  Value residual(const std::size_t i, const std::vector<Value>& integrals) const
  {
    double diagonal = 0;
    Value sum;
    m_nodes.for_each_corner(i, [&](Index c) {
      const std::size_t f = c / 3;
      const std::array<Index, 3> nodes = m_nodes.of_face(f);
      const Value of_face = m_values[nodes[0]] + m_values[nodes[1]] + m_values[nodes[2]];
      sum += integrals[c] - (m_weights[f] / 12) * (m_values[i] + of_face);
      diagonal += m_weights[f] / 6;
    });
    return diagonal >= (std::numeric_limits<double>::min)() ? (1 / diagonal) * sum : Value();
  }

  void clamp(const std::size_t i)
  {
    Value min = sample(i), max = min;
    m_nodes.for_each_corner(i, [&](Index c) {
      for_each_sample(m_samples, c / 3, [&](const Coordinates&, const Value& value) {
        for(std::size_t k = 0; k < Value::dimension; ++k)
        {
          min[k] = (std::min)(min[k], value[k]);
          max[k] = (std::max)(max[k], value[k]);
        }
      });
    });
    for(std::size_t k = 0; k < Value::dimension; ++k)
      m_values[i][k] = (std::min)((std::max)(m_values[i][k], min[k]), max[k]);
  }

  // Ensures that the mean difference to the samples is not larger than with the samples at the nodes as values. As long as
  // it is, these values are restored at the nodes of the faces with larger differences.
  template <typename ConcurrencyTag>
  void take_back_harm(const std::vector<Value>& sampled)
  {
    constexpr int most_rounds = 10;
    const std::vector<double> before = deviations<ConcurrencyTag>(sampled);
    const double total_before = std::accumulate(before.begin(), before.end(), 0.);
    for(int round = 0; round < most_rounds; ++round)
    {
      const std::vector<double> after = deviations<ConcurrencyTag>(m_values);
      if(std::accumulate(after.begin(), after.end(), 0.) <= total_before)
        return;
      for_each_index<ConcurrencyTag>(m_nodes.size(), [&](std::size_t i) {
        m_nodes.for_each_corner(i, [&](Index c) {
          if(!(after[c / 3] <= before[c / 3]))
            m_values[i] = sampled[i];
        });
      });
    }
    m_values = sampled;
  }

  // the integrals of the differences to the samples over the faces
  template <typename ConcurrencyTag>
  std::vector<double> deviations(const std::vector<Value>& values) const
  {
    std::vector<double> result(m_mesh.number_of_faces());
    for_each_index<ConcurrencyTag>(result.size(), [&](std::size_t f) {
      const std::array<Index, 3> nodes = m_nodes.of_face(f);
      double sum = 0;
      for_each_sample(m_samples, f, [&](const Coordinates& x, const Value& value) {
        sum += norm(interpolate(values[nodes[0]], values[nodes[1]], values[nodes[2]], x.u, x.v) - value);
      });
      result[f] = weight_of_sample(f) * sum;
    });
    return result;
  }

  const Mesh_arrays& m_mesh;
  const Signal_samples<Value>& m_samples;
  const Corner_nodes m_nodes;
  std::vector<double> m_weights;
  std::vector<Value> m_values;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIT_SIGNAL_H
