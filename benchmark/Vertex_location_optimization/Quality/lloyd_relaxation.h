// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_LLOYD_RELAXATION_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_LLOYD_RELAXATION_H

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/property_map.h>
#include <CGAL/Random.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <iterator>
#include <vector>

// Flips the edges of which the angles on both sides are more than 180 degrees together, as long as there are some; not
// where the two faces are no nearly planar quadrangle.
template <typename Point>
void flip_to_Delaunay(CGAL::Surface_mesh<Point>& mesh)
{
  constexpr int max_rounds = 10;
  bool has_flipped = true;
  for(int round = 0; has_flipped && round < max_rounds; ++round)
  {
    has_flipped = false;
    for(auto e : mesh.edges())
    {
      if(mesh.is_border(e))
        continue;
      const auto h = mesh.halfedge(e);
      const auto p = mesh.source(h), q = mesh.target(h);
      const auto r = mesh.target(mesh.next(h)), s = mesh.target(mesh.next(mesh.opposite(h)));
      const Point &a = mesh.point(p), &b = mesh.point(q), &c = mesh.point(r), &d = mesh.point(s);
      const bool is_Delaunay = CGAL::approximate_angle(a, c, b) + CGAL::approximate_angle(a, d, b) <= 180.001;
      const auto normal = CGAL::normal(a, b, c) + CGAL::normal(b, a, d);
      const bool stays_oriented = CGAL::normal(a, d, c) * normal > 0 && CGAL::normal(d, b, c) * normal > 0;
      if(is_Delaunay || !stays_oriented || mesh.halfedge(r, s) != mesh.null_halfedge())
        continue;
      CGAL::Euler::flip_edge(h, mesh);
      has_flipped = true;
    }
  }
}

// Lloyd's relaxation: moves each vertex to the centroid of the part of `input` that is closer to it than to the other
// vertices, and back to the surface. The parts are made of samples. Vertices on the border stay.
template <typename Point, typename ReferenceSurface>
void relax_with_Lloyd(CGAL::Surface_mesh<Point>& mesh,
                      const CGAL::Surface_mesh<Point>& input,
                      const ReferenceSurface& reference,
                      std::size_t number_of_iterations = 10)
{
  using Mesh = CGAL::Surface_mesh<Point>;
  using Vertex = typename Mesh::Vertex_index;
  using Kernel = typename CGAL::Kernel_traits<Point>::Kernel;
  using Vector = typename Kernel::Vector_3;
  using Point_map = typename Mesh::template Property_map<Vertex, Point>;
  using Traits = CGAL::Search_traits_adapter<Vertex, Point_map, CGAL::Search_traits_3<Kernel>>;
  using Search = CGAL::Orthogonal_k_neighbor_search<Traits>;

  CGAL::get_default_random() = CGAL::Random(0); // which the sampling uses, whatever its parameter says
  constexpr std::size_t samples_per_vertex = 50;
  std::vector<Point> samples;
  CGAL::Polygon_mesh_processing::sample_triangle_mesh(
    input, std::back_inserter(samples),
    CGAL::parameters::number_of_points_on_faces(samples_per_vertex * mesh.number_of_vertices())
      .do_sample_vertices(false)
      .do_sample_edges(false));

  for(std::size_t i = 0; i < number_of_iterations; ++i)
  {
    const typename Search::Splitter splitter;
    const Traits traits(mesh.points());
    typename Search::Tree tree(mesh.vertices().begin(), mesh.vertices().end(), splitter, traits);
    std::vector<Vector> sums(mesh.number_of_vertices(), CGAL::NULL_VECTOR);
    std::vector<std::size_t> counts(mesh.number_of_vertices(), 0);
    for(const Point& p : samples)
    {
      const Vertex v = Search(tree, p, 1, 0, true, typename Search::Distance(mesh.points())).begin()->first;
      sums[v] = sums[v] + (p - CGAL::ORIGIN);
      ++counts[v];
    }
    for(Vertex v : mesh.vertices())
      if(counts[v] > 0 && !mesh.is_border(v))
        mesh.point(v) = reference.point(reference.project(CGAL::ORIGIN + sums[v] / double(counts[v])));
    flip_to_Delaunay(mesh);
  }
}

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_LLOYD_RELAXATION_H
