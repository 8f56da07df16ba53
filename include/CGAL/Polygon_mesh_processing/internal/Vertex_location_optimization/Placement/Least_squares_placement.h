// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIT_LEAST_SQUARES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FIT_LEAST_SQUARES_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_sum_over_faces.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Sampling/Area_samples.h>

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
  Normal_equations() = default;

  // Those of a sample at the vertex: along `normal` it should move by `offset`, from the remesh to the reference. `area` is
  // what the sample stands for. Reweighting makes the squares the power 3/2 of the distances, but for the smallest: that
  // lowers the mean distance at the same regularity, as a few bad places count for less.
  Normal_equations(const Vector& normal, const Vector& offset, const double area, const double mean_edge_length)
  {
    constexpr double smallest_residual = 0.001; // relative to the mean edge length
    const double residual = normal * offset;
    const double weight = area / std::sqrt(smallest_residual + std::abs(residual) / mean_edge_length);
    const Vector m = weight * normal;
    m_H = { m.x() * normal.x(), m.x() * normal.y(), m.x() * normal.z(),
            m.y() * normal.y(), m.y() * normal.z(), m.z() * normal.z() };
    m_g = residual * m;
  }

  // adds those of a sample of whose displacement the vertex makes the part `lambda`
  void add(const Normal_equations& of_sample, const double lambda)
  {
    for(int k = 0; k < 6; ++k)
      m_H[k] += lambda * lambda * of_sample.m_H[k];
    m_g = m_g + lambda * of_sample.m_g;
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

    // a direction about which the rows say half of what they say about the best known one is not pulled
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

private:
  Diagonalize_traits::Covariance_matrix m_H{ { 0, 0, 0, 0, 0, 0 } }; // the upper triangle, row by row
  Vector m_g = NULL_VECTOR;
};

// What the faces at a vertex say to it.
struct Vertex_equations
{
  Normal_equations of_faces;
  double area = 0; // of these faces
  std::size_t number_of_faces = 0;

  Vertex_equations& operator+=(const Vertex_equations& other)
  {
    of_faces += other.of_faces;
    area += other.area;
    number_of_faces += other.number_of_faces;
    return *this;
  }
};

// What the samples in face f, but for those at its vertices, say to each of its vertices. With the weights 1/20 at the
// vertices, 2/15 at the midpoints and 9/20 at the barycenter they integrate cubics exactly.
template <typename Hint>
std::array<Vertex_equations, 3> face_equations(const Optimization_state<Hint>& state,
                                               const Samples_of_reference& of_reference,
                                               const std::size_t f)
{
  const std::array<Point, 3> t = state.mesh.triangle(f);
  const double area = state.mesh.area(f), length = state.mean_edge_length;
  std::array<Normal_equations, 3> equations;
  for(int k = 0; k < 3; ++k)
  {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const Index e = state.mesh.face_edges[f][k];
    const Normal_equations of_midpoint(state.midpoint_samples.normal(e), state.midpoint_samples.offset(e), area * 2 / 15,
                                       length);
    equations[i].add(of_midpoint, 0.5);
    equations[j].add(of_midpoint, 0.5);
  }

  const Normal_equations of_barycenter(state.barycenter_samples.normal(f), state.barycenter_samples.offset(f),
                                       area * 9 / 20, length);
  for(Normal_equations& of_corner : equations)
    of_corner.add(of_barycenter, 1. / 3);

  for(Index s = of_reference.first_of_face[f]; s < of_reference.first_of_face[f + 1]; ++s)
  {
    const Index i = of_reference.by_face[s];
    const Reference_sample& sample = of_reference.samples[i];
    const std::array<double, 3> lambda = sample.foot.coordinates.barycentric();
    const Vector offset = sample.point - point_at(t, sample.foot.coordinates);
    // inside the face the reference's normal, on its boundary the direction to the sample
    const bool is_inside = *std::min_element(lambda.begin(), lambda.end()) > 1e-12;
    const Vector direction = is_inside ? Vector(NULL_VECTOR) : normalized(offset);
    const Normal_equations of_sample(direction != NULL_VECTOR ? direction : of_reference.normals[i], offset,
                                     of_reference.area, length);
    for(int k = 0; k < 3; ++k)
      equations[k].add(of_sample, lambda[k]);
  }
  return { { { equations[0], area, 1 }, { equations[1], area, 1 }, { equations[2], area, 1 } } };
}

