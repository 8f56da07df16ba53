// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MAKE_REFERENCE_PATCHES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MAKE_REFERENCE_PATCHES_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/corner_normals.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Flat_triangle.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/PN_triangle.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Reference_patches.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/named_parameters.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_mesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_parameters.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The creases of a reference: the edges that the user constrains, and those that are sharp unless the user leaves it at
// the constrained ones.
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
    const double angle = to_double(choose_parameter(get_parameter(np, internal_np::sharpness_angle), 45.));
    is_crease = detect_creases<ConcurrencyTag>(mesh, face_normals, std::cos(angle * CGAL_PI / 180));
  }
  if constexpr(has_map)
  {
    const auto is_constrained = get_parameter(np, internal_np::edge_is_constrained);
    for(std::size_t e = 0; e < mesh.edges.size(); ++e)
      if(get(is_constrained, descriptors.edges[e]))
        is_crease[e] = 1;
  }
  return is_crease;
}

// one flat triangle a face
template <typename ConcurrencyTag>
void make_patches(const Mesh_arrays& mesh,
                  const std::vector<Vector>& /* face_normals */,
                  const std::vector<char>& /* is_crease */,
                  std::vector<Flat_triangle>& patches)
{
  patches.resize(mesh.number_of_faces());
  for_each_index<ConcurrencyTag>(patches.size(), [&](std::size_t f) { patches[f] = Flat_triangle(mesh.triangle(f)); });
}

// one curved PN triangle a face
template <typename ConcurrencyTag>
void make_patches(const Mesh_arrays& mesh,
                  const std::vector<Vector>& face_normals,
                  const std::vector<char>& is_crease,
                  std::vector<PN_triangle>& patches)
{
  const std::vector<Vector> corner_normals = compute_corner_normals<ConcurrencyTag>(mesh, face_normals, is_crease);
  auto normal_or = [&](Index corner, const Vector& otherwise) {
    return corner == no_index ? otherwise : corner_normals[corner];
  };

  patches.resize(mesh.number_of_faces());
  for_each_index<ConcurrencyTag>(patches.size(), [&](std::size_t f) {
    std::array<PN_triangle::Corner, 3> corners;
    for(Index k = 0; k < 3; ++k)
    {
      const Index c = static_cast<Index>(3 * f + k);
      const Vector& n = corner_normals[c];
      // the edge to the next corner is the one opposite to the previous corner
      corners[k] = { mesh.points[mesh.vertex(c)], n, normal_or(mesh.corner_across_previous(c), n),
                     normal_or(mesh.corner_across_next(c), n) };
    }
    patches[f] = PN_triangle(corners);
  });
}

// The reference surface of `tmesh`; an empty one if `tmesh` is unsuitable.
template <typename Patch, typename ConcurrencyTag, typename TriangleMesh, typename NamedParameters>
Reference_patches<Patch> make_reference_patches(const TriangleMesh& tmesh, const NamedParameters& np)
{
  const auto vpm = read_vertex_point_map(tmesh, np);
  Mesh_arrays mesh;
  Mesh_descriptors<TriangleMesh> descriptors;
  if(!read_mesh(tmesh, vpm, mesh, descriptors))
    return {};
  const std::vector<Vector> face_normals = compute_face_normals<ConcurrencyTag>(mesh);
  const std::vector<char> is_crease = find_creases<ConcurrencyTag>(mesh, descriptors, face_normals, np);

  std::vector<Patch> patches;
  make_patches<ConcurrencyTag>(mesh, face_normals, is_crease, patches);

  auto is_feature = [&](Index e) { return mesh.edge_corners[e][0] != no_index && (is_crease[e] || mesh.is_border(e)); };
  auto curve_piece = [&](Index e) {
    // along the side opposite to the corner k of a face at the edge
    const Index corner = mesh.edge_corners[e][0];
    auto at = [&](double t) {
      std::array<double, 3> lambda;
      lambda[corner % 3] = 0;
      lambda[(corner + 1) % 3] = 1 - t;
      lambda[(corner + 2) % 3] = t;
      return patches[corner / 3].point({ lambda[1], lambda[2] });
    };
    const Curve_piece piece(at(0), at(1. / 3), at(2. / 3), at(1));
    return mesh.vertex(Mesh_arrays::next(corner)) == mesh.edges[e][0] ? piece : piece.reversed();
  };
  Feature_curves curves(mesh, is_feature, curve_piece);

  std::vector<std::array<Index, 3>> neighbors(mesh.number_of_faces());
  for_each_index<ConcurrencyTag>(mesh.number_of_faces(), [&](std::size_t f) {
    for(Index k = 0; k < 3; ++k)
      neighbors[f][k] = mesh.corner_across(static_cast<Index>(3 * f + k));
  });
  return { std::move(patches), std::move(neighbors), std::move(curves) };
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MAKE_REFERENCE_PATCHES_H
