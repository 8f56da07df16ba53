// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CHOOSE_LABELS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CHOOSE_LABELS_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/attribute_maps.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/face_lattice.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/project_near_or_far.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/sample_faces.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Patch_descriptors.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Reference_patches.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// a label by itself: a vector of `bool` has no elements
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

// For each face of a mesh a patch of the reference that has the label which takes most of the area of the face;
// are_same(p, q) tells whether two patches have the same label. If there are several such labels it is that of the
// barycenter or, if that is none of them, the one that is met first.
template <typename ConcurrencyTag, typename Patch, typename AreSame>
std::vector<Index> choose_labels(const Mesh_arrays& mesh, const Reference_patches<Patch>& reference, const AreSame& are_same)
{
  struct Candidate
  {
    Index patch;
    std::size_t number_of_samples;
  };

  const auto vertex_feet = project_vertices<ConcurrencyTag>(mesh.points, reference);
  std::vector<Index> chosen(mesh.number_of_faces());
  for_each_index<ConcurrencyTag>(chosen.size(), [&](std::size_t f) {
    constexpr double fewest_samples = 24; // to find the larger one of two parts of a face
    constexpr double far = 0.05;          // relative to the edge length
    const std::array<Point, 3> t = mesh.triangle(f);
    Patch_foot foot = reference.project(mesh.barycenter(f), vertex_feet[mesh.first_vertex(f)]);

    double area = reference.area_at(foot);
    for(Index i : mesh.face(f))
      area += reference.area_at(vertex_feet[i]);
    const double faces_of_reference = mesh.area(f) / (area / 4);
    const std::size_t pieces =
      number_of_pieces(std::isfinite(faces_of_reference) ? (std::max)(fewest_samples, faces_of_reference) : fewest_samples);

    boost::container::small_vector<Candidate, 8> candidates{ Candidate{ foot.patch, 0 } };
    for_each_lattice_point(pieces, [&](const Coordinates& x) {
      foot = project_near_or_far(reference, point_at(t, x), foot, far * std::sqrt(2 * mesh.area(f)));
      const auto candidate = std::find_if(candidates.begin(), candidates.end(),
                                          [&](const Candidate& other) { return are_same(other.patch, foot.patch); });
      if(candidate == candidates.end())
        candidates.push_back({ foot.patch, 1 });
      else
        ++candidate->number_of_samples;
    });
    chosen[f] = std::max_element(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
                  return a.number_of_samples < b.number_of_samples;
                })->patch;
  });
  return chosen;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CHOOSE_LABELS_H
