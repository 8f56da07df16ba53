// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLED_ERROR_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLED_ERROR_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Flat_triangle.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_element.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/memory.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>

#include <boost/range/irange.hpp>

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

template <typename Surface, typename = void>
struct Has_coinciding_feet : std::false_type {};

template <typename Surface>
struct Has_coinciding_feet<Surface, std::void_t<decltype(std::declval<const Surface&>().coinciding_feet(
                                      std::declval<typename Surface::Foot>()))>>
  : std::true_type {};

// Which normals of the reference a face opposes at a point. On an edge the reference has several.
enum class Opposition : char
{
  NONE,
  SOME,
  ALL
};

// The distance to the reference of the remesh with its vertices at the targets, sampled at the vertices, the midpoints of
// the edges and the barycenters of the faces. With the weights 1/20, 2/15 and 9/20 these points integrate cubics exactly.
// The samples at the vertices and midpoints are those of the state.
template <typename ReferenceSurface>
class Sampled_error
{
  using Foot = typename ReferenceSurface::Foot;
  using Reference_point = typename ReferenceSurface::Point_3;
  using Hint = Hint_of<ReferenceSurface>;
  using State = Optimization_state<Hint>;

public:
  Sampled_error(const ReferenceSurface& reference, State& state)
    : m_reference(reference), m_state(state)
  {
    allocate_at_barycenters();
  }

  // Takes the distance at the barycenter of face f, of which this is the foot.
  void set_barycenter(std::size_t f, const Foot& foot)
  {
    const std::array<Point, 3> t = triangle(f);
    m_at_barycenter[f] = distance_to_foot(point_at(t, Coordinates()), foot);
    m_opposition[f] = opposition_at(foot, area_normal(t[0], t[1], t[2]));
  }

  // Takes samples, which have been taken where the points of the mesh are; then these are the targets. Each distance is that
  // to the point where walking from the foot of the last iteration leads, or to the last sample if the query has hardly
  // moved since that was taken; rather more than less.
  template <typename ConcurrencyTag>
  void sample()
  {
    constexpr double hardly = 1e-3; // relative to the mean edge length
    const auto move = [&](Reference_samples<Hint>& samples, std::size_t k, const Point& from, const Point& to)
    {
      if(squared_distance(from, to) <= square(hardly * m_state.mean_edge_length))
        samples.set_offset(k, samples.offset(k) - (to - from));
      else
        walk(samples, k, to);
    };

    allocate_at_barycenters();
    for_each_element<ConcurrencyTag>(m_state.mesh,
      [&](std::size_t i) { move(m_state.vertex_samples, i, m_state.mesh.points[i], m_state.targets[i]); },
      [&](std::size_t e) { move(m_state.midpoint_samples, e, m_state.mesh.midpoint(e), midpoint_of_edge(e)); },
      [&](std::size_t f)
      {
        constexpr std::size_t ahead = 8;
        if(f + ahead < m_state.mesh.number_of_faces())
          prefetch_near(m_reference, hint_near(f + ahead));
        sample_barycenter(f);
      });
    m_state.mesh.points = m_state.targets;
  }

  // the samples are not needed until they are taken again
  void free_memory()
  {
    release(m_at_barycenter);
    release(m_opposition);
  }

  // samples anew what has changed with vertex i; then its point, too, is its target
  void update(Index i)
  {
    walk(m_state.vertex_samples, i, m_state.targets[i]);
    m_state.for_each_corner(i, [&](Index c)
    {
      for(Index e : { m_state.mesh.opposite_edge(Mesh_arrays::next(c)), m_state.mesh.opposite_edge(Mesh_arrays::previous(c)) })
        walk(m_state.midpoint_samples, e, midpoint_of_edge(e));
      sample_barycenter(c / 3);
    });
    m_state.mesh.points[i] = m_state.targets[i];
  }

  double area(std::size_t f) const { return m_state.mesh.area(f, m_state.targets); }

  // integral of the distance over face f
  double integral(std::size_t f) const
  {
    const std::array<Index, 3> vertices = m_state.mesh.face(f);
    double at_vertices = 0, at_midpoints = 0;
    for(int k = 0; k < 3; ++k)
    {
      at_vertices += at_vertex(vertices[k]);
      at_midpoints += at_midpoint(m_state.mesh.face_edges[f][k]);
    }
    return area(f) * mean_of(at_vertices, at_midpoints, m_at_barycenter[f]);
  }

