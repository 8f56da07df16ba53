// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_OPTIMIZATION_STATE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_OPTIMIZATION_STATE_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/for_each_index.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Mesh_arrays.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference_samples.h>
#include <CGAL/Polygon_mesh_processing/Placement_method.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
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
    : mesh(std::move(mesh_arrays)), constraints(std::move(c)), initial_points(mesh.points), targets(mesh.points),
      size(longest_side_of_box()),
      vertex_samples(mesh.points.size(), size, true),
      midpoint_samples(mesh.edges.size(), size, method == LEAST_SQUARES),
      barycenter_samples(method == LEAST_SQUARES ? mesh.faces.size() : 0, size, true)
  {
    group_corners_by_vertex();

    double area = 0, length = 0;
    for(std::size_t f = 0; f < mesh.faces.size(); ++f)
      area += mesh.area(f);
    for(const std::array<Index, 2>& e : mesh.edges)
      length += norm(mesh.points[e[1]] - mesh.points[e[0]]);
    spring_length = 0.3 * std::sqrt(area / mesh.points.size());
    mean_edge_length = mesh.edges.empty() ? 0 : length / mesh.edges.size();
  }

  // calls f(c) for each corner c at vertex i
  template <typename F>
  void for_each_corner(std::size_t i, const F& f) const
  {
    for(Index k = first_corner[i]; k < first_corner[i + 1]; ++k)
      f(corners[k]);
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
  std::vector<Point> initial_points;        // of M_0
  std::vector<Point> targets;               // p^_i, which become the points of M_t+1; before they are set, M_t-1

  double size;                              // of M_0: the longest side of its bounding box, 1 if it has none

  Reference_samples<Hint> vertex_samples;     // p_i and n_i
  Reference_samples<Hint> midpoint_samples;   // m_ij, with normals if the fit takes them
  Reference_samples<Hint> barycenter_samples; // empty if the fit takes none

  double spring_length = 0;                 // sigma of (3)
  double mean_edge_length = 0;              // of M_0

private:
  double longest_side_of_box() const
  {
    if(mesh.points.empty())
      return 1;
    const Bbox_3 box = bbox_3(mesh.points.begin(), mesh.points.end());
    const double side = (std::max)({ box.x_span(), box.y_span(), box.z_span() });
    return side > 0 ? side : 1;
  }

  void group_corners_by_vertex()
  {
    first_corner.assign(mesh.points.size() + 1, 0);
    for(const std::array<Index, 3>& face : mesh.faces)
      for(Index i : face)
        ++first_corner[i + 1];
    for(std::size_t i = 0; i < mesh.points.size(); ++i)
      first_corner[i + 1] += first_corner[i];

    corners.resize(3 * mesh.faces.size());
    std::vector<Index> end(first_corner.begin(), first_corner.end() - 1);
    for(Index c = 0; c < corners.size(); ++c)
      corners[end[mesh.vertex(c)]++] = c;
  }

  // the corners at vertex i are corners[first_corner[i]], ..., corners[first_corner[i + 1] - 1]
  std::vector<Index> first_corner;
  std::vector<Index> corners;
};

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_OPTIMIZATION_STATE_H
