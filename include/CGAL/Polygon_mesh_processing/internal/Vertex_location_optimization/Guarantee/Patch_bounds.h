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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PATCH_BOUNDS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PATCH_BOUNDS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Distance_bound.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Piece_of_patch.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Flat_triangle.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Patch_tree.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Bounds the distance that the points of a patch of a reference have from the remesh, with its vertices at some points.
template <typename Reference>
class Bound_of_patch
{
public:
  // `tree` has the faces; without it they are found from those nearby alone
  Bound_of_patch(const Reference& reference,
                 const Remesh& remesh,
                 const std::vector<Point>& points,
                 const Patch_tree<Flat_triangle>* tree = nullptr)
    : m_reference(reference), m_remesh(remesh), m_points(points), m_bound(remesh, points), m_tree(tree)
  {}

  // Begins at `face`, which becomes one that is close to the patch. A bound of `enough` need not be better; where the center
  // seems to be beyond `limit` the closest face is searched for. Appends the faces that the bound depends on.
  float
  operator()(const std::size_t i, Index& face, const double enough, const double limit, std::vector<Index>& faces) const
  {
    const Index patch = static_cast<Index>(i);
    const Piece_of_patch piece = whole_patch(m_reference, patch);
    const double sag_of_patch = m_reference.patch(patch).deviation();
    const double bound = distance(piece.center(), face, limit) + piece.radius() + sag_of_patch; // no slope exceeds one
    if(bound <= enough)
    {
      faces.push_back(face);
      return rounded_up(bound);
    }
    return rounded_up(m_bound(piece.corners, face, enough - sag_of_patch, faces).distance + sag_of_patch);
  }

  const Distance_bound& of_triangle() const { return m_bound; }

private:
  // from a face that is close to p, which `face` becomes
  double distance(const Point& p, Index& face, const double limit) const
  {
    const double approached = face == no_index ? std::numeric_limits<double>::infinity() : approach(p, face);
    if(approached <= limit || m_tree == nullptr)
      return approached;
    const Patch_foot foot = m_tree->project(p, face);
    face = foot.patch;
    return std::sqrt(squared_distance(p, m_tree->point(foot)));
  }

  // Goes from face f straight to p, as if the remesh were flat; returns how far p is from the face where that ends.
  double approach(const Point& p, Index& f) const
  {
    constexpr int max_steps = 8; // it bounds the time where that leads nowhere
    for(int step = 0;; ++step)
    {
      const std::array<Point, 3> t = m_bound.face(f);
      const Coordinates projection = project_to_plane(t, p);
      const std::array<double, 3> lambda = projection.barycentric();
      const auto k = std::min_element(lambda.begin(), lambda.end()) - lambda.begin();
      const bool goes_on = step < max_steps && f < m_remesh.number_of_faces() && lambda[k] < 0;
      const Index across = goes_on ? m_bound.corner_across(3 * f + static_cast<Index>(k)) : no_index;
      if(across == no_index)
        return std::sqrt(squared_distance(p, point_at(t, closest_on_triangle(t, p, projection))));
      f = across / 3;
    }
  }

  const Reference& m_reference;
  const Remesh& m_remesh;
  const std::vector<Point>& m_points;
  const Distance_bound m_bound;
  const Patch_tree<Flat_triangle>* const m_tree;
};

// The bounds of all patches with the initial points, and the faces that they depend on: no distance grows by more than the
// vertices of these have moved.
class Initial_bounds
{
public:
  // bound(patch, face, faces) is that of a patch; `face` is near to the last one, in a row of them, or no_index
  template <typename ConcurrencyTag, typename Bound>
  void compute(const std::size_t number_of_patches, const Bound& bound)
  {
    m_bounds.resize(number_of_patches);
    m_ends.resize(number_of_patches);
    m_faces.assign((number_of_patches + block_size - 1) / block_size, {});
    for_each_block<ConcurrencyTag>(number_of_patches, block_size, [&](std::size_t begin, std::size_t end) {
      std::vector<Index>&faces = m_faces[begin / block_size], of_patch;
      Index face = no_index;
      for(std::size_t i = begin; i < end; ++i)
      {
        of_patch.clear();
        m_bounds[i] = bound(i, face, of_patch);
        faces.insert(faces.end(), of_patch.begin(), of_patch.end());
        m_ends[i] = static_cast<Index>(faces.size());
      }
      faces.shrink_to_fit();
    });
  }

  const std::vector<float>& get() const { return m_bounds; }

  // one of the faces of patch i; no_index if it has none
  Index face(const std::size_t i) const { return begin(i) == m_ends[i] ? no_index : m_faces[i / block_size][begin(i)]; }

  // of patch i, if the faces have moved by `displacements`
  float with(const std::vector<float>& displacements, const std::size_t i) const
  {
    float largest = 0;
    for(Index k = begin(i); k < m_ends[i]; ++k)
    {
      const Index f = m_faces[i / block_size][k];
      if(f < displacements.size()) // not one of the surroundings
        largest = (std::max)(largest, displacements[f]);
    }
    return m_bounds[i] + largest;
  }

private:
  Index begin(const std::size_t i) const { return i % block_size == 0 ? 0 : m_ends[i - 1]; }

  static constexpr std::size_t block_size = 64;

  std::vector<float> m_bounds;
  std::vector<std::vector<Index>> m_faces; // of the patches in each block
  std::vector<Index> m_ends;               // of the faces of each patch among them
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PATCH_BOUNDS_H
