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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FARTHEST_OF_PATCH_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FARTHEST_OF_PATCH_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Distance_bound.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Piece_of_patch.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Flat_triangle.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Patch_tree.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/triangle_coordinates.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// A point of the reference, and the face of the remesh or its surroundings that is closest to it.
struct Far_point
{
  Point point = ORIGIN;
  Index face = no_index;
  double distance = 0;
};

// Finds the point of a patch that is farthest from a remesh, or one that is farther away than a limit, by branch and bound:
// a patch is cut into four pieces, recursively, until `Distance_bound` proves that nothing is farther away.
template <typename Reference>
class Farthest_of_patch
{
  using Tree = Patch_tree<Flat_triangle>;

public:
  // of the faces in `tree`, which are those of `bound`; what is below `negligible` is rounding
  Farthest_of_patch(const Reference& reference,
                    const Distance_bound& bound,
                    const Tree& tree,
                    const std::size_t number_of_faces,
                    const double negligible)
    : m_reference(reference), m_bound(bound), m_tree(tree), m_number_of_faces(number_of_faces), m_negligible(negligible)
  {}

  struct Result
  {
    Far_point farthest; // of the points that were looked at, and are closest to the remesh
    double bound;       // of all distances, unless that took too many pieces
    bool is_certain;
    std::size_t number_of_pieces;
  };

  // Looks for a distance above `limit`, the largest one or any; appends the faces that the bound depends on. `hint` is a
  // face nearby.
  Result operator()(const Index patch,
                    const Index hint,
                    const double limit,
                    const bool is_any_enough,
                    const std::size_t max_pieces,
                    std::vector<Index>& faces) const
  {
    Result result{ {}, 0, true, 0 };
    std::vector<Part> heap;
    const auto threshold = [&] { return above((std::max)(limit, result.farthest.distance)); };
    const auto add = [&](const Piece_of_patch& piece) {
      ++result.number_of_pieces;
      Part part = bounded(patch, piece, m_tree.project(piece.center(), hint).patch, threshold(), faces);
      if(part.bound > threshold())
      {
        heap.push_back(part);
        std::push_heap(heap.begin(), heap.end());
      }
      else
        result.bound = (std::max)(result.bound, part.bound);
    };
    add(whole_patch(m_reference, patch));
    while(!heap.empty() && heap.front().bound > threshold() && !(is_any_enough && result.farthest.distance > above(limit)))
    {
      std::pop_heap(heap.begin(), heap.end());
      const Part part = heap.back();
      heap.pop_back();
      if(is_done(patch, part, threshold, result, faces))
        continue;
      if(result.number_of_pieces >= max_pieces)
      {
        result.is_certain = false;
        break;
      }
      for(const Piece_of_patch& piece : quarters(patch, part.piece))
        add(piece);
    }
    if(!heap.empty())
      result.bound = (std::max)(result.bound, heap.front().bound);
    return result;
  }

  // a value larger than a distance by more than its error
  double above(const double distance) const { return above(distance, m_negligible); }
  static double above(const double distance, const double negligible)
  {
    constexpr double tolerance = 0.001; // it saves the last few pieces
    return (1 + tolerance) * distance + negligible;
  }

  // whether the surroundings are closest to a patch that may have points beyond `limit`
  bool is_elsewhere(const Index patch, const double limit) const
  {
    if(m_tree.patches().size() == m_number_of_faces)
      return false;
    std::vector<Index> faces;
    const Result result = (*this)(patch, no_index, limit, true, 1, faces);
    return result.is_certain && !(result.bound > 0);
  }

private:
  struct Part
  {
    bool operator<(const Part& other) const { return bound < other.bound; }

    Piece_of_patch piece;
    Coordinates farthest; // where it may be farthest away, in the patch
    Index face;           // nearby
    double bound;         // of the distance in it
  };

  Part bounded(
    const Index patch, const Piece_of_patch& piece, const Index face, const double limit, std::vector<Index>& faces) const
  {
    const double sag_of_piece = sag(m_reference, patch, piece);
    const Distance_bound::Result result = m_bound(piece.corners, face, limit - sag_of_piece, faces);
    return { piece, piece.at(closest_on_triangle(piece.corners, result.point)), face, result.distance + sag_of_piece };
  }

  // Measures where a part may be farthest away. The part is settled if no point of it can be much farther away, as no slope
  // exceeds one, or if the surroundings are closest.
  template <typename Threshold>
  bool
  is_done(const Index patch, const Part& part, const Threshold& threshold, Result& result, std::vector<Index>& faces) const
  {
    const Point p = m_reference.point({ patch, part.farthest });
    const Patch_foot foot = m_tree.project(p, part.face);
    const double distance = norm(p - m_tree.point(foot));
    if(foot.patch >= m_number_of_faces && part.face >= m_number_of_faces)
      return true;
    if(foot.patch < m_number_of_faces && distance > result.farthest.distance)
      result.farthest = { p, foot.patch, distance };
    const double bound = distance + part.piece.length() + 2 * sag(m_reference, patch, part.piece);
    if(bound > threshold())
      return false;
    faces.push_back(foot.patch);
    result.bound = (std::max)(result.bound, bound);
    return true;
  }

  std::array<Piece_of_patch, 4> quarters(const Index patch, const Piece_of_patch& piece) const
  {
    const std::array<Coordinates, 3>& c = piece.coordinates;
    const std::array<Coordinates, 3> m{ { piece.at({ 0.5, 0.5 }), piece.at({ 0, 0.5 }), piece.at({ 0.5, 0 }) } };
    const auto make = [&](const Coordinates& x, const Coordinates& y, const Coordinates& z) {
      return piece_of_patch(m_reference, patch, { { x, y, z } });
    };
    return { make(c[0], m[2], m[1]), make(m[2], c[1], m[0]), make(m[1], m[0], c[2]), make(m[0], m[1], m[2]) };
  }

  const Reference& m_reference;
  const Distance_bound& m_bound;
  const Tree& m_tree;
  const std::size_t m_number_of_faces;
  const double m_negligible;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FARTHEST_OF_PATCH_H
