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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MAKE_REFERENCE_PATCHES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MAKE_REFERENCE_PATCHES_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/boundary_curves.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/corner_normals.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Flat_triangle.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Patch_descriptors.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/PN_triangle.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/read_reference_mesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Reference_patches.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/named_parameters.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_parameters.h>

#include <array>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The creases of a reference: the edges that the user constrains, and the sharp ones unless only constrained edges are
// given.
template <typename ConcurrencyTag, typename TriangleMesh, typename NamedParameters>
std::vector<char> find_creases(const Mesh_arrays& mesh,
                               const Mesh_descriptors<TriangleMesh>& descriptors,
                               const std::vector<Vector>& face_normals,
                               const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  constexpr bool has_map = !is_default_parameter<NamedParameters, internal_np::edge_is_constrained_t>::value;
  constexpr bool has_angle = !is_default_parameter<NamedParameters, internal_np::sharpness_angle_t>::value;

  std::vector<char> is_crease(mesh.edges.size(), 0);
  if constexpr(has_angle || !has_map)
  {
    const double angle = to_double(choose_parameter(get_parameter(np, internal_np::sharpness_angle), 40.));
    is_crease = detect_creases<ConcurrencyTag>(mesh, face_normals, std::cos(angle * CGAL_PI / 180));
  }
  if constexpr(has_map)
  {
    const auto is_constrained = get_parameter(np, internal_np::edge_is_constrained);
    for(std::size_t e = 0; e < mesh.edges.size(); ++e)
      if(!mesh.is_diagonal(e) && get(is_constrained, descriptors.edges[e]))
        is_crease[e] = 1;
  }
  return is_crease;
}

// one flat triangle a face
template <typename ConcurrencyTag>
std::vector<Flat_triangle> make_flat_patches(const Mesh_arrays& mesh)
{
  std::vector<Flat_triangle> patches(mesh.number_of_faces());
  for_each_index<ConcurrencyTag>(patches.size(), [&](std::size_t f) { patches[f] = Flat_triangle(mesh.triangle(f)); });
  return patches;
}

// one curved PN triangle a face
template <typename ConcurrencyTag>
std::vector<PN_triangle>
make_PN_patches(const Mesh_arrays& mesh, const std::vector<Vector>& face_normals, const std::vector<char>& is_crease)
{
  Facets facets;
  std::vector<std::array<double, 3>> angles;
  Sector_graph graph;
  call_both<ConcurrencyTag>(
    [&] {
      facets = find_facets<ConcurrencyTag>(mesh, face_normals, is_crease);
      angles = compute_angles<ConcurrencyTag>(mesh);
    },
    [&] { graph = Sector_graph(mesh, is_crease); }); // which takes one thread
  graph.find_edges<ConcurrencyTag>(mesh, facets);
  const std::vector<Vector> sector_normals = compute_sector_normals<ConcurrencyTag>(face_normals, angles, facets, graph);
  const Patch_boundaries boundaries(mesh, facets, graph, sector_normals, ConcurrencyTag());

  std::vector<PN_triangle> patches(mesh.number_of_faces());
  for_each_index<ConcurrencyTag>(patches.size(), [&](std::size_t f) {
    std::array<PN_triangle::Corner, 3> corners;
    for(Index k = 0; k < 3; ++k)
    {
      const Index c = static_cast<Index>(3 * f + k);
      corners[k].point = mesh.points[mesh.vertex(c)];
      corners[k].normal = boundaries.normal(c);
      for(Index side = 0; side < 2; ++side) // to the next corner, and to the previous one
        corners[k].offsets[side] = boundaries.offset(mesh.face_edges[f][(k + 2 - side) % 3], c);
    }
    patches[f] = PN_triangle(corners);
  });
  return patches;
}

// The curves of the creases and borders, along the patches, one a face from `patches` on.
template <typename Patch>
Feature_curves make_feature_curves(const Mesh_arrays& mesh, const std::vector<char>& is_crease, const Patch* const patches)
{
  const auto is_feature = [&](Index e) {
    return mesh.edge_corners[e][0] != no_index && (is_crease[e] || mesh.is_border(e));
  };
  const auto curve_piece = [&](Index e) {
    // along the side opposite to the corner k of a face at the edge
    const Index corner = mesh.edge_corners[e][0];
    const auto at = [&](double t) {
      std::array<double, 3> lambda;
      lambda[corner % 3] = 0;
      lambda[(corner + 1) % 3] = 1 - t;
      lambda[(corner + 2) % 3] = t;
      return patches[corner / 3].point({ lambda[1], lambda[2] });
    };
    const Curve_piece piece(at(0), at(1. / 3), at(2. / 3), at(1));
    return mesh.vertex(Mesh_arrays::next(corner)) == mesh.edges[e][0] ? piece : piece.reversed();
  };
  return Feature_curves(mesh, is_feature, curve_piece);
}

