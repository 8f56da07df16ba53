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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MAXIMUM_FROM_REFERENCE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MAXIMUM_FROM_REFERENCE_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Farthest_of_patch.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/Patch_bounds.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Sampling/Area_samples.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The largest distance from the patches of a reference to the remesh. If the bounds with the initial points, and the
// displacements of the vertices, do not prove that the maximum has not grown, patches are bounded with the next points, and
// again only if the faces have changed since. Distances are measured only if these bounds do not suffice either.
template <typename Reference>
class Maximum_from_reference
{
  using Tree = Patch_tree<Flat_triangle>;
  using Bound = Bound_of_patch<Reference>;
  using Search = Farthest_of_patch<Reference>;
  using Indices = std::vector<Index>;

public:
  Maximum_from_reference(const Reference& reference, const Remesh& remesh) : m_reference(reference), m_remesh(remesh) {}

  // Finds the largest distance with the initial points, which has `tree`. `known` is one of them.
  template <typename ConcurrencyTag>
  void start(const Tree& tree, const double known)
  {
    m_has_changed.assign(m_remesh.number_of_faces(), true);
    constexpr double longest = 1e-11; // relative to the lengths of the edges: what is less is rounding
    m_negligible = longest * *std::max_element(m_remesh.lengths.begin(), m_remesh.lengths.end());
    const Bound bound(m_reference, m_remesh, m_remesh.initial_points, &tree);
    const Search search = make_search(bound, tree);
    m_initial.compute<ConcurrencyTag>(m_reference.number_of_patches(), [&](std::size_t i, Index& face, Indices& faces) {
      const double enough = known / 2 + m_negligible; // a smaller bound lasts for longer moves
      const float result = bound(i, face, enough, search.above(known), faces);
      if(!(result > search.above(known)) || !search.is_elsewhere(static_cast<Index>(i), known))
        return result;
      faces.clear();
      return 0.f;
    });
    m_initial_maximum = largest(search, m_initial.get(), known);
  }

  double initial_maximum() const { return m_initial_maximum; }

  // these faces have changed
  void update(const Indices& faces)
  {
    for(Index f : faces)
      m_has_changed[f] = true;
  }

  // Points that are farther away than the initial maximum with the vertices at the next points: one in each patch with any.
  template <typename ConcurrencyTag>
  std::vector<Far_point> find_beyond()
  {
    const Bound bound(m_reference, m_remesh, m_remesh.next_points);
    m_doubts = bound_again<ConcurrencyTag>(bound);
    m_has_changed.assign(m_has_changed.size(), false);
    const Indices open =
      find_indices<Sequential_tag>(m_doubts.size(), [&](std::size_t k) { return !m_doubts[k].is_settled; });
    std::vector<Far_point> result;
    if(open.empty())
      return result;
    const Tree tree = make_face_tree(m_remesh, m_remesh.next_points);
    const Search search = make_search(bound, tree);
    const std::size_t max_pieces = std::clamp<std::size_t>(most_pieces / open.size(), 8, most_pieces_of_patch);
    std::vector<Far_point> farthest(open.size());
    for_each_index<ConcurrencyTag>(open.size(),
                                   [&](std::size_t k) { farthest[k] = settle(m_doubts[open[k]], search, max_pieces); });
    for(std::size_t k = 0; k < open.size(); ++k)
      if(!m_doubts[open[k]].is_settled)
        result.push_back(farthest[k]);
    return result;
  }

  // The largest distance with the next points, which has `tree`. `known` is one of them.
  template <typename ConcurrencyTag>
  double maximum(const Tree& tree, const double known) const
  {
    const Bound bound(m_reference, m_remesh, m_remesh.next_points, &tree);
    const Search search = make_search(bound, tree);
    const std::vector<float> displacements = displacements_of_faces<ConcurrencyTag>();
    std::vector<float> bounds(m_initial.get().size());
    for_each_index<ConcurrencyTag>(bounds.size(), [&](std::size_t i) { bounds[i] = m_initial.with(displacements, i); });
    for(const Doubt& doubt : m_doubts)
      if(is_known(doubt))
        bounds[doubt.patch] = (std::min)(bounds[doubt.patch], doubt.bound);
    constexpr std::size_t block_size = 64;
    for_each_block<ConcurrencyTag>(bounds.size(), block_size, [&](std::size_t begin, std::size_t end) {
      Indices faces;
      for(std::size_t i = begin; i < end; ++i)
        if(bounds[i] > search.above(known))
        {
          Index face = m_initial.face(i);
          faces.clear();
          bounds[i] = (std::min)(bounds[i], bound(i, face, known, search.above(known), faces));
        }
    });
    return largest(search, bounds, known);
  }

private:
  // A patch whose initial bound does not suffice.
  struct Doubt
  {
    Index patch;
    bool is_settled; // nothing in it is too far away
    float bound;     // it depends on these faces
    Indices faces;
  };

