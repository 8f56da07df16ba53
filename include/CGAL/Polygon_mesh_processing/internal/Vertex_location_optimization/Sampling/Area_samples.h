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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_AREA_SAMPLES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_AREA_SAMPLES_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Flat_triangle.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Patch_tree.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Moves `foot`, a point of a mesh by its face, to the point closest to `query` as far as walking from face to face, with the
// vertices at `points`, leads closer: from a foot on the boundary of its face to all faces around. `Reference_patches` walks
// across sides alone, from patch to patch; here each step is cheap, and the faces fold more.
inline void
walk_to_closest_point(const Remesh& remesh, const std::vector<Point>& points, const Point& query, Patch_foot& foot)
{
  foot.coordinates = closest_on_triangle(remesh.triangle(foot.patch, points), query);
  double distance = squared_distance(query, point_at(remesh.triangle(foot.patch, points), foot.coordinates));
  for(bool is_closer = true; is_closer;)
  {
    is_closer = false;
    const std::array<double, 3> lambda = foot.coordinates.barycentric();
    if(is_inside(lambda))
      return;
    const std::array<Index, 3> face = remesh.face(foot.patch);
    for(int k = 0; k < 3; ++k)
      if(lambda[k] > boundary_tolerance)
        remesh.for_each_corner(face[k], [&](Index c) {
          const std::array<Point, 3> t = remesh.triangle(c / 3, points);
          const Coordinates x = closest_on_triangle(t, query);
          const double d = squared_distance(query, point_at(t, x));
          if(d < distance)
          {
            distance = d;
            foot = { c / 3, x };
            is_closer = true;
          }
        });
  }
}

// The same point of the mesh, in the first of the faces that it is on the boundary of: rounding chooses among them. The fans
// of polygons overlap, so that there is no such order.
inline Patch_foot in_first_face(const Remesh& remesh, const Patch_foot& foot)
{
  if(remesh.has_polygons())
    return foot;
  const std::array<double, 3> lambda = foot.coordinates.barycentric();
  const auto is_on_side = [&](int k) { return lambda[k] <= boundary_tolerance; };
  Index first = 3 * foot.patch;
  std::array<double, 3> mu = lambda;
  const auto take_if_first = [&](Index corner, double at_corner, double at_next) {
    if(corner / 3 >= first / 3)
      return;
    first = corner;
    mu[corner % 3] = at_corner;
    mu[(corner + 1) % 3] = at_next;
    mu[(corner + 2) % 3] = 1 - at_corner - at_next;
  };
  for(int k = 0; k < 3; ++k)
    if(is_on_side((k + 1) % 3) && is_on_side((k + 2) % 3))
      remesh.for_each_corner(remesh.face(foot.patch)[k], [&](Index c) { take_if_first(c, 1, 0); });
    else if(is_on_side(k)) // the common edge runs the other way in the other face
    {
      const Index across = remesh.corner_across(3 * foot.patch + k);
      if(across != no_index)
        take_if_first(across, 0, lambda[(k + 2) % 3]);
    }
  return { first / 3, { mu[1], mu[2] } };
}

inline void add_faces(const Mesh_arrays& mesh, const std::vector<Point>& points, std::vector<Flat_triangle>& triangles)
{
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    triangles.emplace_back(mesh.triangle(f, points));
}

// The faces of a mesh, for closest points.
inline Patch_tree<Flat_triangle> make_face_tree(const Mesh_arrays& mesh)
{
  std::vector<Flat_triangle> triangles;
  triangles.reserve(mesh.number_of_faces());
  add_faces(mesh, mesh.points, triangles);
  return Patch_tree<Flat_triangle>(std::move(triangles));
}

// The faces with the vertices at `points`; those of the surroundings follow.
inline Patch_tree<Flat_triangle> make_face_tree(const Remesh& remesh, const std::vector<Point>& points)
{
  std::vector<Flat_triangle> triangles;
  triangles.reserve(remesh.number_of_faces() + remesh.surroundings.number_of_faces());
  add_faces(remesh, points, triangles);
  add_faces(remesh.surroundings, remesh.surroundings.points, triangles);
  return Patch_tree<Flat_triangle>(std::move(triangles));
}

// Takes points spread over a reference, as densely as the faces of the remesh: calls f(foot, area) for each of some n, which
// stands for that area. `hint(f)` is a foot of face f on the reference.
template <typename ConcurrencyTag, typename Reference, typename HintOfFace, typename F>
void take_area_samples(
  const Reference& reference, const Remesh& remesh, const std::size_t n, const HintOfFace& hint, const F& f)
{
  const std::size_t number_of_faces = remesh.number_of_faces();
  // where faces are large, for example on thin parts, samples are as dense as on average
  const auto squared_length = [&](std::size_t k) { return square(remesh.length_of_face(k)); };
  const double mean =
    sum_over_indices<ConcurrencyTag, double>(number_of_faces, squared_length) / static_cast<double>(number_of_faces);
  const auto area = [&](std::size_t k) { return (std::min)(squared_length(k), mean); };
  reference.for_each_area_sample(n, number_of_faces, hint, area, f);
}

// Calls f(i, foot) for each of n points, with the closest point of the faces in `tree`. Neighbors among the points follow
// each other: the face of one is a hint for the next.
template <typename ConcurrencyTag, typename PointAt, typename F>
void project_to_faces(const Patch_tree<Flat_triangle>& tree, const std::size_t n, const PointAt& point, const F& f)
{
  constexpr std::size_t block_size = 64;
  for_each_block<ConcurrencyTag>(n, block_size, [&](std::size_t begin, std::size_t end) {
    Index hint = no_index;
    for(std::size_t i = begin; i < end; ++i)
    {
      const Patch_foot foot = tree.project(point(i), hint);
      hint = foot.patch;
      f(i, foot);
    }
  });
}