  // the same in the remesh, at closest points
  double integral_in_remesh(std::size_t f) const
  {
    const std::array<Index, 3> vertices = m_state.mesh.face(f);
    const std::array<Point, 3> t = m_state.mesh.triangle(f, m_state.initial_points);
    double at_vertices = 0, at_midpoints = 0;
    for(int k = 0; k < 3; ++k)
    {
      at_vertices += distance(t[k], m_state.vertex_samples.hint(vertices[k]));
      at_midpoints += distance(midpoint(t[(k + 1) % 3], t[(k + 2) % 3]),
                               m_state.midpoint_samples.hint(m_state.mesh.face_edges[f][k]));
    }
    const double at_barycenter = distance(point_at(t, Coordinates()), hint_near(f));
    return m_state.mesh.area(f, m_state.initial_points) * mean_of(at_vertices, at_midpoints, at_barycenter);
  }

  template <typename ConcurrencyTag>
  double mean() const
  {
    const std::size_t n = m_state.mesh.number_of_faces();
    const double total_area = sum_over_indices<ConcurrencyTag, double>(n, [&](std::size_t f) { return area(f); });
    const double total = sum_over_indices<ConcurrencyTag, double>(n, [&](std::size_t f) { return integral(f); });
    return total_area > 0 ? total / total_area : 0;
  }

  // The largest distance, rather less than more: the best of lattices on some faces, those with the largest samples.
  double maximum() const
  {
    constexpr double near = 0.9;
    constexpr int max_faces = 64;
    const auto all = boost::irange<std::size_t>(0, m_state.mesh.number_of_faces());
    std::array<std::size_t, max_faces> faces;
    const auto end = std::partial_sort_copy(all.begin(), all.end(), faces.begin(), faces.end(),
                                            [&](std::size_t f, std::size_t g)
    {
      return sampled_maximum(f) > sampled_maximum(g);
    });
    double result = 0;
    for(auto f = faces.begin(); f != end && sampled_maximum(*f) > near * result; ++f)
      result = (std::max)(result, lattice_maximum(*f, m_state.targets).distance);
    return result;
  }

  // Whether the largest distance on face f is larger than in the remesh, on a lattice or beyond it, or hardly smaller at a
  // point that has moved.
  bool has_grown(std::size_t f) const
  {
    constexpr double margin = 0.995; // for what they miss
    if(lattice_maximum(f, m_state.targets).distance > lattice_maximum(f, m_state.initial_points).distance)
      return true;
    const Face_point farthest = climb_to_maximum(f, m_state.targets);
    const double distance_in_remesh = climb_to_maximum(f, m_state.initial_points).distance;
    return farthest.distance > distance_in_remesh ||
           (farthest.distance > margin * distance_in_remesh &&
            point_at(triangle(f), farthest.x) != point_at(m_state.mesh.triangle(f, m_state.initial_points), farthest.x));
  }

  // of face f to the normals of the reference at the foot of the barycenter
  Opposition opposition(std::size_t f) const { return m_opposition[f]; }

  // The largest distance on face f, rather more than less, if the samples come near `threshold`; else the largest of the
  // samples. Between them the distance may be larger: fivefold on a face that spans a crease, less the more samples there
  // are. Where two sheets of the reference are equally far away it has a ridge, on which climbing may end too early.
  double maximum(std::size_t f, double threshold) const
  {
    constexpr double near = 0.2, nearer = 0.6, nearest = 0.9;
    const double sampled = sampled_maximum(f);
    if(!(sampled >= near * threshold))
      return sampled;
    const auto project_roughly = [&](const Point& p, const Foot& hint) { return project_near(m_reference, p, hint); };
    if(sampled < nearer * threshold && lattice_maximum(f, m_state.targets, 4, project_roughly).distance < nearer * threshold)
      return sampled;
    const double result = (std::max)(sampled, climb_to_maximum(f, m_state.targets).distance);
    if(result >= nearest * threshold && result <= threshold)
      return (std::max)(result, climb_to_maximum(f, m_state.targets, 24).distance);
    return result;
  }

private:
  double at_vertex(std::size_t i) const { return norm(m_state.vertex_samples.offset(i)); }
  double at_midpoint(std::size_t e) const { return norm(m_state.midpoint_samples.offset(e)); }

  // the mean over a face from the sums over its vertices and midpoints
  static double mean_of(double at_vertices, double at_midpoints, double at_barycenter)
  {
    return at_vertices / 20 + at_midpoints * 2 / 15 + at_barycenter * 9 / 20;
  }

  void allocate_at_barycenters()
  {
    m_at_barycenter.resize(m_state.mesh.number_of_faces());
    m_opposition.resize(m_state.mesh.number_of_faces());
  }

  std::array<Point, 3> triangle(std::size_t f) const { return m_state.mesh.triangle(f, m_state.targets); }

  Point midpoint_of_edge(std::size_t e) const
  {
    const std::array<Index, 2>& ends = m_state.mesh.edges[e];
    return midpoint(m_state.targets[ends[0]], m_state.targets[ends[1]]);
  }

  // for the barycenter of face f
  const Hint& hint_near(std::size_t f) const { return m_state.midpoint_samples.hint(m_state.mesh.edge_at_first_vertex(f)); }

