// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_TESSELLATE_PATCHES_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_TESSELLATE_PATCHES_H

#include "mesh_quality.h"
#include "test_meshes.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

// The point of patch i of a PN or flat triangle surface with these barycentric coordinates.
template <typename Surface>
Point patch_point(const Surface& surface, std::size_t i, double u, double v)
{
  typename Surface::Foot foot;
  foot.patch = static_cast<decltype(foot.patch)>(i);
  foot.coordinates = { u, v };
  return surface.point(foot);
}

// The patches of a surface, each in level * level triangles, for closest points by brute force. `tolerance` is about how far
// these triangles are from the patches.
template <typename Surface>
Mesh tessellate_patches(const Surface& surface, std::size_t number_of_patches, int level, double& tolerance)
{
  Soup soup;
  tolerance = 0;
  for(std::size_t patch = 0; patch < number_of_patches; ++patch)
  {
    const auto at = [&](double i, double j) { return patch_point(surface, patch, i / level, j / level); };
    std::map<std::pair<int, int>, std::size_t> index;
    for(int i = 0; i <= level; ++i)
      for(int j = 0; i + j <= level; ++j)
      {
        index[{ i, j }] = soup.points.size();
        soup.points.push_back(at(i, j));
      }
    for(int i = 0; i < level; ++i)
      for(int j = 0; i + j < level; ++j)
      {
        soup.triangles.push_back({ index[{ i, j }], index[{ i + 1, j }], index[{ i, j + 1 }] });
        if(i + j < level - 1)
          soup.triangles.push_back({ index[{ i + 1, j }], index[{ i + 1, j + 1 }], index[{ i, j + 1 }] });
        const Point p = at(i, j), q = at(i + 1, j), r = at(i, j + 1);
        tolerance =
          (std::max)({ tolerance, norm(at(i + 0.5, j) - CGAL::midpoint(p, q)), norm(at(i, j + 0.5) - CGAL::midpoint(p, r)),
                       norm(at(i + 0.5, j + 0.5) - CGAL::midpoint(q, r)) });
      }
  }
  tolerance *= 2; // for what is between the midpoints
  return make_mesh(soup);
}

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_TESSELLATE_PATCHES_H
