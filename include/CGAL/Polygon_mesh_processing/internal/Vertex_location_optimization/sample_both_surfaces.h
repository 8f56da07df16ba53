// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_BOTH_SURFACES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_BOTH_SURFACES_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Patch_tree.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/sample_reference.h>

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// A point of the reference that stands for an area of it, and the closest point of the remesh.
struct Reference_sample
{
  Point point;
  Vector normal;
  double area;
  Patch_foot foot; // the face of the remesh and the coordinates in it
};

// What the least squares fit takes beside the samples of the piecewise linear one: samples at the barycenters of the
// faces, and samples of the reference itself.
template <typename Foot>
struct Two_sided_samples
{
  Reference_samples<Foot> barycenter_samples;

  std::vector<Reference_sample> of_reference;
  std::vector<Index> first_of_face; // those of face f are of_reference[by_face[first_of_face[f]]], ...,
  std::vector<Index> by_face;       // of_reference[by_face[first_of_face[f + 1] - 1]]
  std::vector<double> face_paths;   // how far the vertices of each face have gone since its samples were computed
};

template <typename Surface, typename = void>
struct Has_area_samples : std::false_type {};

template <typename Surface>
struct Has_area_samples<Surface, std::void_t<decltype(std::declval<const Surface&>().area_samples(std::size_t()))>>
  : std::true_type {};

// Samples the reference, four points for a face of the remesh, if its type can be sampled.
template <typename ReferenceSurface, typename Foot>
void choose_reference_samples(const ReferenceSurface& reference,
                              const std::size_t number_of_faces,
                              Two_sided_samples<Foot>& samples)
{
  if constexpr(Has_area_samples<ReferenceSurface>::value)
    for(const auto& [foot, area] : reference.area_samples(4 * number_of_faces))
      samples.of_reference.push_back({ convert<Point>(reference.point(foot)), convert<Vector>(reference.normal(foot)),
                                       area, Patch_foot() });
}

// Walks from face to face of the remesh as long as that leads closer to `query`: from a foot on the boundary of its face
// to the faces around.
template <typename Foot>
void walk_on_remesh(const Optimization_state<Foot>& state, const Point& query, Patch_foot& foot)
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
    const std::array<Index, 3> face = mesh.faces[foot.patch];
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

// Groups the samples of the reference by the faces that they are closest to.
template <typename Foot>
void group_by_face(const std::size_t number_of_faces, Two_sided_samples<Foot>& samples)
{
  const std::vector<Reference_sample>& of_reference = samples.of_reference;
  samples.first_of_face.assign(number_of_faces + 1, 0);
  for(const Reference_sample& sample : of_reference)
    ++samples.first_of_face[sample.foot.patch + 1];
  for(std::size_t f = 0; f < number_of_faces; ++f)
    samples.first_of_face[f + 1] += samples.first_of_face[f];
  samples.by_face.resize(of_reference.size());
  std::vector<Index> end(samples.first_of_face.begin(), samples.first_of_face.end() - 1);
  for(Index i = 0; i < of_reference.size(); ++i)
    samples.by_face[end[of_reference[i].foot.patch]++] = i;
}

// Finds the closest points of the remesh to the samples of the reference with a tree.
template <typename ConcurrencyTag, typename Foot>
void find_closest_faces(const Optimization_state<Foot>& state, Two_sided_samples<Foot>& samples)
{
  const Mesh_arrays& mesh = state.mesh;
  std::vector<Reference_sample>& of_reference = samples.of_reference;
  if(!of_reference.empty())
  {
    std::vector<Flat_triangle> triangles(mesh.faces.size());
    for(std::size_t f = 0; f < mesh.faces.size(); ++f)
      triangles[f] = Flat_triangle(mesh.triangle(f));
    const Patch_tree<Flat_triangle> tree(std::move(triangles));
    for_each_index<ConcurrencyTag>(of_reference.size(), [&](std::size_t i)
    {
      of_reference[i].foot = tree.project(of_reference[i].point);
    });
  }
  samples.face_paths.assign(mesh.faces.size(), 0);
  group_by_face(mesh.faces.size(), samples);
}

