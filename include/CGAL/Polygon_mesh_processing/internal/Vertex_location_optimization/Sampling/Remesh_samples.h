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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_REMESH_SAMPLES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_REMESH_SAMPLES_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/Distance_samples.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/Face_orientation.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Reference_access.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Sampling/Closest_points.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_element.h>

#include <boost/container/small_vector.hpp>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The properties of M_0 that the first samples measure.
struct Initial_measure
{
  Distance_samples distances;
  std::vector<Face_orientation> orientations; // at the barycenters of the faces
};

// The samples that a placement takes beside those at the vertices and at the midpoints of the edges.
enum class Sample_set
{
  MIDPOINT_LOCATIONS,       // the midpoints without normals
  MIDPOINTS_AND_BARYCENTERS // and with the barycenters of the faces
};

// The samples at the vertices and midpoints for good.
template <typename Hint>
struct Remesh_sample_offsets
{
  Sample_offsets<Hint> vertices, midpoints;
};

// Section 3.1: the points of the reference closest to the vertices of the remesh, to the midpoints of its edges and, if the
// placement takes them, to the barycenters of its faces; always for `remesh.points`.
template <typename Reference>
class Remesh_samples
{
public:
  using Hint = typename Reference::Hint;
  using Samples = Closest_points<Hint>;

  Remesh_samples(const Remesh& remesh, const Sample_set set)
    : vertices(remesh.points.size(), true), midpoints(remesh.edges.size(), set == Sample_set::MIDPOINTS_AND_BARYCENTERS),
      barycenters(set == Sample_set::MIDPOINTS_AND_BARYCENTERS ? remesh.number_of_faces() : 0, true)
  {}

  // Takes the first samples. The points closest to the barycenters are always computed, to measure M_0.
  template <typename ConcurrencyTag>
  Initial_measure start(const Reference& reference, const Remesh& remesh)
  {
    Initial_measure measure{ Distance_samples(remesh), std::vector<Face_orientation>(remesh.number_of_faces()) };
    for_each_element<ConcurrencyTag>(
      remesh,
      [&](std::size_t i) { measure.distances.at_vertices[i] = take_first(vertices, i, reference, remesh.points[i]); },
      [&](std::size_t e) {
        measure.distances.at_midpoints[e] =
          take_first(midpoints, e, reference, remesh.midpoint(e), vertices.hint(remesh.edges[e][0]));
      },
      [&](std::size_t f) {
        const Point query = remesh.barycenter(f);
        const auto foot = reference.project(query, midpoints.hint(remesh.edge_at_first_vertex(f)));
        if(!barycenters.empty())
          barycenters.set_foot(f, reference, query, foot);
        const Point barycenter = point_at(remesh.triangle(f), barycenter_coordinates);
        measure.distances.largest_inside[f] = distance_to_foot(barycenter, reference, foot);
        measure.orientations[f] = orientation_at(reference, foot, remesh.area_normal(f));
      });
    return measure;
  }

  // Takes the samples from those of the iteration before, as exactly as `tolerance` says.
  template <typename ConcurrencyTag>
  void update(const Reference& reference, const Remesh& remesh, const Sampling_tolerance& tolerance)
  {
    update<ConcurrencyTag>(
      reference, remesh, tolerance, midpoints, [&](std::size_t e) { return remesh.edges[e]; },
      [&](std::size_t e) { return remesh.midpoint(e); });
    update<ConcurrencyTag>(
      reference, remesh, tolerance, barycenters, [&](std::size_t f) { return remesh.face(f); },
      [&](std::size_t f) { return remesh.barycenter(f); });
    // the last, as the others read their normals
    update<ConcurrencyTag>(
      reference, remesh, tolerance, vertices, [](std::size_t i) { return std::array<Index, 1>{ static_cast<Index>(i) }; },
      [&](std::size_t i) { return remesh.points[i]; });
  }

  // Takes the samples at the closest points, wherever they are.
  template <typename ConcurrencyTag>
  void project(const Reference& reference, const Remesh& remesh)
  {
    const auto project_sample = [&](Samples& samples, std::size_t k, const Point& query) {
      samples.project(k, reference, query, samples.hint(k));
    };
    for_each_element<ConcurrencyTag>(
      remesh, [&](std::size_t i) { project_sample(vertices, i, remesh.points[i]); },
      [&](std::size_t e) { project_sample(midpoints, e, remesh.midpoint(e)); },
      [&](std::size_t f) {
        if(!barycenters.empty())
          project_sample(barycenters, f, remesh.barycenter(f));
      });
  }

  Remesh_sample_offsets<Hint> take_offsets() &&
  {
    return { std::move(vertices).take_offsets(), std::move(midpoints).take_offsets() };
  }

  Samples vertices;    // p_i and n_i
  Samples midpoints;   // m_ij
  Samples barycenters; // empty if the placement takes none

private:
  // takes sample k of a query, and returns the signed distance; `hint` is the foot of a point nearby
  template <typename... Hints>
  static double
  take_first(Samples& samples, std::size_t k, const Reference& reference, const Point& query, const Hints&... hint)
  {
    const auto foot = reference.project(query, hint...);
    samples.set_foot(k, reference, query, foot);
    return signed_distance_to_foot(query, reference, foot);
  }

  // Updates samples at queries `query_at(k)`, which are the means of the vertices `vertices_at(k)` and move as these do on
  // an average.
  template <typename ConcurrencyTag, typename VerticesAt, typename QueryAt>
  void update(const Reference& reference,
              const Remesh& remesh,
              const Sampling_tolerance& tolerance,
              Samples& samples,
              const VerticesAt& vertices_at,
              const QueryAt& query_at)
  {
    constexpr std::size_t block_size = 256;
    const auto length_at = [&](std::size_t k) { return remesh.length_at(vertices_at(k)); };
    for_each_block<ConcurrencyTag>(samples.size(), block_size, [&](std::size_t begin, std::size_t end) {
      boost::container::small_vector<std::size_t, block_size> is_due; // few, and their patches are far apart in memory
      for(std::size_t k = begin; k < end; ++k)
      {
        const auto& of_sample = vertices_at(k);
        const auto mean = [&](const auto& of_vertex) {
          Vector sum = NULL_VECTOR;
          for(Index i : of_sample)
            sum = sum + of_vertex(i);
          return Vector(sum / static_cast<double>(of_sample.size()));
        };
        const Vector displacement = mean([&](Index i) { return remesh.last_displacement(i); });
        const auto off_tangent_plane = [&]() {
          return mean([&](Index i) {
            const Vector& m = vertices.normal(i);
            return Vector((remesh.last_displacement(i) * m) * m);
          });
        };
        if(samples.move(k, tolerance, displacement, length_at(k), off_tangent_plane))
        {
          is_due.push_back(k);
          reference.prefetch(samples.hint(k));
        }
      }
      for(std::size_t k : is_due)
        samples.update(k, reference, tolerance, query_at(k), length_at(k));
    });
  }
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_REMESH_SAMPLES_H
