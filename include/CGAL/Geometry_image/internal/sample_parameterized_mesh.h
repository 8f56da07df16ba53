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

#ifndef CGAL_GEOMETRY_IMAGE_INTERNAL_SAMPLE_PARAMETERIZED_MESH_H
#define CGAL_GEOMETRY_IMAGE_INTERNAL_SAMPLE_PARAMETERIZED_MESH_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Geometry_image/Geometry_image.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::internal::geometry_image {

using Double_kernel = Polygon_mesh_processing::internal::vertex_location::Kernel;
using Double_mesh = Surface_mesh<Double_kernel::Point_3>;

// barycentric coordinates of p; not finite if the triangle has no area, which CGAL's functions require
inline std::array<double, 3> barycentric_coordinates(const std::array<Double_kernel::Point_2, 3>& t,
                                                     const Double_kernel::Point_2& p)
{
  auto twice_area = [](const auto& a, const auto& b, const auto& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  };
  const double area = twice_area(t[0], t[1], t[2]);
  return { twice_area(p, t[1], t[2]) / area, twice_area(t[0], p, t[2]) / area, twice_area(t[0], t[1], p) / area };
}

// Samples a mesh, which `uvmap` maps to the unit square, at a regular grid: rows are lines of equal u, columns of equal v.
// A sample is taken from the face that contains it or, because of rounding, comes nearest to containing it. Returns false if
// a sample is in no face.
template <typename UVMap, typename Point_3>
bool sample_parameterized_mesh(const Double_mesh& mesh, const UVMap& uvmap, Geometry_image<Point_3>& image)
{
  using Double_point = Double_kernel::Point_3;
  const double last_row = static_cast<double>(image.height() - 1), last_column = static_cast<double>(image.width() - 1);
  auto first_index = [](double x, double last) { return static_cast<std::size_t>((std::max)(0., std::ceil(x * last))); };
  auto last_index = [](double x, double last) { return static_cast<std::size_t>((std::min)(last, std::floor(x * last))); };

  constexpr double none = -(std::numeric_limits<double>::max)();
  std::vector<double> smallest_coordinate(image.width() * image.height(), none); // of the samples in their faces
  for(Double_mesh::Face_index f : mesh.faces())
  {
    std::array<Double_point, 3> points;
    std::array<Double_kernel::Point_2, 3> uv;
    std::size_t k = 0;
    for(Double_mesh::Vertex_index v : vertices_around_face(mesh.halfedge(f), mesh))
    {
      points[k] = mesh.point(v);
      uv[k++] = get(uvmap, v);
    }
    const auto [u_min, u_max] = std::minmax({ uv[0].x(), uv[1].x(), uv[2].x() });
    const auto [v_min, v_max] = std::minmax({ uv[0].y(), uv[1].y(), uv[2].y() });
    if(!std::isfinite(u_max - u_min) || !std::isfinite(v_max - v_min) || u_max < 0 || v_max < 0)
      continue;

    for(std::size_t i = first_index(u_min, last_row); i <= last_index(u_max, last_row); ++i)
      for(std::size_t j = first_index(v_min, last_column); j <= last_index(v_max, last_column); ++j)
      {
        std::array<double, 3> lambda = barycentric_coordinates(uv, { i / last_row, j / last_column });
        const double smallest = (std::min)({ lambda[0], lambda[1], lambda[2] });
        if(!(smallest > smallest_coordinate[i * image.width() + j]))
          continue;
        smallest_coordinate[i * image.width() + j] = smallest;

        for(double& x : lambda)
          x = (std::max)(0., x);
        const double sum = lambda[0] + lambda[1] + lambda[2];
        const Double_point p =
          points[0] + (lambda[1] / sum * (points[1] - points[0]) + lambda[2] / sum * (points[2] - points[0]));
        image(i, j) = Polygon_mesh_processing::internal::vertex_location::convert<Point_3>(p);
      }
  }
  return std::count(smallest_coordinate.begin(), smallest_coordinate.end(), none) == 0;
}

} // namespace CGAL::internal::geometry_image

#endif // CGAL_GEOMETRY_IMAGE_INTERNAL_SAMPLE_PARAMETERIZED_MESH_H