// The patches of a tree, one a face, with their neighbors.
template <typename ConcurrencyTag, typename Patch>
Connected_patches<Patch>
connect_patches(const Mesh_arrays& mesh, const std::vector<Vector>& face_normals, Patch_tree<Patch> tree)
{
  std::vector<std::array<Index, 3>> neighbors(mesh.number_of_faces());
  std::vector<unsigned char> folds(mesh.number_of_faces(), 0);
  for_each_index<ConcurrencyTag>(mesh.number_of_faces(), [&](std::size_t f) {
    for(Index k = 0; k < 3; ++k)
    {
      const Index corner = neighbors[f][k] = mesh.corner_across(static_cast<Index>(3 * f + k));
      if(corner != no_index && face_normals[f] * face_normals[corner / 3] < 0)
        folds[f] = static_cast<unsigned char>(folds[f] | 1 << k);
    }
  });
  return { std::move(tree), std::move(neighbors), std::move(folds) };
}

// Whether the normals of a mesh can define a smooth surface: not if creases make up more than a third of the length of its
// edges.
inline bool is_recognizably_smooth(const Mesh_arrays& mesh, const std::vector<char>& is_crease)
{
  constexpr double largest_part = 1. / 3;
  double length = 0, length_of_creases = 0;
  for(std::size_t e = 0; e < mesh.edges.size(); ++e)
    if(!mesh.is_border(e))
    {
      const double d = std::sqrt(squared_distance(mesh.points[mesh.edges[e][0]], mesh.points[mesh.edges[e][1]]));
      length += d;
      length_of_creases += is_crease[e] ? d : 0;
    }
  return length_of_creases <= largest_part * length;
}

// The reference surface of `tmesh`, whose faces are the patches, or triangles of them; an empty one if `tmesh` is
// unsuitable. If `flat_unless_smooth`, the patches of a mesh that is not recognizably smooth are flat. Describes the patches
// if `patch_descriptors` is not null.
template <typename Patch, typename ConcurrencyTag, typename TriangleMesh, typename NamedParameters>
Reference_patches<Patch> make_reference_patches(const TriangleMesh& tmesh,
                                                const NamedParameters& np,
                                                Patch_descriptors<TriangleMesh>* const patch_descriptors,
                                                const bool flat_unless_smooth = false)
{
  const auto vpm = read_vertex_point_map(tmesh, np);
  Mesh_arrays mesh;
  Mesh_descriptors<TriangleMesh> descriptors;
  if(!read_reference_mesh(tmesh, vpm, mesh, descriptors))
    return {};
  if(patch_descriptors != nullptr)
    *patch_descriptors = Patch_descriptors<TriangleMesh>(tmesh, mesh, descriptors, ConcurrencyTag());
  const std::vector<Vector> face_normals = compute_face_normals<ConcurrencyTag>(mesh);
  const std::vector<char> is_crease = find_creases<ConcurrencyTag>(mesh, descriptors, face_normals, np);

  std::vector<Patch> patches;
  bool is_flat = true;
  if constexpr(std::is_same<Patch, Flat_triangle>::value)
    patches = make_flat_patches<ConcurrencyTag>(mesh);
  else
  {
    is_flat = flat_unless_smooth && !is_recognizably_smooth(mesh, is_crease);
    // where all edges are creases no normal goes beyond its face
    patches =
      make_PN_patches<ConcurrencyTag>(mesh, face_normals, is_flat ? std::vector<char>(mesh.edges.size(), 1) : is_crease);
  }

  Patch_tree<Patch> tree;
  Feature_curves curves;
  const Patch* const first = patches.data(); // where the patches stay when they are moved to the tree
  call_both<ConcurrencyTag>([&] { tree = Patch_tree<Patch>(std::move(patches), ConcurrencyTag()); },
                            [&] { curves = make_feature_curves(mesh, is_crease, first); });
  return { connect_patches<ConcurrencyTag>(mesh, face_normals, std::move(tree)), std::move(curves),
           is_flat ? Reference_surface_kind::FLAT : Reference_surface_kind::PN };
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MAKE_REFERENCE_PATCHES_H
