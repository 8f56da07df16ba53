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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACE_SAMPLING_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACE_SAMPLING_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/walk_or_search.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/Quadratic_interpolant.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Reference_access.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Mesh_arrays.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/triangle_coordinates.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The distance of a face to the reference, by samples that are at the same places wherever its vertices are.
struct Face_distances
{
  double mean = 0;
  double mean_square = 0;
  double variance = 0; // of the mean, as the samples tell
  double max = 0;
};

// What is known of the closest points to the corners of a face and to the midpoints of the sides opposite to them.
template <typename Foot>
struct Face_sides
{
  double largest_distance() const
  {
    double result2 = 0;
    for(int k = 0; k < 3; ++k)
      result2 = (std::max)({ result2, offsets[k].squared_length(), midpoint_offsets[k].squared_length() });
    return std::sqrt(result2);
  }

  std::array<Foot, 3> feet, midpoint_feet;
  std::array<Vector, 3> offsets, midpoint_offsets; // to the closest points
};

// those of face f; samples have hint(i) and offset(i)
template <typename Foot, typename Samples>
Face_sides<Foot>
sides_of_face(const Mesh_arrays& mesh, const std::size_t f, const Samples& vertices, const Samples& midpoints)
{
  Face_sides<Foot> result;
  for(int k = 0; k < 3; ++k)
  {
    const Index i = mesh.face(f)[k], e = mesh.face_edges[f][k];
    result.feet[k] = vertices.hint(i);
    result.offsets[k] = vertices.offset(i);
    result.midpoint_feet[k] = midpoints.hint(e);
    result.midpoint_offsets[k] = midpoints.offset(e);
  }
  return result;
}

// The points of the faces at which the distance is sampled to integrate it: the more of them the larger a face is, and at
// least one. They tell by how much the distance differs from the quadratic function that the closest points to the corners
// and the midpoints of the sides give: then a mean over many faces is right however the distance bends in them or changes
// its sign, which it does on coarse faces, while that function alone is far off.
class Face_sampling
{
public:
  Face_sampling(const Mesh_arrays& mesh, const std::vector<Point>& points) : m_counts(mesh.number_of_faces())
  {
    constexpr double number_of_samples = 32768; // found by trial: the mean is within half a percent of that of very many
    constexpr double max_count = 576;           // for meshes of a few faces, where so many samples would be slow
    double area = 0;
    for(std::size_t f = 0; f < m_counts.size(); ++f)
      area += mesh.area(f, points);
    for(std::size_t f = 0; f < m_counts.size(); ++f)
    {
      const double count = std::ceil(number_of_samples * (mesh.area(f, points) / area));
      m_counts[f] = static_cast<std::uint16_t>(count >= 1 ? (std::min)(count, max_count) : 1);
    }
  }

  // Samples face f with its corners at `t`. If it is to be exact, all closest points are searched for.
  template <typename Reference>
  Face_distances measure(const Reference& reference,
                         const std::size_t f,
                         const std::array<Point, 3>& t,
                         const Face_sides<typename Reference::Foot>& sides,
                         const bool is_exact = false) const
  {
    constexpr std::size_t step_between_faces = 4; // of the sequence, so that the points of the faces differ
    const Vector normal = area_normal(t[0], t[1], t[2]);
    const bool walks = Reference::walks && !is_exact && is_smooth(reference, sides);
    const double near = near_by(sides.largest_distance(), std::sqrt(norm(normal)));
    const Quadratic_interpolant interpolant(signed_lengths(sides.offsets, normal),
                                            signed_lengths(sides.midpoint_offsets, normal));
    double max = 0, missed = 0, missed_square = 0, squared_deviation = 0;
    const std::size_t first = f * step_between_faces, count = m_counts[f];
    for(std::size_t number = first; number < first + count; ++number)
    {
      const Coordinates x = low_discrepancy_coordinates(number);
      const Point p = point_at(t, x);
      const auto& hint = nearest_hint(x, sides);
      const auto foot = walks ? walk_or_search(reference, p, hint, near) : reference.project(p, hint);
      const double distance = distance_to_foot(p, reference, foot);
      const double interpolated = interpolant.absolute_at(x), difference = distance - interpolated;
      max = (std::max)(max, distance);
      missed += difference;
      missed_square += square(distance) - square(interpolated);
      squared_deviation += square(difference);
    }
    if(count > 1)
      squared_deviation = (std::max)(0., squared_deviation - square(missed) / count) * count / (count - 1);
    return { (std::max)(0., interpolant.mean_of_absolute() + missed / count),
             (std::max)(0., interpolant.mean_of_square() + missed_square / count), squared_deviation / square(double(count)),
             max };
  }

  // Whether the reference bends so little under a face that walking will do: across a crease it may end too early.
  template <typename Reference>
  static bool is_smooth(const Reference& reference, const Face_sides<typename Reference::Foot>& sides)
  {
    constexpr double cosine_of_bend = 0.8; // of 37 degrees; it trades time for exactness
    const Vector n = reference.normal(sides.midpoint_feet[0]);
    const auto is_close = [&](const auto& foot) { return reference.normal(foot) * n >= cosine_of_bend; };
    return std::all_of(sides.feet.begin(), sides.feet.end(), is_close) &&
           std::all_of(sides.midpoint_feet.begin(), sides.midpoint_feet.end(), is_close);
  }

private:
  // positive on the side of the normal
  static std::array<double, 3> signed_lengths(const std::array<Vector, 3>& offsets, const Vector& normal)
  {
    const auto signed_length = [&](const Vector& offset) { return std::copysign(norm(offset), offset * normal); };
    return { { signed_length(offsets[0]), signed_length(offsets[1]), signed_length(offsets[2]) } };
  }

  template <typename Foot>
  static const Foot& nearest_hint(const Coordinates& x, const Face_sides<Foot>& sides)
  {
    const std::array<double, 3> lambda = x.barycentric();
    const auto largest = std::max_element(lambda.begin(), lambda.end()) - lambda.begin();
    if(lambda[largest] > 0.5)
      return sides.feet[largest];
    return sides.midpoint_feet[std::min_element(lambda.begin(), lambda.end()) - lambda.begin()];
  }

  std::vector<std::uint16_t> m_counts; // of the samples on each face
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACE_SAMPLING_H
