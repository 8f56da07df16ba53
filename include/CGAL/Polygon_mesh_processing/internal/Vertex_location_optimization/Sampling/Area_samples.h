// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLES_OF_REFERENCE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLES_OF_REFERENCE_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Patch_tree.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// A point of the reference and the closest point of the remesh.
struct Reference_sample
{
  Point point;
  Patch_foot foot; // the face of the remesh and the coordinates in it
};

// What the least squares fit takes beside the samples at the vertices, midpoints and barycenters of the remesh.
struct Samples_of_reference
{
  std::vector<Reference_sample> samples;
  std::vector<Vector> normals; // of the reference there
  double area = 0; // of the reference, that each of them stands for
  std::vector<Index> first_of_face; // those of face f are samples[by_face[first_of_face[f]]], ...,
  std::vector<Index> by_face;       // samples[by_face[first_of_face[f + 1] - 1]]
  std::vector<double> face_paths;   // how far the vertices of each face have gone since its samples were computed
};

template <typename Surface, typename = void>
struct Has_area_samples : std::false_type {};

template <typename Surface>
struct Has_area_samples<Surface, std::void_t<decltype(std::declval<const Surface&>().area())>>
  : std::true_type {};

// Samples the reference, six points for a face of the remesh, if its type can be sampled: without their normals, which
// are not needed before the closest points on the remesh have been found, with much memory.
template <typename ReferenceSurface>
void choose_reference_samples(const ReferenceSurface& reference,
                              const std::size_t number_of_faces,
                              Samples_of_reference& of_reference)
{
  if constexpr(Has_area_samples<ReferenceSurface>::value)
  {
    const std::size_t number_of_samples = 6 * number_of_faces;
    of_reference.area = reference.area() / number_of_samples;
    if(!(of_reference.area > 0))
      return;
    of_reference.samples.reserve(number_of_samples);
    reference.for_each_area_sample(of_reference.area, [&](const auto& foot)
    {
      of_reference.samples.push_back({ convert<Point>(reference.point(foot)), Patch_foot() });
    });
  }
}

// Takes the normals; sample i was chosen as the order[i]-th.
template <typename ReferenceSurface>
void take_normals(const ReferenceSurface& reference,
                  const std::vector<Index>& order,
                  Samples_of_reference& of_reference)
{
  if constexpr(Has_area_samples<ReferenceSurface>::value)
  {
    if(order.empty())
      return;
    std::vector<Index> place(order.size());
    for(Index i = 0; i < order.size(); ++i)
      place[order[i]] = i;
    of_reference.normals.resize(order.size());
    auto next = place.begin();
    reference.for_each_area_sample(of_reference.area, [&](const auto& foot)
    {
      if(next != place.end()) // should rounding make one more of them now
        of_reference.normals[*next++] = convert<Vector>(reference.normal(foot));
    });
  }
}

// Walks from face to face of the remesh as long as that leads closer to `query`: from a foot on the boundary of its face
// to the faces around.
template <typename Hint>
void walk_on_remesh(const Optimization_state<Hint>& state, const Point& query, Patch_foot& foot)
{
  constexpr double on_boundary = 1e-12;
  const Mesh_arrays& mesh = state.mesh;
  foot.coordinates = closest_on_triangle(mesh.triangle(foot.patch), query);
  double distance = squared_distance(query, point_at(mesh.triangle(foot.patch), foot.coordinates));
  for(bool is_closer = true; is_closer; )
  {
    is_closer = false;
    const std::array<double, 3> lambda = foot.coordinates.barycentric();
    if(*std::min_element(lambda.begin(), lambda.end()) > on_boundary)
      return;
    const std::array<Index, 3> face = mesh.face(foot.patch);
    for(int k = 0; k < 3; ++k)
      if(lambda[k] > on_boundary)
        state.for_each_corner(face[k], [&](Index c)
        {
          const std::array<Point, 3> t = mesh.triangle(c / 3);
          const Coordinates x = closest_on_triangle(t, query);
          const double d = squared_distance(query, point_at(t, x));
          if(d < distance)
          {
            distance = d;
            foot = { c / 3, x };
            is_closer = true;
          }
        });
  }
}

