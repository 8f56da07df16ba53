// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MAXIMUM_SEARCH_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MAXIMUM_SEARCH_H

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/Face_measure.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Finds the largest distance on a face: cuts it to pieces, first where it may be largest.
template <typename Reference>
class Farthest_on_face
{
  using Piece = Face_piece<Reference>;
  using Sample = Distance_sample<Reference>;

public:
  struct Result
  {
    double distance = 0;
    std::size_t number_of_cuts = 0;
  };

  Farthest_on_face(const Reference& reference, const Vector& normal) : m_reference(reference), m_normal(normal) {}

  // no more than `known` is not looked for
  Result operator()(const std::array<Sample, 3>& corners, const double known, const std::size_t most_cuts) const
  {
    constexpr double precision = 1.002;
    std::vector<Candidate> heap;
    Result result;
    const auto add = [&](const Piece& piece) {
      const double distance = piece.largest_distance();
      result.distance = (std::max)(result.distance, distance);
      heap.push_back({ piece, distance + piece.probable_rise(m_normal) });
      std::push_heap(heap.begin(), heap.end());
    };
    const auto take_sample = [&](const Point& p, const Sample& near) {
      return Sample(p, m_reference, m_reference.project(p, near.hint));
    };
    add(Piece(corners, take_sample));
    for(; result.number_of_cuts < most_cuts; ++result.number_of_cuts)
    {
      std::pop_heap(heap.begin(), heap.end());
      const Candidate candidate = heap.back();
      heap.pop_back();
      if(!(candidate.bound > precision * (std::max)(result.distance, known)))
        break;
      for(const Piece& piece : candidate.piece.split(take_sample))
        add(piece);
    }
    return result;
  }

private:
  struct Candidate
  {
    bool operator<(const Candidate& other) const { return bound < other.bound; }

    Piece piece;
    double bound; // probably
  };

  const Reference& m_reference;
  const Vector m_normal;
};

// Raises the maxima of the faces on which the largest distance of all may be. The work is bounded: where all faces are
// nearly as far away as each other not all are looked at, but then those that are say enough.
template <typename ConcurrencyTag, typename Reference, typename CornersOf, typename NormalOf>
class Maximum_search
{
public:
  Maximum_search(const Reference& reference,
                 const CornersOf& corners_of,
                 const NormalOf& normal_of,
                 std::vector<Face_measurement>& faces)
    : m_reference(reference), m_corners_of(corners_of), m_normal_of(normal_of), m_faces(faces)
  {
    for(const Face_measurement& face : faces)
      m_known = (std::max)(m_known, face.max);
  }

  // The first faces make what is known large, so that few others remain; the last ones make it precise.
  void run()
  {
    const std::size_t n = m_faces.size(), unlimited = n * number_of_first;
    search([](const Face_measurement& face) { return face.sampled_maximum; }, number_of_first, 12, unlimited);
    search([](const Face_measurement& face) { return face.probable_maximum; }, n, 4, 512 + n / 8);
    search([](const Face_measurement& face) { return face.max; }, number_of_last, 64, unlimited);
  }

private:
  static constexpr std::size_t number_of_first = 32, number_of_last = 8;
  using Farthest = Farthest_on_face<Reference>;

  // Searches the faces with the largest keys, `number` of them at most, each with `cuts` cuts at most and a few more if it
  // is large, until `most_cuts` cuts are made.
  template <typename Key>
  void search(const Key& key, std::size_t number, const std::size_t cuts, const std::size_t most_cuts)
  {
    constexpr std::size_t batch_size = 32; // searched with the same knowledge, whatever the number of threads
    const std::vector<Index> order = promising_faces(key, number);
    std::array<typename Farthest::Result, batch_size> results;
    std::size_t number_of_cuts = 0;
    for(std::size_t begin = 0; begin < order.size() && number_of_cuts < most_cuts; begin += batch_size)
    {
      const std::size_t size = (std::min)(batch_size, order.size() - begin);
      for_each_index<ConcurrencyTag>(size, [&](std::size_t i) {
        const Index f = order[begin + i];
        const Farthest farthest(m_reference, m_normal_of(f));
        results[i] = farthest(m_corners_of(f), m_known, cuts + m_faces[f].number_of_pieces / 4);
      });
      for(std::size_t i = 0; i < size; ++i)
      {
        double& max = m_faces[order[begin + i]].max;
        max = (std::max)(max, results[i].distance);
        m_known = (std::max)(m_known, max);
        number_of_cuts += results[i].number_of_cuts;
      }
    }
  }

  // the faces with the largest keys, ties by index, among those that may have more than is known
  template <typename Key>
  std::vector<Index> promising_faces(const Key& key, std::size_t number) const
  {
    std::vector<Index> faces;
    for(Index f = 0; f < m_faces.size(); ++f)
      if(m_faces[f].probable_maximum > m_known)
        faces.push_back(f);
    number = (std::min)(number, faces.size());
    std::partial_sort(faces.begin(), faces.begin() + number, faces.end(), [&](Index f, Index g) {
      const double a = key(m_faces[f]), b = key(m_faces[g]);
      return a > b || (a == b && f < g);
    });
    faces.resize(number);
    return faces;
  }

  const Reference& m_reference;
  const CornersOf& m_corners_of;
  const NormalOf& m_normal_of;
  std::vector<Face_measurement>& m_faces;
  double m_known = 0;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MAXIMUM_SEARCH_H
