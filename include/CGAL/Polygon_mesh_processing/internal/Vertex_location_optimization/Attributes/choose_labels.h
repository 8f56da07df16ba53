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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CHOOSE_LABELS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CHOOSE_LABELS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/attribute_maps.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/face_lattice.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/project_near_or_far.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/sample_faces.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Patch_descriptors.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Reference_patches.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Index_groups.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/Polygon_centers.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// wrapped, as `std::vector<bool>` has no references to its elements
template <typename T>
struct Label
{
  T value;
};

// Reads the labels of the patches of a reference surface from a map of the faces of the mesh that it was made from. Returns
// whether all are there.
template <typename TriangleMesh, typename Map, typename T>
bool read_labels(const Patch_descriptors<TriangleMesh>& patches, const Map& map, std::vector<Label<T>>& labels)
{
  labels.reserve(patches.size());
  for(std::size_t patch = 0; patch < patches.size(); ++patch)
  {
    if(!has_value_for(map, patches.face_of(patch)))
      return false;
    labels.push_back({ get(map, patches.face_of(patch)) });
  }
  return true;
}

// The patches that a polygon takes samples in, one for each label, and by how much of its area.
struct Label_candidate
{
  Index patch;
  double weight;
};

// Adds the samples of face f to the candidates of its polygon; `foot` is that of a point nearby. Each sample has the same
// weight, unless the polygon has several faces: then that is its part of the area.
template <typename Patch, typename AreSame, typename Candidates>
void add_candidates(const Mesh_arrays& mesh,
                    const std::size_t f,
                    const Reference_patches<Patch>& reference,
                    const double area_of_reference_faces,
                    const AreSame& are_same,
                    Patch_foot foot,
                    Candidates& candidates)
{
  constexpr double fewest_samples = 24; // to find the larger one of two parts of a face
  constexpr double far = 0.05;          // relative to the edge length
  const std::array<Point, 3> t = mesh.triangle(f);
  const double area = mesh.triangle_area(f), faces_of_reference = area / area_of_reference_faces;
  const std::size_t pieces =
    number_of_pieces(std::isfinite(faces_of_reference) ? (std::max)(fewest_samples, faces_of_reference) : fewest_samples);
  const double weight = mesh.has_polygons() ? mesh.area(f) / static_cast<double>(number_of_lattice_points(pieces)) : 1;
  for_each_lattice_point(pieces, [&](const Coordinates& x) {
    foot = project_near_or_far(reference, point_at(t, x), foot, far * std::sqrt(2 * area));
    const auto candidate = std::find_if(candidates.begin(), candidates.end(),
                                        [&](const Label_candidate& other) { return are_same(other.patch, foot.patch); });
    if(candidate == candidates.end())
      candidates.push_back({ foot.patch, weight });
    else
      candidate->weight += weight;
  });
}

// For each polygon of a mesh a patch of the reference that has the label which takes most of its area; are_same(p, q) tells
// whether two patches have the same label. If there are several such labels it is that of the center or, if that is none of
// them, the one that is met first.
template <typename ConcurrencyTag, typename Patch, typename AreSame>
std::vector<Index> choose_labels(const Mesh_arrays& mesh, const Reference_patches<Patch>& reference, const AreSame& are_same)
{
  const auto vertex_feet = project_vertices<ConcurrencyTag>(mesh.points, reference);
  const Polygon_centers center(mesh);
  const Index_groups faces(mesh.number_of_polygons(), mesh.number_of_faces(), [&](Index f) { return mesh.polygon(f); });
  std::vector<Index> chosen(mesh.number_of_polygons());
  for_each_index<ConcurrencyTag>(chosen.size(), [&](std::size_t polygon) {
    boost::container::small_vector<Label_candidate, 8> candidates;
    faces.for_each(polygon, [&](Index f) {
      const Patch_foot foot = reference.project(center(f), vertex_feet[mesh.first_vertex(f)]);
      if(candidates.empty())
        candidates.push_back({ foot.patch, 0 });
      double area = reference.area_at(foot);
      for(Index i : mesh.face(f))
        area += reference.area_at(vertex_feet[i]);
      add_candidates(mesh, f, reference, area / 4, are_same, foot, candidates);
    });
    Label_candidate best{ no_index, -1 };
    for(const Label_candidate& candidate : candidates)
      if(!(candidate.weight <= best.weight)) // also if areas overflow
        best = candidate;
    chosen[polygon] = best.patch;
  });
  return chosen;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CHOOSE_LABELS_H
