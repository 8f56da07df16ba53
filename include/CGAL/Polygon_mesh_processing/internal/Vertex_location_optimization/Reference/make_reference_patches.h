// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MAKE_REFERENCE_PATCHES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MAKE_REFERENCE_PATCHES_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/corner_normals.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Feature_curves.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/memory.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/named_parameters.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/PN_triangle.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_parameters.h>

#include <CGAL/assertions.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

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
  auto normal_or = [&](Index corner, const Vector& otherwise)
  {
    return corner == no_index ? otherwise : corner_normals[corner];
  };

  patches.resize(mesh.number_of_faces());
  for_each_index<ConcurrencyTag>(patches.size(), [&](std::size_t f)
  {
    std::array<PN_triangle::Corner, 3> corners;
    for(Index k = 0; k < 3; ++k)
    {
      const Index c = static_cast<Index>(3 * f + k);
      const Vector& n = corner_normals[c];
      // the edge to the next corner is the one opposite to the previous corner
      corners[k] = { mesh.points[mesh.vertex(c)], n,
                     normal_or(mesh.corner_across_previous(c), n), normal_or(mesh.corner_across_next(c), n) };
    }
    patches[f] = PN_triangle(corners);
  });
}

using Coinciding_feet = boost::container::small_vector<Patch_foot, 8>;

// A reference surface: a patch a face, and the curves of its creases and borders.
template <typename Patch>
struct Reference_patches
{
  // The closest point of the surface, which must not be empty. A foot of a point nearby as hint makes the search faster.
  Patch_foot project(const Point& query, const Patch_foot& hint) const
  {
    return tree.project(query, hint.patch == no_index ? no_index : approach(query, hint.patch));
  }

  // The closest point of the surface as far as walking from the patch of `hint` over neighbors leads closer. Much faster
  // than the tree, and the same point unless another sheet of the surface is closer.
  Patch_foot walk(const Point& query, const Patch_foot& hint) const
  {
    double distance2;
    Patch_foot foot = tree.project_to_patch(query, approach(query, hint.patch), distance2);
    while(step_to_neighbor(query, foot, distance2))
      ;
    return foot;
  }

  // asks for what a walk from `hint` reads first
  void prefetch(const Patch_foot& hint) const
  {
    vertex_location::prefetch(tree.patch(hint.patch));
    vertex_location::prefetch(neighbors[hint.patch]);
  }

  // The feet that are the same point: several where it is on a side or in a corner of its patch.
  Coinciding_feet coinciding_feet(const Patch_foot& foot) const
  {
    Coinciding_feet feet{ foot };
    for(std::size_t i = 0; i < feet.size(); ++i)
      for(Index k = 0; k < 3; ++k)
      {
        const Patch_foot other = foot_across(feet[i], k);
        const auto is_other = [&](const Patch_foot& f) { return f.patch == other.patch; };
        if(other.patch != no_index && std::none_of(feet.begin(), feet.end(), is_other))
          feet.push_back(other);
      }
    return feet;
  }

  double area() const
  {
    double sum = 0;
    for(Index i = 0; i < neighbors.size(); ++i)
      sum += tree.patch(i).area();
    return sum;
  }

  // Calls f(foot) for points spread evenly over the surface, each of which stands for `area`. The patches are in an order in
  // which neighbors follow each other: points at equal steps of the area are spread over the surface; those in one patch
  // follow a sequence of low discrepancy.
  template <typename F>
  void for_each_area_sample(const double area, const F& f) const
  {
    double passed = 0;
    std::size_t number = 0; // of the samples so far
    for(Index i = 0; i < neighbors.size(); ++i)
      for(passed += tree.patch(i).area(); (number + 0.5) * area < passed; ++number)
      {
        double integer_part;
        double u = std::modf(0.5 + 0.7548776662466927 * number, &integer_part);
        double v = std::modf(0.5 + 0.5698402909980532 * number, &integer_part);
        if(u + v > 1)
        {
          u = 1 - u;
          v = 1 - v;
        }
        f(Patch_foot{ i, { u, v } });
      }
  }

