// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_REFERENCE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_REFERENCE_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_element.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>

#include <boost/container/small_vector.hpp>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Polygon_mesh_processing {
namespace internal {
namespace vertex_location {

// Section 3.1: takes p_i and n_i from the reference at the foot of each vertex, m_ij at the foot of the midpoint of each
// edge; in the first iteration. Calls on_barycenter(f, foot) with the foot of the barycenter of each face f, at which
// samples are taken, too, if the state has them.
template <typename ConcurrencyTag, typename ReferenceSurface, typename OnBarycenter>
void start_samples(const ReferenceSurface& reference,
                   Optimization_state<Hint_of<ReferenceSurface>>& state,
                   const OnBarycenter& on_barycenter)
{
  const Mesh_arrays& mesh = state.mesh;
  for_each_element<ConcurrencyTag>(mesh,
    [&](std::size_t i)
    {
      state.vertex_samples.project(i, reference, mesh.points[i]);
    },
    [&](std::size_t e)
    {
      state.midpoint_samples.project(e, reference, mesh.midpoint(e), state.vertex_samples.hint(mesh.edges[e][0]));
    },
    [&](std::size_t f)
    {
      const Point query = mesh.barycenter(f);
      const auto foot = reference.project(convert<typename ReferenceSurface::Point_3>(query),
                                          state.midpoint_samples.hint(mesh.edge_at_first_vertex(f)));
      if(!state.barycenter_samples.empty())
        state.barycenter_samples.set_foot(f, reference, query, foot);
      on_barycenter(f, foot);
    });
}

// Takes samples from those of the iteration before, as exactly as `tolerance` says: n samples at the queries `query_at(k)`,
// which are the means of the vertices `vertices_at(k)` and move as these do on an average.
template <typename ConcurrencyTag, typename ReferenceSurface, typename VerticesAt, typename QueryAt>
void update_samples(const ReferenceSurface& reference,
                    const Sampling_tolerance& tolerance,
                    const Optimization_state<Hint_of<ReferenceSurface>>& state,
                    const std::size_t n,
                    const VerticesAt& vertices_at,
                    const QueryAt& query_at,
                    Reference_samples<Hint_of<ReferenceSurface>>& samples)
{
  constexpr std::size_t block_size = 256;
  for_each_block<ConcurrencyTag>(n, block_size, [&](std::size_t begin, std::size_t end)
  {
    boost::container::small_vector<std::size_t, block_size> is_due; // few: what they need of the reference is far away
    for(std::size_t k = begin; k < end; ++k)
    {
      const auto& vertices = vertices_at(k);
      const auto mean = [&](const auto& of_vertex)
      {
        Vector sum = NULL_VECTOR;
        for(Index i : vertices)
          sum = sum + of_vertex(i);
        return Vector(sum / static_cast<double>(vertices.size()));
      };
      const Vector displacement = mean([&](Index i) { return state.last_displacement(i); });
      const auto off_tangent_plane = [&]()
      {
        return mean([&](Index i)
        {
          const Vector& m = state.vertex_samples.normal(i);
          return Vector((state.last_displacement(i) * m) * m);
        });
      };
      if(samples.move(k, tolerance, displacement, off_tangent_plane))
      {
        is_due.push_back(k);
        prefetch_near(reference, samples.hint(k));
      }
    }
    for(std::size_t k : is_due)
      samples.update(k, reference, tolerance, query_at(k));
  });
}

// Takes all samples so.
template <typename ConcurrencyTag, typename ReferenceSurface>
void update_samples(const ReferenceSurface& reference,
                    const Sampling_tolerance& tolerance,
                    Optimization_state<Hint_of<ReferenceSurface>>& state)
{
  const Mesh_arrays& mesh = state.mesh;
  update_samples<ConcurrencyTag>(
    reference, tolerance, state, mesh.edges.size(), [&](std::size_t e) { return mesh.edges[e]; },
    [&](std::size_t e) { return mesh.midpoint(e); }, state.midpoint_samples);
  if(!state.barycenter_samples.empty())
    update_samples<ConcurrencyTag>(
      reference, tolerance, state, mesh.number_of_faces(), [&](std::size_t f) { return mesh.face(f); },
      [&](std::size_t f) { return mesh.barycenter(f); }, state.barycenter_samples);
  // the last, as the others read their normals
  update_samples<ConcurrencyTag>(
    reference, tolerance, state, mesh.points.size(),
    [](std::size_t i) { return std::array<Index, 1>{ static_cast<Index>(i) }; },
    [&](std::size_t i) { return mesh.points[i]; }, state.vertex_samples);
}

// Takes the samples at the closest points.
template <typename ConcurrencyTag, typename ReferenceSurface>
void sample_closest_points(const ReferenceSurface& reference, Optimization_state<Hint_of<ReferenceSurface>>& state)
{
  const Mesh_arrays& mesh = state.mesh;
  const auto project = [&](auto& samples, std::size_t k, const Point& query)
  {
    samples.project(k, reference, query, samples.hint(k));
  };

  for_each_element<ConcurrencyTag>(mesh,
    [&](std::size_t i) { project(state.vertex_samples, i, mesh.points[i]); },
    [&](std::size_t e) { project(state.midpoint_samples, e, mesh.midpoint(e)); },
    [&](std::size_t f)
    {
      if(!state.barycenter_samples.empty())
        project(state.barycenter_samples, f, mesh.barycenter(f));
    });
}

} // namespace vertex_location
} // namespace internal
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_SAMPLE_REFERENCE_H