// Finds them from the last closest points, but keeps those of faces whose vertices have gone no farther than `tolerance`.
template <typename ConcurrencyTag, typename Foot>
void walk_to_closest_faces(const Optimization_state<Foot>& state,
                           const double tolerance,
                           Two_sided_samples<Foot>& samples)
{
  const Mesh_arrays& mesh = state.mesh;
  std::vector<Reference_sample>& of_reference = samples.of_reference;
  std::vector<double>& paths = samples.face_paths;
  for_each_index<ConcurrencyTag>(mesh.faces.size(), [&](std::size_t f)
  {
    const std::array<Index, 3>& v = mesh.faces[f];
    if(paths[f] > tolerance) // its samples were computed in the last iteration
      paths[f] = 0;
    paths[f] += (std::max)({ norm(state.last_displacement(v[0])), norm(state.last_displacement(v[1])),
                             norm(state.last_displacement(v[2])) });
  });
  for_each_index<ConcurrencyTag>(of_reference.size(), [&](std::size_t i)
  {
    Reference_sample& sample = of_reference[i];
    if(paths[sample.foot.patch] > tolerance)
      walk_on_remesh(state, sample.point, sample.foot);
  });
  group_by_face(mesh.faces.size(), samples);
}

// The counterparts of `start_samples()`, `update_samples()` and `sample_closest_points()`. The samples at the vertices and
// midpoints are in `state` already.
template <typename ConcurrencyTag, typename ReferenceSurface>
void start_both_samples(const ReferenceSurface& reference,
                        const Sampling_tolerance& tolerance,
                        const Optimization_state<typename ReferenceSurface::Foot>& state,
                        Two_sided_samples<typename ReferenceSurface::Foot>& samples)
{
  const Mesh_arrays& mesh = state.mesh;
  samples.barycenter_samples = Reference_samples<typename ReferenceSurface::Foot>(mesh.faces.size());
  for_each_index<ConcurrencyTag>(mesh.faces.size(), [&](std::size_t f)
  {
    samples.barycenter_samples.project_near(f, reference, tolerance.distance, mesh.barycenter(f),
                                            state.midpoint_samples.feet[mesh.face_edges[f][0]]);
  });
  choose_reference_samples(reference, mesh.faces.size(), samples);
  find_closest_faces<ConcurrencyTag>(state, samples);
}

template <typename ConcurrencyTag, typename ReferenceSurface>
void update_both_samples(const ReferenceSurface& reference,
                         const Sampling_tolerance& tolerance,
                         const Optimization_state<typename ReferenceSurface::Foot>& state,
                         Two_sided_samples<typename ReferenceSurface::Foot>& samples)
{
  const Mesh_arrays& mesh = state.mesh;
  for_each_index<ConcurrencyTag>(mesh.faces.size(), [&](std::size_t f)
  {
    Vector displacement = NULL_VECTOR;
    for(Index i : mesh.faces[f])
      displacement = displacement + state.last_displacement(i) / 3;
    samples.barycenter_samples.update(f, reference, tolerance, mesh.barycenter(f), displacement);
  });
  walk_to_closest_faces<ConcurrencyTag>(state, tolerance.path, samples);
}

template <typename ConcurrencyTag, typename ReferenceSurface>
void sample_closest_points_of_both(const ReferenceSurface& reference,
                                   const Optimization_state<typename ReferenceSurface::Foot>& state,
                                   Two_sided_samples<typename ReferenceSurface::Foot>& samples)
{
  const Mesh_arrays& mesh = state.mesh;
  for_each_index<ConcurrencyTag>(mesh.faces.size(), [&](std::size_t f)
  {
    samples.barycenter_samples.project(f, reference, mesh.barycenter(f), samples.barycenter_samples.feet[f]);
  });
  walk_to_closest_faces<ConcurrencyTag>(state, -1, samples); // all
}

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_BOTH_SURFACES_H