// Points spread over the reference, as densely as the faces of the remesh, each with the closest point of the remesh, in the
// order of the faces that these were in at first: most stay there. There are none if the reference cannot be sampled.
class Area_samples
{
public:
  // Takes the samples, in place of those that there may be. `hint(f)` is a foot of face f on the reference.
  template <typename ConcurrencyTag, typename Reference, typename HintOfFace>
  void start(const Reference& reference, const Remesh& remesh, const HintOfFace& hint)
  {
    m_feet = std::vector<Patch_foot>(); // frees memory for the tree of the faces
    m_samples_of_faces = Index_groups();
    take<ConcurrencyTag>(reference, remesh, hint);
    m_travels.assign(remesh.number_of_faces(), 0);
    if(!m_points.empty())
      project<ConcurrencyTag>(remesh);
    group_by_face(remesh.number_of_faces());
  }

  // Finds the closest points for `remesh.points` from the last ones, but keeps those on faces whose vertices have gone no
  // farther than `tolerance` since, relative to the lengths of their edges.
  template <typename ConcurrencyTag>
  void update(const Remesh& remesh, const double tolerance)
  {
    for_each_index<ConcurrencyTag>(remesh.number_of_faces(), [&](std::size_t f) {
      if(m_travels[f] > tolerance) // its samples were searched in the last iteration
        m_travels[f] = 0;
      const auto displacement = [&](int k) { return norm(remesh.last_displacement(remesh.face(f)[k])); };
      m_travels[f] += (std::max)({ displacement(0), displacement(1), displacement(2) }) / remesh.length_of_face(f);
    });
    for_each_index<ConcurrencyTag>(m_points.size(), [&](std::size_t i) {
      if(m_travels[m_feet[i].patch] > tolerance)
      {
        walk_to_closest_point(remesh, remesh.points, m_points[i], m_feet[i]);
        m_feet[i] = in_first_face(remesh, m_feet[i]);
      }
    });
    group_by_face(remesh.number_of_faces());
  }

  // calls f(point, normal, area, coordinates) for each sample whose closest point is in the face, with the area of the
  // reference that it stands for and the coordinates of the closest point
  template <typename F>
  void for_each_in_face(std::size_t face, const F& f) const
  {
    m_samples_of_faces.for_each(
      face, [&](Index i) { f(m_points[i], m_normals[i], m_weights[i] * m_area, m_feet[i].coordinates); });
  }

private:
  template <typename ConcurrencyTag, typename Reference, typename HintOfFace>
  void take(const Reference& reference, const Remesh& remesh, const HintOfFace& hint)
  {
    constexpr std::size_t samples_per_face = 6; // of the remesh; they take most of the time and memory of the fit
    const double number_of_triangles = remesh.total_weight() + remesh.surroundings.total_weight();
    const std::size_t n = samples_per_face * static_cast<std::size_t>(std::round(number_of_triangles));
    if(!(m_area > 0)) // else it is known
      m_area = reference.area() / n;
    m_points.clear();
    m_normals.clear();
    m_weights.clear();
    if(!(m_area > 0))
      return;
    m_points.reserve(n);
    m_normals.reserve(n);
    m_weights.reserve(n);
    take_area_samples<ConcurrencyTag>(reference, remesh, n, hint, [&](const auto& foot, double area_of_sample) {
      m_points.push_back(reference.point(foot));
      m_normals.push_back(reference.normal(foot));
      m_weights.push_back(static_cast<float>(area_of_sample / m_area));
    });
  }

  // Finds the closest points of the remesh, and sorts the samples by their faces.
  template <typename ConcurrencyTag>
  void project(const Remesh& remesh)
  {
    const Index number_of_faces = static_cast<Index>(remesh.number_of_faces());
    std::vector<Index> faces(m_points.size());
    project_to_faces<ConcurrencyTag>(
      make_face_tree(remesh, remesh.points), m_points.size(), [&](std::size_t i) -> const Point& { return m_points[i]; },
      [&](std::size_t i, const Patch_foot& foot) { faces[i] = foot.patch; });
    // samples closest to the surroundings come last, and are left out
    const auto group_of = [&](Index i) { return (std::min)(faces[i], number_of_faces); };
    std::vector<Index> order = Index_groups(number_of_faces + 1, faces.size(), group_of).members();
    order.resize(std::count_if(faces.begin(), faces.end(), [&](Index f) { return f < number_of_faces; }));
    permute(m_points, order);
    permute(m_normals, order);
    permute(m_weights, order);
    m_feet.resize(order.size());
    for_each_index<ConcurrencyTag>(m_feet.size(), [&](std::size_t i) {
      const Index face = faces[order[i]];
      m_feet[i] = in_first_face(remesh, { face, closest_on_triangle(remesh.triangle(face), m_points[i]) });
    });
  }

  void group_by_face(const std::size_t number_of_faces)
  {
    m_samples_of_faces = Index_groups(number_of_faces, m_feet.size(), [&](Index i) { return m_feet[i].patch; });
  }

  template <typename T>
  static void permute(std::vector<T>& values, const std::vector<Index>& order)
  {
    std::vector<T> permuted;
    permuted.reserve(order.size());
    for(Index i : order)
      permuted.push_back(values[i]);
    values = std::move(permuted);
  }

  std::vector<Point> m_points;
  std::vector<Vector> m_normals;
  std::vector<Patch_foot> m_feet; // on the remesh: a patch is a face
  double m_area = 0;              // of the reference, that a sample stands for on an average
  std::vector<float> m_weights;   // the area that each sample stands for, relative to that
  Index_groups m_samples_of_faces;
  std::vector<double> m_travels; // how far the vertices of each face have gone since its samples were searched
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_AREA_SAMPLES_H
