// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIT_LEAST_SQUARES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIT_LEAST_SQUARES_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Samples_of_reference.h>

#include <CGAL/Default_diagonalize_traits.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// The normal equations of a vertex, H d = g, for its displacement d.
class Normal_equations
{
  using Diagonalize_traits = Default_diagonalize_traits<double, 3>;

public:
  // A row: the surfaces agree in the direction `n` if the point that takes the part `lambda` in the displacement moves
  // by `residual`.
  void add_row(const double weight, const double lambda, const Vector& n, const double residual)
  {
    const Vector m = (weight * lambda * lambda) * n;
    m_H[0] += m.x() * n.x();
    m_H[1] += m.x() * n.y();
    m_H[2] += m.x() * n.z();
    m_H[3] += m.y() * n.y();
    m_H[4] += m.y() * n.z();
    m_H[5] += m.z() * n.z();
    m_g = m_g + (weight * lambda * residual) * n;
  }

  Normal_equations& operator+=(const Normal_equations& other)
  {
    for(int k = 0; k < 6; ++k)
      m_H[k] += other.m_H[k];
    m_g = m_g + other.m_g;
    return *this;
  }

  // The solution if the vertex is pulled, too, in the directions in which the rows say little: along a smooth surface,
  // but not across a crease. `epsilon` is small beside the weights and keeps the system regular.
  Vector solve(const Vector& pull, const double pull_weight, const double epsilon) const
  {
    Diagonalize_traits::Vector h; // the eigenvalues, in increasing order
    Diagonalize_traits::Matrix e;
    if(!Diagonalize_traits::diagonalize_selfadjoint_covariance_matrix(m_H, h, e) || !(h[2] > 0))
      return NULL_VECTOR;

    // a direction about which the rows say a quarter of what they say about the best known one is not pulled
    constexpr double softness = 4;
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

private:
  Diagonalize_traits::Covariance_matrix m_H{ { 0, 0, 0, 0, 0, 0 } }; // the upper triangle, row by row
  Vector m_g = NULL_VECTOR;
};

// What the samples in face f, but for those at its vertices, say to each of its vertices. With the weights 1/20 at the
// vertices, 2/15 at the midpoints and 9/20 at the barycenter they integrate cubics exactly.
template <typename Foot>
std::array<Normal_equations, 3> face_equations(const Optimization_state<Foot>& state,
                                               const Samples_of_reference& of_reference,
                                               const std::size_t f,
                                               const double area)
{
  const std::array<Point, 3> t = state.mesh.triangle(f);
  std::array<Normal_equations, 3> equations;
  for(int k = 0; k < 3; ++k)
  {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const Index e = state.mesh.face_edges[f][k];
    const Vector& n = state.midpoint_samples.normals[e];
    const double residual = n * (state.midpoint_samples.points[e] - midpoint(t[i], t[j]));
    equations[i].add_row(area * 2 / 15, 0.5, n, residual);
    equations[j].add_row(area * 2 / 15, 0.5, n, residual);
  }

  const Vector& n = state.barycenter_samples.normals[f];
  const double residual = n * (state.barycenter_samples.points[f] - centroid(t[0], t[1], t[2]));
  for(Normal_equations& of_corner : equations)
    of_corner.add_row(area * 9 / 20, 1. / 3, n, residual);

  for(Index s = of_reference.first_of_face[f]; s < of_reference.first_of_face[f + 1]; ++s)
  {
    const Reference_sample& sample = of_reference.samples[of_reference.by_face[s]];
    const std::array<double, 3> lambda = sample.foot.coordinates.barycentric();
    const Vector d = sample.point - point_at(t, sample.foot.coordinates);
    // inside the face the reference's normal, on its boundary the direction to the sample
    const bool is_inside = *std::min_element(lambda.begin(), lambda.end()) > 1e-12;
    const Vector direction = is_inside ? Vector(NULL_VECTOR) : normalized(d);
    const Vector& n_y = direction != NULL_VECTOR ? direction : sample.normal;
    for(int k = 0; k < 3; ++k)
      equations[k].add_row(of_reference.area, lambda[k], n_y, n_y * d);
  }
  return equations;
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
                       const Samples_of_reference& of_reference,
                       const double regularity_weight)
{
  constexpr double relaxation = 0.7, momentum = 0.5, max_step = 0.25; // max_step relative to the mean edge length

  const Mesh_arrays& mesh = state.mesh;
  std::vector<double> areas(mesh.faces.size());
  std::vector<std::array<Normal_equations, 3>> of_faces(mesh.faces.size());
  for_each_index<ConcurrencyTag>(of_faces.size(), [&](std::size_t f)
  {
    areas[f] = mesh.area(f);
    of_faces[f] = face_equations(state, of_reference, f, areas[f]);
  });

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
      equations += of_faces[c / 3][c % 3];
      pull = pull + pull_to_equilateral(v, mesh.points[mesh.vertex(Mesh_arrays::next(c))],
                                        mesh.points[mesh.vertex(Mesh_arrays::previous(c))]);
      area += areas[c / 3];
      ++number_of_faces;
    });
    const Vector& n = state.vertex_samples.normals[i];
    equations.add_row(area / 20, 1, n, n * (state.vertex_samples.points[i] - v));
    if(!(area > 0) || norm(equations.right_hand_side()) <= 1e-9 * area * state.mean_edge_length)
      return;

    const Vector d = equations.solve(pull / (2. * number_of_faces), regularity_weight * area / 2, 1e-9 * area);
    const Vector step = relaxation * d + momentum * last_step;
    const double length = norm(step), limit = max_step * state.mean_edge_length;
    state.targets[i] = v + (length > limit ? (limit / length) * step : step);
  });
}

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIT_LEAST_SQUARES_H
