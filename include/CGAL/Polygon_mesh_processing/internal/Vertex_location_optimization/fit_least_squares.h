// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIT_LEAST_SQUARES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIT_LEAST_SQUARES_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/sample_both_surfaces.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// The normal equations of a vertex: H d = g for its displacement d.
class Normal_equations
{
public:
  // A row: the surfaces agree in the direction `n` if the point that takes the part `lambda` in the displacement moves
  // by `residual`.
  void add_row(const double weight, const double lambda, const Vector& n, const double residual)
  {
    const Eigen::Vector3d m(n.x(), n.y(), n.z());
    m_H += (weight * lambda * lambda) * m * m.transpose();
    m_g += (weight * lambda * residual) * m;
  }

  // Pulls the vertex by `pull` along the surface: orthogonally to the direction in which the rows say most.
  void add_tangential_pull(const double weight, const Vector& pull)
  {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(m_H);
    const Eigen::Vector3d normal = eigen.eigenvectors().col(2); // of the largest eigenvalue
    const Eigen::Matrix3d tangential = Eigen::Matrix3d::Identity() - normal * normal.transpose();
    m_H += weight * tangential;
    m_g += weight * tangential * Eigen::Vector3d(pull.x(), pull.y(), pull.z());
  }

  // `regularization` is small beside the weights
  Vector solve(const double regularization) const
  {
    const Eigen::Vector3d d = (m_H + regularization * Eigen::Matrix3d::Identity()).ldlt().solve(m_g);
    return Vector(d[0], d[1], d[2]);
  }

  double right_hand_side() const { return m_g.norm(); }

private:
  Eigen::Matrix3d m_H = Eigen::Matrix3d::Zero();
  Eigen::Vector3d m_g = Eigen::Vector3d::Zero();
};

// Adds the rows of the samples in the face of the corner c at vertex i. With the weights 1/20 at the vertices, 2/15 at
// the midpoints and 9/20 at the barycenter they integrate cubics exactly.
template <typename Foot>
void add_rows(const Optimization_state<Foot>& state,
              const Two_sided_samples<Foot>& samples,
              const std::size_t i,
              const Index c,
              const double area,
              Normal_equations& equations)
{
  const Mesh_arrays& mesh = state.mesh;
  const Index f = c / 3;
  const Point& v = mesh.points[i];

  const Vector& n = state.vertex_normals[i];
  equations.add_row(area / 20, 1, n, n * (state.vertex_samples[i] - v));

  for(Index other : { Mesh_arrays::next(c), Mesh_arrays::previous(c) })
  {
    const Index e = mesh.opposite_edge(other == Mesh_arrays::next(c) ? Mesh_arrays::previous(c) : Mesh_arrays::next(c));
    const Vector& n_m = samples.midpoint_normals[e];
    equations.add_row(area * 2 / 15, 0.5, n_m,
                      n_m * (state.midpoint_samples[e] - midpoint(v, mesh.points[mesh.vertex(other)])));
  }

  const std::array<Point, 3> t = mesh.triangle(f);
  const Vector& n_b = samples.barycenter_normals[f];
  equations.add_row(area * 9 / 20, 1. / 3, n_b, n_b * (samples.barycenter_samples[f] - centroid(t[0], t[1], t[2])));

  for(Index k = samples.first_of_face[f]; k < samples.first_of_face[f + 1]; ++k)
  {
    const Reference_sample& sample = samples.of_reference[samples.by_face[k]];
    const std::array<double, 3> lambda = sample.foot.coordinates.barycentric();
    const Vector d = sample.point - point_at(t, sample.foot.coordinates);
    // inside the face the reference's normal, on its boundary the direction to the sample
    const bool is_inside = *std::min_element(lambda.begin(), lambda.end()) > 1e-12;
    const Vector direction = is_inside ? Vector(NULL_VECTOR) : normalized(d);
    const Vector& n_y = direction != NULL_VECTOR ? direction : sample.normal;
    equations.add_row(sample.area, lambda[c % 3], n_y, n_y * d);
  }
}

// From v to the apex of the equilateral triangle over the side pq, less the farther it is: what is far from regular
// should come nearer, but need not get there.
inline Vector pull_to_equilateral(const Point& v, const Point& p, const Point& q)
{
  const Vector side = q - p;
  const double length2 = side.squared_length();
  if(!(length2 > 0))
    return NULL_VECTOR;
  const Vector from_middle = v - midpoint(p, q);
  const Vector height = normalized(from_middle - ((from_middle * side) / length2) * side);
  const Vector pull = std::sqrt(0.75 * length2) * height - from_middle;
  return pull / (1 + 3 * norm(pull) / std::sqrt(length2));
}

// Moves each free vertex towards the least squares fit of its faces to the samples of both surfaces, its neighbors held
// fixed. The equations of the vertices are solved independently of each other, hence the relaxation factor; part of the
// last displacement is repeated to get there sooner. A vertex whose samples fit stays.
template <typename ConcurrencyTag, typename Foot>
void fit_least_squares(Optimization_state<Foot>& state,
                       const Two_sided_samples<Foot>& samples,
                       const double regularity_weight)
{
  constexpr double relaxation = 0.7, momentum = 0.5, max_step = 0.25; // max_step relative to the mean edge length

  const Mesh_arrays& mesh = state.mesh;
  for_each_index<ConcurrencyTag>(mesh.points.size(), [&](std::size_t i)
  {
    const Point& v = mesh.points[i];
    const Vector last_step = v - state.targets[i];
    state.targets[i] = v;
    if(!state.is_free(i))
      return;

    Normal_equations equations;
    double area = 0;
    Vector pull = NULL_VECTOR;
    std::size_t number_of_faces = 0;
    state.for_each_corner(i, [&](Index c)
    {
      const double area_of_face = norm(mesh.area_normal(c / 3)) / 2;
      add_rows(state, samples, i, c, area_of_face, equations);
      pull = pull + pull_to_equilateral(v, mesh.points[mesh.vertex(Mesh_arrays::next(c))],
                                        mesh.points[mesh.vertex(Mesh_arrays::previous(c))]);
      area += area_of_face;
      ++number_of_faces;
    });
    if(!(area > 0) || equations.right_hand_side() <= 1e-9 * area * state.mean_edge_length)
      return;

    equations.add_tangential_pull(regularity_weight * area / 2, pull / (2. * number_of_faces));
    const Vector step = relaxation * equations.solve(1e-9 * area) + momentum * last_step;
    const double length = norm(step), limit = max_step * state.mean_edge_length;
    state.targets[i] = v + (length > limit ? (limit / length) * step : step);
  });
}

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIT_LEAST_SQUARES_H