  static constexpr std::size_t most_pieces = 16384, most_pieces_of_patch = 512; // they bound the time

  Search make_search(const Bound& bound, const Tree& tree) const
  {
    return Search(m_reference, bound.of_triangle(), tree, m_remesh.number_of_faces(), m_negligible);
  }

  // how far the vertices of each face have moved at most
  template <typename ConcurrencyTag>
  std::vector<float> displacements_of_faces() const
  {
    std::vector<float> result(m_remesh.number_of_faces());
    for_each_index<ConcurrencyTag>(result.size(), [&](std::size_t f) {
      double largest2 = 0;
      for(Index i : m_remesh.face(f))
        largest2 = (std::max)(largest2, squared_distance(m_remesh.initial_points[i], m_remesh.next_points[i]));
      result[f] = largest2 > 0 ? rounded_up(std::sqrt(largest2)) : 0;
    });
    return result;
  }

  // The patches that have or may have points beyond the initial maximum, with new bounds where faces have changed.
  template <typename ConcurrencyTag>
  std::vector<Doubt> bound_again(const Bound& bound)
  {
    const std::vector<float> displacements = displacements_of_faces<ConcurrencyTag>();
    const double limit = Search::above(m_initial_maximum, m_negligible);
    const Indices patches = find_indices<ConcurrencyTag>(
      m_initial.get().size(), [&](std::size_t i) { return m_initial.with(displacements, i) > limit; });
    std::vector<Doubt> doubts(patches.size());
    auto last = m_doubts.begin();
    for(std::size_t k = 0; k < doubts.size(); ++k)
    {
      doubts[k] = { patches[k], false, 0, {} };
      while(last != m_doubts.end() && last->patch < patches[k])
        ++last;
      if(last != m_doubts.end() && last->patch == patches[k])
        doubts[k] = std::move(*last);
    }
    for_each_index<ConcurrencyTag>(doubts.size(), [&](std::size_t k) {
      Doubt& doubt = doubts[k];
      if(doubt.is_settled && is_known(doubt))
        return;
      Index face = doubt.faces.empty() ? m_initial.face(doubt.patch) : doubt.faces.front();
      doubt.faces.clear();
      doubt.bound = bound(doubt.patch, face, limit, limit, doubt.faces);
      doubt.is_settled = doubt.bound <= limit;
    });
    return doubts;
  }

  bool is_known(const Doubt& doubt) const
  {
    return std::none_of(doubt.faces.begin(), doubt.faces.end(),
                        [&](Index f) { return f < m_has_changed.size() && m_has_changed[f]; });
  }

  // Searches the patch; returns the farthest point that was found.
  Far_point settle(Doubt& doubt, const Search& search, const std::size_t max_pieces) const
  {
    const Index hint = doubt.faces.front();
    doubt.faces.clear();
    const auto found = search(doubt.patch, hint, m_initial_maximum, true, max_pieces, doubt.faces);
    doubt.bound = rounded_up(found.bound);
    doubt.is_settled = !(found.farthest.distance > search.above(m_initial_maximum));
    return found.farthest;
  }

  // the largest distance, given the bounds of the patches, if it exceeds `known`
  double largest(const Search& search, const std::vector<float>& bounds, const double known) const
  {
    Indices promising =
      find_indices<Sequential_tag>(bounds.size(), [&](std::size_t i) { return bounds[i] > search.above(known); });
    std::sort(promising.begin(), promising.end(),
              [&](Index i, Index j) { return std::make_pair(-bounds[i], i) < std::make_pair(-bounds[j], j); });
    double result = known;
    std::size_t number_of_pieces = 0;
    for(Index i : promising)
    {
      if(!(bounds[i] > search.above(result)) || number_of_pieces > most_pieces)
        break;
      Indices faces;
      const auto found = search(i, m_initial.face(i), result, false, most_pieces_of_patch, faces);
      number_of_pieces += found.number_of_pieces;
      result = (std::max)(result, found.farthest.distance);
    }
    return result;
  }

  const Reference& m_reference;
  const Remesh& m_remesh;
  Initial_bounds m_initial;
  double m_initial_maximum = 0, m_negligible = 0;
  std::vector<Doubt> m_doubts;     // by increasing patches
  std::vector<char> m_has_changed; // of the faces: since the last call of `find_beyond()`
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MAXIMUM_FROM_REFERENCE_H
