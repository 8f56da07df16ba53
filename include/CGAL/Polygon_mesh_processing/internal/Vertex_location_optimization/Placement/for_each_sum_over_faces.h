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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FOR_EACH_SUM_OVER_FACES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FOR_EACH_SUM_OVER_FACES_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Calls f(i, sum) for each vertex i of the mesh with the sum over its faces: terms(f)[k] is what face f adds to that of its
// vertex k. Sums start with Sum(). Blocks of vertices that follow each other are also close to each other: only the faces
// at the border of a block are visited for several of them. See `for_each_index()`.
template <typename ConcurrencyTag, typename Sum, typename Terms, typename F>
void for_each_sum_over_faces(const Remesh& mesh, const Terms& terms, const F& f)
{
  constexpr std::size_t block_size = 512; // of vertices

  for_each_block<ConcurrencyTag>(mesh.points.size(), block_size, [&](std::size_t begin, std::size_t end) {
    std::vector<std::size_t> faces; // those that begin before the block
    for(std::size_t i = begin; i < end; ++i)
      mesh.for_each_corner(i, [&](Index c) {
        if(mesh.first_vertex(c / 3) < begin)
          faces.push_back(c / 3);
      });
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());

    std::vector<Sum> sums(end - begin);
    const auto add_terms = [&](std::size_t face) {
      const std::array<Index, 3>& vertices = mesh.face(face);
      const std::array<Sum, 3> of_face = terms(face);
      for(int k = 0; k < 3; ++k)
        if(vertices[k] >= begin && vertices[k] < end)
          sums[vertices[k] - begin] += of_face[k];
    };
    for(std::size_t face : faces)
      add_terms(face);
    for(std::size_t face = mesh.first_face_from(begin), last = mesh.first_face_from(end); face < last; ++face)
      add_terms(face);

    for(std::size_t i = begin; i < end; ++i)
      f(i, sums[i - begin]);
  });
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FOR_EACH_SUM_OVER_FACES_H
