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

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/Error_integral.h>
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
// vertices at `points`, leads closer: from a foot on the boundary of its face to all faces around. `Reference_patches` walks across sides alone, from
// patch to patch; here each step is cheap, and the faces fold more.
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

// The faces with the vertices at `points`, for closest points; those of the surroundings follow.
inline Patch_tree<Flat_triangle> make_face_tree(const Remesh& remesh, const std::vector<Point>& points)
{
  std::vector<Flat_triangle> triangles;
  triangles.reserve(remesh.number_of_faces() + remesh.surroundings.number_of_faces());
  for(std::size_t f = 0; f < remesh.number_of_faces(); ++f)
    triangles.emplace_back(remesh.triangle(f, points));
  for(std::size_t f = 0; f < remesh.surroundings.number_of_faces(); ++f)
    triangles.emplace_back(remesh.surroundings.triangle(f));
  return Patch_tree<Flat_triangle>(std::move(triangles));
}

// The largest distance from the reference to the faces in `tree`, of `points` and of the points to which climbing from those
// with the largest of `distances` leads, but for negative ones. `face(i)` is a face near to point i.
template <typename Reference, typename Face>
double largest_distance_from(const Reference& reference,
                             const Patch_tree<Flat_triangle>& tree,
                             const std::vector<Point>& points,
                             const std::vector<double>& distances,
                             const Face& face)
{
  constexpr std::size_t max_samples = 256; // it trades time for a maximum that is elsewhere
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index(0));
  const auto end = order.begin() + (std::min)(max_samples, order.size());
  std::partial_sort(order.begin(), end, order.end(),
                    [&](Index i, Index j) { return distances[i] != distances[j] ? distances[i] > distances[j] : i < j; });
  double largest = 0;
  for(auto i = order.begin(); i != end && distances[*i] >= 0; ++i)
  {
    const auto height_of_point = [&](const Point& p) { return norm(p - tree.point(tree.project(p, face(*i)))); };
    const auto height = [&](const auto& foot) { return height_of_point(reference.point(foot)); };
    const auto top = reference.climb(reference.project(points[*i]), height);
    largest = (std::max)({ largest, height_of_point(points[*i]), height(top) });
  }
  return largest;
}

// what a sample at this distance adds, which stands for the area `weight`
inline Error_integral integral_of_sample(const double weight, const double distance)
{
  return { weight, weight * distance, weight * square(distance), distance };
}

// Points of the reference, each with the face of the remesh that is closest.
struct Points_and_faces
{
  std::vector<Point> points;
  std::vector<float> weights; // the areas that they stand for, in any unit
  std::vector<Index> faces;
};

// Points spread over the reference, as densely as the faces of the remesh, each with the closest point of the remesh, in the
// order of the faces that these were in at first: most stay there. There are none if the reference cannot be sampled.
class Area_samples
{
public:
  // Takes the samples; returns the distance from the reference. `hint(f)` is a foot of face f on the reference.
  template <typename ConcurrencyTag, typename Reference, typename HintOfFace>
  Approximation_error start(const Reference& reference, const Remesh& remesh, const HintOfFace& hint)
  {
    constexpr std::size_t samples_per_face = 6; // of the remesh; they take most of the time and memory of the fit
    const Index number_of_faces = static_cast<Index>(remesh.number_of_faces());
    const double number_of_triangles = remesh.total_weight() + remesh.surroundings.total_weight();
    const std::size_t n = samples_per_face * static_cast<std::size_t>(std::round(number_of_triangles));
    m_area = reference.area() / n;
    if(m_area > 0)
    {
      m_points.reserve(n);
      m_normals.reserve(n);
      m_weights.reserve(n);
      // where faces are large, on thin parts, say, samples are as close as on an average
      const auto squared_length = [&](std::size_t f) { return square(remesh.length_of_face(f)); };
      const double mean =
        sum_over_indices<ConcurrencyTag, double>(number_of_faces, squared_length) / static_cast<double>(number_of_faces);
      const auto area = [&](std::size_t f) { return (std::min)(squared_length(f), mean); };
      reference.for_each_area_sample(n, number_of_faces, hint, area, [&](const auto& foot, double area_of_sample) {
        m_points.push_back(reference.point(foot));
        m_normals.push_back(reference.normal(foot));
        m_weights.push_back(static_cast<float>(area_of_sample / m_area));
      });
    }

    m_travels.assign(number_of_faces, 0);
    if(m_points.empty())
    {
      group_by_face(number_of_faces);
      return {};
    }
    std::vector<Index> faces(m_points.size());
    const Approximation_error error = find_closest_faces<ConcurrencyTag>(reference, remesh, faces);
    // what is closest to the surroundings comes last, and is left out
    const auto group_of = [&](Index i) { return (std::min)(faces[i], number_of_faces); };
    std::vector<Index> order = Index_groups(number_of_faces + 1, faces.size(), group_of).members();
    order.resize(std::count_if(faces.begin(), faces.end(), [&](Index f) { return f < number_of_faces; }));
    permute(m_points, order);
    permute(m_normals, order);
    permute(m_weights, order);
    m_feet.resize(order.size());
    for_each_index<ConcurrencyTag>(m_feet.size(), [&](std::size_t i) {
      const Index face = faces[order[i]];
      m_feet[i] = { face, closest_on_triangle(remesh.triangle(face), m_points[i]) };
    });
    group_by_face(number_of_faces);
    return error;
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
        walk_to_closest_point(remesh, remesh.points, m_points[i], m_feet[i]);
    });
    group_by_face(remesh.number_of_faces());
  }

  // the points, and the faces that are closest to them, for good
  Points_and_faces take() &&
  {
    Points_and_faces result{ std::move(m_points), std::move(m_weights), std::vector<Index>(m_feet.size()) };
    std::transform(m_feet.begin(), m_feet.end(), result.faces.begin(), [](const Patch_foot& foot) { return foot.patch; });
    return result;
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
  // Finds the faces of the remesh, or of its surroundings, that are closest; returns the distance from the reference to the
  // former. Neighbors among the samples follow each other: the face of one is a hint for the next.
  template <typename ConcurrencyTag, typename Reference>
  Approximation_error find_closest_faces(const Reference& reference, const Remesh& remesh, std::vector<Index>& faces) const
  {
    const Patch_tree<Flat_triangle> tree = make_face_tree(remesh, remesh.points);
    std::vector<double> distances(faces.size());
    constexpr std::size_t block_size = 64;
    constexpr double of_surroundings = -1;
    for_each_block<ConcurrencyTag>(faces.size(), block_size, [&](std::size_t begin, std::size_t end) {
      Index hint = no_index;
      for(std::size_t i = begin; i < end; ++i)
      {
        const Patch_foot foot = tree.project(m_points[i], hint);
        faces[i] = hint = foot.patch;
        distances[i] = foot.patch < remesh.number_of_faces() ? norm(m_points[i] - tree.point(foot)) : of_surroundings;
      }
    });
    const auto integral = sum_over_indices<ConcurrencyTag, Error_integral>(faces.size(), [&](std::size_t i) {
      return distances[i] < 0 ? Error_integral() : integral_of_sample(m_weights[i], distances[i]);
    });
    Approximation_error error = integral.error();
    error.max = largest_distance_from(reference, tree, m_points, distances, [&](Index i) { return faces[i]; });
    return error;
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
