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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SECTOR_NORMALS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SECTOR_NORMALS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Sector_graph.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The average of the normals of the facets in a sector, how far they are apart, and the area of the largest facet.
struct Average_normal
{
  Vector normal;
  double squared_spread; // of the largest distance from the normals of the facets, as points of the unit sphere
  double largest_area;
};

// The weight of a facet in the average, beside its angle: 1, but for one that is much smaller than the largest. A large
// facet beside small ones is likely a plane that a rounding or fillet runs into; its normal is that of the surface there.
inline double facet_weight(const double area, const double largest_area)
{
  constexpr double small = 0.5; // less than the areas of irregular triangles differ; from there on the weights fall quickly
  return area < small * largest_area ? square(square(area / (small * largest_area))) : 1;
}

// the angles of the triangles, in radians, corner by corner; 0 where a side has no length
template <typename ConcurrencyTag>
std::vector<std::array<double, 3>> compute_angles(const Mesh_arrays& mesh)
{
  std::vector<std::array<double, 3>> angles(mesh.number_of_faces());
  for_each_index<ConcurrencyTag>(angles.size(), [&](std::size_t f) {
    const std::array<Point, 3> t = mesh.triangle(f);
    const std::array<Vector, 3> sides{ { t[2] - t[1], t[0] - t[2], t[1] - t[0] } };
    const double sine = norm(cross_product(sides[1], sides[2])); // times the lengths of two sides, as the cosine below
    for(int k = 0; k < 3; ++k)
      angles[f][k] = std::atan2(sine, -(sides[(k + 1) % 3] * sides[(k + 2) % 3]));
  });
  return angles;
}

template <typename ConcurrencyTag>
std::vector<Average_normal> average_facet_normals(const std::vector<Vector>& face_normals,
                                                  const std::vector<std::array<double, 3>>& angles,
                                                  const Facets& facets,
                                                  const Sector_graph& graph)
{
  std::vector<Average_normal> averages(graph.number_of_sectors());
  for_each_index<ConcurrencyTag>(averages.size(), [&](std::size_t s) {
    double largest = 0;
    for(Index c : graph.corners(s))
      largest = (std::max)(largest, facets.area[c / 3]);
    Vector sum = NULL_VECTOR;
    for(Index c : graph.corners(s))
      sum = sum + angles[c / 3][c % 3] * facet_weight(facets.area[c / 3], largest) * face_normals[c / 3];
    const Vector average = normalized(sum);
    double spread2 = 0;
    for(Index c : graph.corners(s))
      if(face_normals[c / 3] != NULL_VECTOR)
        spread2 = (std::max)(spread2, (average - face_normals[c / 3]).squared_length());
    averages[s] = { average, spread2, largest };
  });
  return averages;
}

// The equations H x = g for the correction x of a normal n, by which n + x is orthogonal to directions as well as possible.
class Normal_correction
{
public:
  // x should change the slope n * direction by `change`
  void change_slope(const double weight, const Vector& direction, const double change)
  {
    const Vector d = weight * direction;
    m_xx += direction.x() * d.x();
    m_xy += direction.x() * d.y();
    m_xz += direction.x() * d.z();
    m_yy += direction.y() * d.y();
    m_yz += direction.y() * d.z();
    m_zz += direction.z() * d.z();
    m_g = m_g + change * d;
  }

  // x should be this; some weight is needed for a solution
  void pull(const double weight, const Vector& by)
  {
    m_xx += weight;
    m_yy += weight;
    m_zz += weight;
    m_g = m_g + weight * by;
  }