  double sampled_maximum(std::size_t f) const
  {
    double result = m_at_barycenter[f];
    for(Index i : m_state.mesh.face(f))
      result = (std::max)(result, at_vertex(i));
    for(Index e : m_state.mesh.face_edges[f])
      result = (std::max)(result, at_midpoint(e));
    return result;
  }

  // a point of a face with its foot and distance
  struct Face_point
  {
    double distance;
    Coordinates x;
    Foot foot;
  };

  // The point of the largest distance on a lattice on face f with its vertices at `points`.
  Face_point lattice_maximum(std::size_t f, const std::vector<Point>& points, int level = 8) const
  {
    return lattice_maximum(f, points, level, [&](const Point& p, const Foot& hint) { return project(p, hint); });
  }

  // The same with feet by `project(p, hint)`. From row to row it goes to and fro: each foot is a hint for the next.
  template <typename Project>
  Face_point lattice_maximum(std::size_t f, const std::vector<Point>& points, int level, const Project& project) const
  {
    const std::array<Point, 3> t = m_state.mesh.triangle(f, points);
    Foot foot = m_state.vertex_samples.hint(m_state.mesh.first_vertex(f));
    Face_point best{ -1, Coordinates(), foot };
    for(int i = 0; i <= level; ++i)
      for(int k = 0; k <= level - i; ++k)
      {
        const int j = i % 2 == 0 ? k : level - i - k;
        const Coordinates x{ double(i) / level, double(j) / level };
        const Point p = point_at(t, x);
        foot = project(p, foot);
        const double d = distance_to_foot(p, foot);
        if(d > best.distance)
          best = { d, x, foot };
      }
    return best;
  }

  // The point to which climbing from that on the lattice leads.
  Face_point climb_to_maximum(std::size_t f, const std::vector<Point>& points, int level = 8) const
  {
    constexpr int number_of_halvings = 5;
    const std::array<Point, 3> t = m_state.mesh.triangle(f, points);
    Face_point best = lattice_maximum(f, points, level);
    double step = 0.5 / level;
    for(int i = 0; i < number_of_halvings; ++i, step /= 2)
    {
      const Face_point center = best;
      for(const auto& [u, v] : { std::pair(1, 0), std::pair(0, 1), std::pair(-1, 1),
                                 std::pair(-1, 0), std::pair(0, -1), std::pair(1, -1) })
      {
        const Coordinates x{ center.x.u + step * u, center.x.v + step * v };
        if(x.u < 0 || x.v < 0 || x.u + x.v > 1)
          continue;
        const Point p = point_at(t, x);
        const Foot foot = project(p, center.foot);
        const double d = distance_to_foot(p, foot);
        if(d > best.distance)
          best = { d, x, foot };
      }
    }
    return best;
  }

  Foot project(const Point& p, const Foot& hint) const { return m_reference.project(convert<Reference_point>(p), hint); }

  double distance(const Point& p, const Foot& hint) const { return distance_to_foot(p, project(p, hint)); }

  double distance_to_foot(const Point& p, const Foot& foot) const
  {
    return norm(convert<Point>(m_reference.point(foot)) - p);
  }

  // takes sample k at the point to which walking from its foot leads
  void walk(Reference_samples<Hint>& samples, std::size_t k, const Point& query)
  {
    samples.set_offset(k, convert<Point>(m_reference.point(project_near(m_reference, query, samples.hint(k)))) - query);
  }

  void sample_barycenter(std::size_t f)
  {
    constexpr double near = 0.1; // relative to the mean edge length; other sheets are thought to be farther away
    const Point p = point_at(triangle(f), Coordinates());
    const Foot foot = project_near(m_reference, p, hint_near(f));
    set_barycenter(f, foot);
    if(m_opposition[f] != Opposition::NONE || m_at_barycenter[f] > near * m_state.mean_edge_length)
      set_barycenter(f, project(p, foot));
  }

  Opposition opposition_at(const Foot& foot, const Vector& normal) const
  {
    const auto is_opposed = [&](const Foot& other) { return normal * convert<Vector>(m_reference.normal(other)) < 0; };
    if constexpr(Has_coinciding_feet<ReferenceSurface>::value)
    {
      const auto feet = m_reference.coinciding_feet(foot);
      const auto opposed = static_cast<std::size_t>(std::count_if(feet.begin(), feet.end(), is_opposed));
      return opposed == 0 ? Opposition::NONE : opposed < feet.size() ? Opposition::SOME : Opposition::ALL;
    }
    else
      return is_opposed(foot) ? Opposition::ALL : Opposition::NONE;
  }

  const ReferenceSurface& m_reference;
  State& m_state;
  std::vector<double> m_at_barycenter;
  std::vector<Opposition> m_opposition;
};

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLED_ERROR_H
