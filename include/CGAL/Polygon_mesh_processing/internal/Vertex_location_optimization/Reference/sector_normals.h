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
  double spread; // the largest distance from the normals of the facets, as points of the unit sphere
  double largest_area;
};

// The weight of a facet in the average, beside its angle: 1, but for one that is much smaller than the largest. A large facet
// beside small ones is likely a plane that a rounding or fillet runs into; its normal is that of the surface there.
inline double facet_weight(const double area, const double largest_area)
{
  constexpr double small = 0.5; // less than the areas of irregular triangles differ; from there on the weights fall quickly
  return area < small * largest_area ? square(square(area / (small * largest_area))) : 1;
}

template <typename ConcurrencyTag>
std::vector<Average_normal> average_facet_normals(const Mesh_arrays& mesh,
                                                  const std::vector<Vector>& face_normals,
                                                  const Facets& facets,
                                                  const Sector_graph& graph)
{
  std::vector<Average_normal> averages(graph.number_of_sectors());
  for_each_index<ConcurrencyTag>(averages.size(), [&](std::size_t s) {
    double largest = 0;
    graph.for_each_corner(s, [&](Index c) { largest = (std::max)(largest, facets.area[c / 3]); });
    Vector sum = NULL_VECTOR;
    graph.for_each_corner(s, [&](Index c) {
      const std::array<Point, 3> t = mesh.triangle(c / 3);
      const double angle = angle_at(t[c % 3], t[(c + 1) % 3], t[(c + 2) % 3]);
      sum = sum + angle * facet_weight(facets.area[c / 3], largest) * face_normals[c / 3];
    });
    const Vector average = normalized(sum);
    double spread2 = 0;
    graph.for_each_corner(s, [&](Index c) {
      if(face_normals[c / 3] != NULL_VECTOR)
        spread2 = (std::max)(spread2, (average - face_normals[c / 3]).squared_length());
    });
    averages[s] = { average, std::sqrt(spread2), largest };
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
    m_H = { m_H[0] + direction.x() * d, m_H[1] + direction.y() * d, m_H[2] + direction.z() * d };
    m_g = m_g + change * d;
  }

  // x should be this; some weight is needed for a solution
  void pull(const double weight, const Vector& by)
  {
    m_H = { m_H[0] + Vector(weight, 0, 0), m_H[1] + Vector(0, weight, 0), m_H[2] + Vector(0, 0, weight) };
    m_g = m_g + weight * by;
  }

  // by Cramer's rule: the pull keeps the system well conditioned
  Vector solve() const
  {
    const double trace = m_H[0].x() + m_H[1].y() + m_H[2].z();
    if(!(trace > 0))
      return NULL_VECTOR;
    const Vector a = m_H[0] / trace, b = m_H[1] / trace, c = m_H[2] / trace, g = m_g / trace;
    const Vector b_x_c = cross_product(b, c);
    return Vector(g * b_x_c, g * cross_product(c, a), g * cross_product(a, b)) / (a * b_x_c);
  }

private:
  std::array<Vector, 3> m_H{ { NULL_VECTOR, NULL_VECTOR, NULL_VECTOR } }; // symmetric
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
  Normal_correction correction;
  double sum_of_weights = area_factor * average.largest_area;
  graph.for_each_edge(sector, [&](Index other, const Vector& direction, const Sector_graph::Edge& edge) {
    if(edge.weight == 0)
      return;
    const double weight = edge.weight * square(edge.length);
    const double slope = n * direction, slope_at_other = -(normals[other] * direction);
    const double difference = slope - slope_at_other, sum = std::abs(slope) + std::abs(slope_at_other);
    const double outlier = sum > 0 ? difference / (largest_difference * sum) : 0;
    const double biweight = std::abs(outlier) < 1 ? square(1 - square(outlier)) : 0;
    correction.change_slope(weight * biweight, direction, -difference);
    sum_of_weights += weight;
  });
  correction.pull(pull_to_average * sum_of_weights, average.normal - n);
  const Vector step = relaxation * correction.solve();
  const Vector corrected = normalized(n + (step - (step * n) * n));
  // the facets bound the normal
  const Vector from_average = corrected - average.normal;
  const double distance = norm(from_average);
  return distance > average.spread ? normalized(average.normal + (average.spread / distance) * from_average) : corrected;
}

// The normals of the sectors: the patches are tangent to the planes orthogonal to them.
//
// On a quadric surface an edge from p to q makes the same angle with the tangent planes at both ends,
//   (n_p + n_q) (q - p) = 0,
// however irregular the triangles are. From the average of the facets a few sweeps approach the normals for which that
// holds at all edges as well as possible, in the sense of least squares. Edges that run from a plane into a rounding, to
// the apex of a cone, or over a crease do not count.
template <typename ConcurrencyTag>
std::vector<Vector> compute_sector_normals(const Mesh_arrays& mesh,
                                           const std::vector<Vector>& face_normals,
                                           const Facets& facets,
                                           const Sector_graph& graph)
{
  constexpr int number_of_sweeps = 5; // more gains nothing on scans

  const std::vector<Average_normal> averages = average_facet_normals<ConcurrencyTag>(mesh, face_normals, facets, graph);
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