  // by Cramer's rule: the pull keeps the system well conditioned
  Vector solve() const
  {
    const double trace = m_xx + m_yy + m_zz;
    if(!(trace > 0))
      return NULL_VECTOR;
    const Vector a = Vector(m_xx, m_xy, m_xz) / trace, b = Vector(m_xy, m_yy, m_yz) / trace,
                 c = Vector(m_xz, m_yz, m_zz) / trace, g = m_g / trace;
    const Vector b_x_c = cross_product(b, c);
    return Vector(g * b_x_c, g * cross_product(c, a), g * cross_product(a, b)) / (a * b_x_c);
  }

private:
  double m_xx = 0, m_xy = 0, m_xz = 0, m_yy = 0, m_yz = 0, m_zz = 0; // of H, which is symmetric
  Vector m_g = NULL_VECTOR;
};

// The correction of the normal n of a sector by which its edges make the same angles with the tangent planes at both
// ends. An edge whose ends contradict each other is an outlier, which Tukey's biweight leaves out.
inline Vector correct_normal(const Sector_graph& graph,
                             const std::vector<Vector>& normals,
                             const Index sector,
                             const Average_normal& average)
{
  constexpr double largest_difference = 0.85; // of the slopes at the ends of an edge, relative to their sum
  constexpr double relaxation = 0.5;          // all sectors are corrected at once; normals must not swing
  constexpr double pull_to_average = 0.03;    // for edges that say nothing, and large facets, which hold their normals
  constexpr double area_factor = 10;          // of a facet, beside the squared lengths of the edges

  const Vector& n = normals[sector];
  const Point& p = graph.point(sector);
  Normal_correction correction;
  double sum_of_weights = area_factor * average.largest_area;
  for(const Sector_graph::Edge& edge : graph.edges(sector))
  {
    if(edge.number_of_sides == 0)
      continue;
    // long edges count more: `along` is not normalized
    const Vector along = graph.point(edge.other) - p;
    const double slope = n * along, slope_at_other = -(normals[edge.other] * along);
    const double difference = slope - slope_at_other, sum = std::abs(slope) + std::abs(slope_at_other);
    const double outlier = sum > 0 ? difference / (largest_difference * sum) : 0;
    if(std::abs(outlier) < 1)
      correction.change_slope(edge.number_of_sides * square(1 - square(outlier)), along, -difference);
    sum_of_weights += edge.number_of_sides * along.squared_length();
  }
  correction.pull(pull_to_average * sum_of_weights, average.normal - n);
  const Vector step = relaxation * correction.solve();
  const Vector corrected = normalized(n + (step - (step * n) * n));
  // the facets bound the normal
  const Vector from_average = corrected - average.normal;
  const double distance2 = from_average.squared_length();
  return distance2 > average.squared_spread
           ? normalized(average.normal + std::sqrt(average.squared_spread / distance2) * from_average)
           : corrected;
}

// The normals of the sectors: the patches are tangent to the planes orthogonal to them.
//
// On a quadric surface an edge from p to q makes the same angle with the tangent planes at both ends,
//   (n_p + n_q) (q - p) = 0,
// however irregular the triangles are. From the average of the facets a few sweeps approach the normals for which that
// holds at all edges as well as possible, in the sense of least squares. Edges that run from a plane into a rounding, to
// the apex of a cone, or over a crease do not count.
template <typename ConcurrencyTag>
std::vector<Vector> compute_sector_normals(const std::vector<Vector>& face_normals,
                                           const std::vector<std::array<double, 3>>& angles, // of the triangles
                                           const Facets& facets,
                                           const Sector_graph& graph)
{
  constexpr int number_of_sweeps = 5; // more gains nothing on scans

  const std::vector<Average_normal> averages = average_facet_normals<ConcurrencyTag>(face_normals, angles, facets, graph);
  std::vector<Vector> normals, next(averages.size());
  normals.reserve(averages.size());
  for(const Average_normal& average : averages)
    normals.push_back(average.normal);
  for(int sweep = 0; sweep < number_of_sweeps; ++sweep)
  {
    for_each_index<ConcurrencyTag>(
      normals.size(), [&](std::size_t s) { next[s] = correct_normal(graph, normals, static_cast<Index>(s), averages[s]); });
    normals.swap(next);
  }
  return normals;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SECTOR_NORMALS_H
