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

#ifndef CGAL_GEOMETRY_IMAGE_INTERNAL_TRIANGULATE_SAMPLES_H
#define CGAL_GEOMETRY_IMAGE_INTERNAL_TRIANGULATE_SAMPLES_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Geometry_image/Geometry_image.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup_extension.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/squared_distance_3.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::internal::geometry_image {

// Sample s is that in row s / width and column s % width. A triangle is one of samples or of vertices.
using Triangle = std::array<std::size_t, 3>;

constexpr std::size_t no_vertex = (std::numeric_limits<std::size_t>::max)();

struct Triangulated_samples
{
  std::vector<Triangle> triangles;           // of vertices; they are those of a polygon mesh
  std::vector<std::size_t> sample_of_vertex; // the first one; increasing, but for the copies at the end
  std::vector<std::size_t> vertex_of_sample; // no_vertex: the sample is in no triangle
  std::size_t number_of_copies = 0;          // of vertices where the samples give no polygon mesh
};

template <typename Point_3>
bool has_finite_samples(const Geometry_image<Point_3>& image)
{
  return std::all_of(image.begin(), image.end(), [](const Point_3& p) {
    namespace VLO = Polygon_mesh_processing::internal::vertex_location;
    return VLO::is_finite(VLO::convert<VLO::Point>(p));
  });
}

// for each sample, the first of those that are the same vertex
template <typename Point_3>
std::vector<std::size_t> find_coinciding_samples(const Geometry_image<Point_3>& image)
{
  std::vector<std::size_t> first(image.width() * image.height());
  std::map<Point_3, std::size_t> first_at; // on the border
  std::size_t s = 0;
  for(std::size_t i = 0; i < image.height(); ++i)
    for(std::size_t j = 0; j < image.width(); ++j, ++s)
    {
      const bool is_border = i == 0 || j == 0 || i + 1 == image.height() || j + 1 == image.width();
      first[s] = is_border ? first_at.emplace(image(i, j), s).first->second : s;
    }
  return first;
}

// The two triangles of a quad with the corners a, b, c, d in their order, split from a to c or from b to d. They are
// oriented such that the normal is that of the derivatives along a row and along a column, in this order.
inline std::array<Triangle, 2> split_quad(const std::array<std::size_t, 4>& quad, bool from_a_to_c)
{
  const auto [a, b, c, d] = quad;
  if(from_a_to_c)
    return { Triangle{ a, b, c }, Triangle{ a, c, d } };
  return { Triangle{ a, b, d }, Triangle{ b, c, d } };
}

inline Triangle sorted(Triangle t)
{
  std::sort(t.begin(), t.end());
  return t;
}

inline bool is_degenerate(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

// The triangles of samples, of which each stands for those that coincide with it: quads are split along their shorter
// diagonals. Where a border is folded, the diagonals of the two quads beside the fold can cut off the same triangle,
// once from each side; the second quad is then split the other way.
template <typename Point_3>
std::vector<Triangle> split_quads(const Geometry_image<Point_3>& image, const std::vector<std::size_t>& first)
{
  const std::size_t width = image.width(), height = image.height();
  std::vector<Triangle> triangles;
  std::set<Triangle> border_triangles; // with their corners sorted
  for(std::size_t i = 0; i + 1 < height; ++i)
    for(std::size_t j = 0; j + 1 < width; ++j)
    {
      const std::size_t s = i * width + j;
      const std::array<std::size_t, 4> quad{ first[s], first[s + 1], first[s + width + 1], first[s + width] };
      bool from_a_to_c =
        squared_distance(image(i, j), image(i + 1, j + 1)) <= squared_distance(image(i, j + 1), image(i + 1, j));

      const bool is_border = i == 0 || j == 0 || i + 2 == height || j + 2 == width;
      if(is_border)
      {
        const auto [t, u] = split_quad(quad, from_a_to_c);
        if(border_triangles.count(sorted(t)) + border_triangles.count(sorted(u)) > 0)
          from_a_to_c = !from_a_to_c;
      }
      for(const Triangle& t : split_quad(quad, from_a_to_c))
        if(!is_degenerate(t))
        {
          triangles.push_back(t);
          if(is_border)
            border_triangles.insert(sorted(t));
        }
    }
  return triangles;
}

// Numbers the samples that are in triangles, from 0, in their order.
inline Triangulated_samples number_vertices(std::vector<Triangle> triangles, const std::vector<std::size_t>& first)
{
  std::vector<char> is_used(first.size(), 0);
  for(const Triangle& t : triangles)
    for(std::size_t s : t)
      is_used[s] = 1;

  Triangulated_samples result;
  result.vertex_of_sample.assign(first.size(), no_vertex);
  for(std::size_t s = 0; s < first.size(); ++s)
  {
    if(is_used[s])
    {
      result.vertex_of_sample[s] = result.sample_of_vertex.size();
      result.sample_of_vertex.push_back(s);
    }
    result.vertex_of_sample[s] = result.vertex_of_sample[first[s]]; // first[s] <= s
  }
  for(Triangle& t : triangles)
    for(std::size_t& s : t)
      s = result.vertex_of_sample[s];
  result.triangles = std::move(triangles);
  return result;
}

// Triangulates an image with finite samples. Where its triangles give no polygon mesh, since the border touches itself or
// the image is one-sided, vertices are copied: the surface is cut open along its side-band.
template <typename Point_3>
Triangulated_samples triangulate_samples(const Geometry_image<Point_3>& image)
{
  namespace PMP = Polygon_mesh_processing;

  const std::vector<std::size_t> first = find_coinciding_samples(image);
  Triangulated_samples result = number_vertices(split_quads(image, first), first);
  const std::size_t number_of_vertices = result.sample_of_vertex.size();
  if(!PMP::is_polygon_soup_a_polygon_mesh(result.triangles))
    PMP::duplicate_non_manifold_edges_in_polygon_soup(result.sample_of_vertex, result.triangles);
  result.number_of_copies = result.sample_of_vertex.size() - number_of_vertices;
  return result;
}

// Adds the triangles to a mesh, with the points of `image`, whose size is that of the image that was triangulated.
template <typename Point_3, typename TriangleMesh, typename NamedParameters>
void add_to_mesh(const Triangulated_samples& samples,
                 const Geometry_image<Point_3>& image,
                 TriangleMesh& tmesh,
                 const NamedParameters& np)
{
  namespace PMP = Polygon_mesh_processing;
  using Vertex_point_map = typename GetVertexPointMap<TriangleMesh, NamedParameters>::type;
  using Mesh_point = typename boost::property_traits<Vertex_point_map>::value_type;

  const auto point_of_sample = [&](std::size_t s) {
    return PMP::internal::vertex_location::convert<Mesh_point>(image(s / image.width(), s % image.width()));
  };
  PMP::polygon_soup_to_polygon_mesh(
    samples.sample_of_vertex, samples.triangles, tmesh,
    parameters::point_map(boost::make_function_property_map<std::size_t, Mesh_point>(point_of_sample)), np);
}

} // namespace CGAL::internal::geometry_image

#endif // CGAL_GEOMETRY_IMAGE_INTERNAL_TRIANGULATE_SAMPLES_H
