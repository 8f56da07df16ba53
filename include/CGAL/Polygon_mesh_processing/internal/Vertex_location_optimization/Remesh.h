// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_OPTIMIZATION_STATE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_OPTIMIZATION_STATE_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Mesh_arrays.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Sampling/Closest_points.h>
#include <CGAL/Polygon_mesh_processing/Placement_method.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

enum class Vertex_kind : char
{
  FREE,
  ON_CURVE, // moves along with the constrained edges or the border
  FIXED
};

struct Constraints
{
  std::vector<Vertex_kind> kinds;  // of the vertices
  std::vector<Index> edges;        // the constrained edges and the border edges
};

// What the phases of an iteration read and write. Hint is the `Hint_of` the reference surface.
template <typename Hint>
struct Optimization_state
{
  Optimization_state(Mesh_arrays mesh_arrays, Constraints c, const Placement_method method)
    : mesh(std::move(mesh_arrays)), constraints(std::move(c)), targets(mesh.points),
      mean_edge_length(compute_mean_edge_length()), spring_length(compute_spring_length()),
      vertex_samples(mesh.points.size(), mean_edge_length, true),
      midpoint_samples(mesh.edges.size(), mean_edge_length, method == LEAST_SQUARES),
      barycenter_samples(method == LEAST_SQUARES ? mesh.number_of_faces() : 0, mean_edge_length, true)
  {
    group_corners_by_vertex();
  }

  // calls f(c) for each corner c at vertex i
  template <typename F>
  void for_each_corner(std::size_t i, const F& f) const
  {
    for(Index k = m_first_corner[i]; k < m_first_corner[i + 1]; ++k)
      f(m_corners[k]);
  }

  bool is_free(std::size_t i) const { return constraints.kinds[i] == Vertex_kind::FREE; }

  // whether the fit leaves vertex i where it is
  bool is_at_rest(std::size_t i) const
  {
    return squared_distance(targets[i], mesh.points[i]) <= square(1e-9 * mean_edge_length);
  }

  // by how much vertex i moved in the last iteration; to be asked before its target is set
  Vector last_displacement(std::size_t i) const { return mesh.points[i] - targets[i]; }

  Mesh_arrays mesh;                         // M_t, with the points v_i
  Constraints constraints;
  std::vector<Point> initial_points;        // of M_0; only while moves are corrected
  std::vector<Point> targets;               // p^_i, which become the points of M_t+1; before they are set, M_t-1

  double mean_edge_length;                  // of M_0
  double spring_length;                     // sigma of (3)

  Reference_samples<Hint> vertex_samples;     // p_i and n_i
  Reference_samples<Hint> midpoint_samples;   // m_ij, with normals if the fit takes them
  Reference_samples<Hint> barycenter_samples; // empty if the fit takes none

private:
  double compute_mean_edge_length() const
  {
    double sum = 0;
    for(const std::array<Index, 2>& e : mesh.edges)
      sum += norm(mesh.points[e[1]] - mesh.points[e[0]]);
    return mesh.edges.empty() ? 0 : sum / mesh.edges.size();
  }

  double compute_spring_length() const
  {
    double area = 0;
    for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      area += mesh.area(f);
    return 0.3 * std::sqrt(area / mesh.points.size());
  }

  void group_corners_by_vertex()
  {
    m_first_corner.assign(mesh.points.size() + 1, 0);
    for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      for(Index i : mesh.face(f))
        ++m_first_corner[i + 1];
    for(std::size_t i = 0; i < mesh.points.size(); ++i)
      m_first_corner[i + 1] += m_first_corner[i];

    m_corners.resize(3 * mesh.number_of_faces());
    std::vector<Index> end(m_first_corner.begin(), m_first_corner.end() - 1);
    for(Index c = 0; c < m_corners.size(); ++c)
      m_corners[end[mesh.vertex(c)]++] = c;
  }

  // the corners at vertex i are m_corners[m_first_corner[i]], ..., m_corners[m_first_corner[i + 1] - 1]
  std::vector<Index> m_first_corner;
  std::vector<Index> m_corners;
};

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_OPTIMIZATION_STATE_H