  Patch_tree<Patch> tree;
  std::vector<std::array<Index, 3>> neighbors; // the corner on the other side of the side opposite to each corner
  Feature_curves curves;

private:
  // The patch to which going from `patch` straight to `query` leads, as if the patches were flat.
  Index approach(const Point& query, Index patch) const
  {
    constexpr int max_steps = 16;
    for(int step = 0; step < max_steps; ++step)
    {
      const std::array<double, 3> lambda = tree.patch(patch).flat_coordinates(query).barycentric();
      const auto k = std::min_element(lambda.begin(), lambda.end()) - lambda.begin();
      if(!(lambda[k] < 0) || neighbors[patch][k] == no_index)
        break;
      patch = neighbors[patch][k] / 3;
    }
    return patch;
  }

  // The same point in the neighbor across side k; in none if the foot is not on that side or there is no neighbor.
  Patch_foot foot_across(const Patch_foot& foot, const Index k) const
  {
    constexpr double on_side = 1e-12;
    const std::array<double, 3> lambda = foot.coordinates.barycentric();
    const Index corner = neighbors[foot.patch][k];
    if(lambda[k] > on_side || corner == no_index)
      return {};
    // the common side runs the other way in the neighbor
    std::array<double, 3> mu;
    mu[corner % 3] = 0;
    mu[(corner + 1) % 3] = lambda[(k + 2) % 3];
    mu[(corner + 2) % 3] = lambda[(k + 1) % 3];
    return { corner / 3, { mu[1], mu[2] } };
  }

  bool step_to_neighbor(const Point& query, Patch_foot& foot, double& squared_distance) const
  {
    for(Index k = 0; k < 3; ++k)
    {
      Patch_foot neighbor = foot_across(foot, k);
      if(neighbor.patch != no_index &&
         tree.patch(neighbor.patch).improve_foot_from(query, neighbor.coordinates, squared_distance))
      {
        foot = neighbor;
        return true;
      }
    }
    return false;
  }
};

// The reference surface of `tmesh`; an empty one if `tmesh` is unsuitable.
template <typename Patch, typename ConcurrencyTag, typename TriangleMesh, typename NamedParameters>
Reference_patches<Patch> make_reference_patches(const TriangleMesh& tmesh, const NamedParameters& np)
{
  const auto vpm = read_vertex_point_map(tmesh, np);
  const bool is_valid = is_valid_input(tmesh, vpm);
  CGAL_precondition(is_valid);
  if(!is_valid)
    return {};

  Mesh_descriptors<TriangleMesh> descriptors;
  const Mesh_arrays mesh = make_mesh_arrays(tmesh, vpm, descriptors);
  const std::vector<Vector> face_normals = compute_face_normals<ConcurrencyTag>(mesh);
  const std::vector<char> is_crease = find_creases<ConcurrencyTag>(mesh, descriptors, face_normals, np);

  std::vector<Patch> patches;
  make_patches<ConcurrencyTag>(mesh, face_normals, is_crease, patches);

  auto is_feature = [&](Index e)
  {
    return mesh.edge_corners[e][0] != no_index && (is_crease[e] || mesh.is_border(e));
  };
  auto curve_piece = [&](Index e)
  {
    // along the side opposite to the corner k of a face at the edge
    const Index corner = mesh.edge_corners[e][0];
    auto at = [&](double t)
    {
      std::array<double, 3> lambda;
      lambda[corner % 3] = 0;
      lambda[(corner + 1) % 3] = 1 - t;
      lambda[(corner + 2) % 3] = t;
      return patches[corner / 3].point({ lambda[1], lambda[2] });
    };
    const Curve_piece piece(at(0), at(1. / 3), at(2. / 3), at(1));
    return mesh.vertex(Mesh_arrays::next(corner)) == mesh.edges[e][0] ? piece : piece.reversed();
  };
  Reference_patches<Patch> result;
  result.curves = Feature_curves::make(mesh, is_feature, curve_piece);
  result.neighbors.resize(mesh.number_of_faces());
  for_each_index<ConcurrencyTag>(mesh.number_of_faces(), [&](std::size_t f)
  {
    for(Index k = 0; k < 3; ++k)
      result.neighbors[f][k] = mesh.corner_across(static_cast<Index>(3 * f + k));
  });
  result.tree = Patch_tree<Patch>(std::move(patches));
  return result;
}

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MAKE_REFERENCE_PATCHES_H