// Groups the samples by the faces that they are closest to.
inline void group_by_face(const std::size_t number_of_faces, Samples_of_reference& of_reference)
{
  const std::vector<Reference_sample>& samples = of_reference.samples;
  std::vector<Index>& first_of_face = of_reference.first_of_face;
  first_of_face.assign(number_of_faces + 1, 0);
  for(const Reference_sample& sample : samples)
    ++first_of_face[sample.foot.patch + 1];
  for(std::size_t f = 0; f < number_of_faces; ++f)
    first_of_face[f + 1] += first_of_face[f];
  of_reference.by_face.resize(samples.size());
  std::vector<Index> end(first_of_face.begin(), first_of_face.end() - 1);
  for(Index i = 0; i < samples.size(); ++i)
    of_reference.by_face[end[samples[i].foot.patch]++] = i;
}

// Puts the samples, which are grouped by face, in the order of the faces, as most of them stay with their faces. In place:
// there are many.
inline void sort_by_face(Samples_of_reference& of_reference)
{
  std::vector<Reference_sample>& samples = of_reference.samples;
  std::vector<Index>& by_face = of_reference.by_face;
  for(Index first = 0; first < samples.size(); ++first)
  {
    // along a cycle of the permutation
    const Reference_sample first_sample = samples[first];
    Index i = first;
    for(Index next = by_face[i]; next != first; next = by_face[i])
    {
      samples[i] = samples[next];
      by_face[i] = i;
      i = next;
    }
    samples[i] = first_sample;
    by_face[i] = i;
  }
}

// Finds the closest points of the remesh to the samples of the reference with a tree. Neighbors among the samples follow
// each other: the face of one is a hint for the next.
template <typename ConcurrencyTag, typename Hint>
void find_closest_faces(const Optimization_state<Hint>& state, std::vector<Reference_sample>& samples)
{
  const Mesh_arrays& mesh = state.mesh;
  if(samples.empty())
    return;

  std::vector<Flat_triangle> triangles(mesh.number_of_faces());
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    triangles[f] = Flat_triangle(mesh.triangle(f));
  const Patch_tree<Flat_triangle> tree(std::move(triangles));
  constexpr std::size_t block_size = 64;
  for_each_block<ConcurrencyTag>(samples.size(), block_size, [&](std::size_t begin, std::size_t end)
  {
    Index hint = no_index;
    for(std::size_t i = begin; i < end; ++i)
    {
      samples[i].foot = tree.project(samples[i].point, hint);
      hint = samples[i].foot.patch;
    }
  });
}

// Samples the reference, in the first iteration.
template <typename ConcurrencyTag, typename ReferenceSurface>
void start_samples_of_reference(const ReferenceSurface& reference,
                                const Optimization_state<Hint_of<ReferenceSurface>>& state,
                                Samples_of_reference& of_reference)
{
  const std::size_t number_of_faces = state.mesh.number_of_faces();
  choose_reference_samples(reference, number_of_faces, of_reference);
  find_closest_faces<ConcurrencyTag>(state, of_reference.samples);
  of_reference.face_paths.assign(number_of_faces, 0);
  group_by_face(number_of_faces, of_reference);
  take_normals(reference, of_reference.by_face, of_reference);
  sort_by_face(of_reference);
}

// Finds the closest points of the remesh from the last ones, but keeps those on faces whose vertices have gone no farther
// than `tolerance`.
template <typename ConcurrencyTag, typename Hint>
void walk_to_closest_faces(const Optimization_state<Hint>& state,
                           const double tolerance,
                           Samples_of_reference& of_reference)
{
  const Mesh_arrays& mesh = state.mesh;
  std::vector<Reference_sample>& samples = of_reference.samples;
  std::vector<double>& paths = of_reference.face_paths;
  for_each_index<ConcurrencyTag>(mesh.number_of_faces(), [&](std::size_t f)
  {
    const std::array<Index, 3> v = mesh.face(f);
    if(paths[f] > tolerance) // its samples were computed in the last iteration
      paths[f] = 0;
    paths[f] += (std::max)({ norm(state.last_displacement(v[0])), norm(state.last_displacement(v[1])),
                             norm(state.last_displacement(v[2])) });
  });
  for_each_index<ConcurrencyTag>(samples.size(), [&](std::size_t i)
  {
    Reference_sample& sample = samples[i];
    if(paths[sample.foot.patch] > tolerance)
      walk_on_remesh(state, sample.point, sample.foot);
  });
  group_by_face(mesh.number_of_faces(), of_reference);
}

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLES_OF_REFERENCE_H