// How far and where v should move for the triangle v, p, q to become more regular; `length` is that of the sides of the
// triangles around. Two things are added: the way to the apex of the equilateral triangle over pq, less the farther it is
// (what is far from regular should come nearer, but need not get there); and the direction in which the smallest angle
// grows the fastest, or rather a mean of the three angles with weights that fall with the lengths of the opposite sides.
inline Vector pull_to_regular(const Point& v, const Point& p, const Point& q, const double length)
{
  constexpr double apex_part = 1. / 4, angle_part = 1. / 6; // with twice as much of the second the iterations do not settle

  const Vector side = q - p, from_p = v - p, from_q = v - q;
  const Vector normal = normalized(cross_product(side, from_p));
  const std::array<double, 3> lengths2{ side.squared_length(), from_q.squared_length(), from_p.squared_length() };
  const double shortest2 = *std::min_element(lengths2.begin(), lengths2.end());
  if(normal == NULL_VECTOR || !(shortest2 > 0))
    return NULL_VECTOR;

  const Vector to_apex = (std::sqrt(3.) / 2) * cross_product(normal, side) - (from_p + from_q) / 2;

  std::array<double, 3> weights; // of the angles at v, p, q
  double sum_of_weights = 0;
  for(int k = 0; k < 3; ++k)
  {
    weights[k] = square(square(square(shortest2 / lengths2[k])));
    sum_of_weights += weights[k];
  }
  // by the gradients of the angles at p and q; that at v shrinks by as much as they grow
  const Vector gradient = ((weights[1] - weights[0]) / lengths2[2]) * cross_product(normal, from_p) -
                          ((weights[2] - weights[0]) / lengths2[1]) * cross_product(normal, from_q);

  return (apex_part / (1 + 3 * norm(to_apex) / std::sqrt(lengths2[0]))) * to_apex +
         (angle_part * square(length) / sum_of_weights) * gradient;
}

// Moves each free vertex towards the least squares fit of its faces to the samples of both surfaces, its neighbors held
// fixed. The equations of the vertices are solved independently of each other, hence the relaxation factor; part of the
// last displacement is repeated to get there sooner. A vertex whose samples fit stays.
template <typename ConcurrencyTag, typename Hint>
void fit_least_squares(Optimization_state<Hint>& state,
                       const Samples_of_reference& of_reference,
                       const double regularity_weight)
{
  constexpr double relaxation = 1.4, momentum = 0.5, max_step = 0.25; // max_step relative to the mean edge length

  const Mesh_arrays& mesh = state.mesh;
  const double equilateral_area = std::sqrt(3.) / 4 * square(state.mean_edge_length);
  const auto equations_of_face = [&](std::size_t f) { return face_equations(state, of_reference, f); };
  for_each_sum_over_faces<ConcurrencyTag, Vertex_equations>(state, equations_of_face,
                                                            [&](std::size_t i, const Vertex_equations& of_vertex)
  {
    const Point& v = mesh.points[i];
    const Vector last_step = v - state.targets[i];
    state.targets[i] = v;
    const double area = of_vertex.area;
    if(!state.is_free(i) || !(area > 0))
      return;

    Normal_equations equations = of_vertex.of_faces;
    equations += Normal_equations(state.vertex_samples.normal(i), state.vertex_samples.offset(i), area / 20,
                                  state.mean_edge_length);
    if(norm(equations.right_hand_side()) <= 1e-9 * area * state.mean_edge_length)
      return;

    Vector pull = NULL_VECTOR;
    const double side = std::sqrt(area / of_vertex.number_of_faces * 4 / std::sqrt(3.)); // if the faces were equilateral
    state.for_each_corner(i, [&](Index c)
    {
      pull = pull + pull_to_regular(v, mesh.points[mesh.vertex(Mesh_arrays::next(c))],
                                    mesh.points[mesh.vertex(Mesh_arrays::previous(c))], side);
    });

    // all faces weigh the same here, as in the mean of their angles
    const double pull_weight = regularity_weight * of_vertex.number_of_faces * equilateral_area;
    const Vector d = equations.solve(pull / of_vertex.number_of_faces, pull_weight, 1e-9 * area);
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
