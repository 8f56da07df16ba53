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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MAXIMUM_SEARCH_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_MAXIMUM_SEARCH_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/Face_measure.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Finds the largest distance on a face: cuts it to pieces, first where it may be largest, and climbs from the best sample.
template <typename Reference>
class Farthest_on_face
{
  using Piece = Face_piece<Reference>;
  using Sample = Distance_sample<Reference>;

public:
  struct Result
  {
    Sample best;
    std::size_t number_of_cuts = 0;
  };

  Farthest_on_face(const Reference& reference, const Vector& normal) : m_reference(reference), m_normal(normal) {}

  // no more than `known` is not looked for
  Result operator()(const std::array<Sample, 3>& corners, const double known, const std::size_t most_cuts) const
  {
    constexpr double precision = 1.002;
    std::vector<Candidate> heap;
    Result result{ *std::max_element(corners.begin(), corners.end(), is_nearer) };
    const auto take_sample = [&](const Point& p, const Sample& near) {
      const Sample s = sample(p, near, (std::max)(result.best.distance, known));
      if(s.is_exact && is_nearer(result.best, s))
        result.best = s;
      return s;
    };
    const auto add = [&](const Piece& piece) {
      heap.push_back({ piece, piece.largest_distance() + piece.probable_rise(m_normal) });
      std::push_heap(heap.begin(), heap.end());
    };
    add(Piece(corners, take_sample));
    for(; result.number_of_cuts < most_cuts; ++result.number_of_cuts)
    {
      std::pop_heap(heap.begin(), heap.end());
      const Candidate candidate = heap.back();
      heap.pop_back();
      if(!(candidate.bound > precision * (std::max)(result.best.distance, known)))
        break;
      for(const Piece& piece : candidate.piece.split(take_sample))
        add(piece);
    }
    return result;
  }

  // The largest distance reached by steps from a sample, which are halved when none leads farther, until the distance hardly
  // changes around the last point.
  double climb(const std::array<Sample, 3>& corners, Sample best) const
  {
    constexpr double first_step = 1. / 8; // relative to the sides of the face
    constexpr double precision = 0.001;   // of the result
    constexpr int most_rounds = 40;       // it bounds the time
    const std::array<Point, 3> face = Piece(corners).triangle();
    Coordinates x = closest_on_triangle(face, best.point);
    double step = first_step;
    for(int round = 0; round < most_rounds; ++round)
    {
      const Sample here = best;
      double least = here.distance;
      for(const Coordinates& y : neighbors(x, step))
      {
        const Sample there = sample(point_at(face, y), here, best.distance);
        least = (std::min)(least, there.distance);
        if(there.distance > best.distance)
        {
          best = there;
          x = y;
        }
      }
      if(best.distance > here.distance)
        continue;
      if(!(least < (1 - precision) * best.distance))
        break;
      step /= 2;
    }
    return best.distance;
  }

private:
  // Walking finds the closest point or one that is farther away: it suffices where that is no farther than `known`.
  Sample sample(const Point& p, const Sample& near, const double known) const
  {
    const auto foot = m_reference.project_among_neighbors(p, near.foot);
    const Sample walked(p, m_reference, foot, !Reference::walks);
    return walked.is_exact || walked.distance <= known ? walked : Sample(p, m_reference, m_reference.project(p, foot));
  }

  static bool is_nearer(const Sample& a, const Sample& b) { return a.distance < b.distance; }

  // steps along the sides of the face, and back; those that would leave the face end on its boundary
  static std::array<Coordinates, 6> neighbors(const Coordinates& x, const double step)
  {
    const auto inside = [](double u, double v) {
      u = std::clamp(u, 0., 1.);
      return Coordinates{ u, std::clamp(v, 0., 1 - u) };
    };
    return { inside(x.u + step, x.v), inside(x.u - step, x.v),        inside(x.u, x.v + step),
             inside(x.u, x.v - step), inside(x.u + step, x.v - step), inside(x.u - step, x.v + step) };
  }

  struct Candidate
  {
    bool operator<(const Candidate& other) const { return bound < other.bound; }

    Piece piece;
    double bound; // probably
  };

  const Reference& m_reference;
  const Vector m_normal;
};

// Raises the maxima of the faces on which the largest distance of all may be. The work is bounded: if all faces are about
// equally far away, not all of them are searched, but those searched are then representative.
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

  // The first faces make what is known large, so that few others remain; the last ones make it precise. The numbers trade
  // time for a maximum that is elsewhere.
  void run()
  {
    constexpr std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();
    constexpr Effort for_first{ 64, 8, unlimited, false }, for_last{ 8, 64, unlimited, true };
    const Effort for_others{ m_faces.size(), 4, 512 + m_faces.size() / 8, false };
    search([](const Face_measurement& face) { return face.sampled_maximum; }, for_first);
    search([](const Face_measurement& face) { return face.probable_maximum; }, for_others);
    search([](const Face_measurement& face) { return face.max; }, for_last);
  }

private:
  using Farthest = Farthest_on_face<Reference>;

  // how thoroughly faces are searched
  struct Effort
  {
    std::size_t most_faces;
    std::size_t cuts_per_face; // at most, and a few more if the face is large
    std::size_t most_cuts;     // of all; no face is begun afterwards
    bool climbs;
  };

  struct Found
  {
    double distance = 0;
    std::size_t number_of_cuts = 0;
  };

  // Searches the faces with the largest keys.
  template <typename Key>
  void search(const Key& key, const Effort& effort)
  {
    constexpr std::size_t batch_size = 32; // searched with the same known maximum, whatever the number of threads
    const std::vector<Index> order = promising_faces(key, effort.most_faces);
    std::array<Found, batch_size> results;
    std::size_t number_of_cuts = 0;
    for(std::size_t begin = 0; begin < order.size() && number_of_cuts < effort.most_cuts; begin += batch_size)
    {
      const std::size_t size = (std::min)(batch_size, order.size() - begin);
      for_each_index<ConcurrencyTag>(size, [&](std::size_t i) { results[i] = search_face(order[begin + i], effort); });
      for(std::size_t i = 0; i < size; ++i)
      {
        double& max = m_faces[order[begin + i]].max;
        max = (std::max)(max, results[i].distance);
        m_known = (std::max)(m_known, max);
        number_of_cuts += results[i].number_of_cuts;
      }
    }
  }

  Found search_face(const Index f, const Effort& effort) const
  {
    constexpr std::size_t pieces_per_cut = 4;
    constexpr double rounding = 1e-11; // relative to the size of the face: climbing would only find the largest one
    const Farthest farthest(m_reference, m_normal_of(f));
    const auto corners = m_corners_of(f);
    const auto [best, number_of_cuts] =
      farthest(corners, m_known, effort.cuts_per_face + m_faces[f].number_of_pieces / pieces_per_cut);
    const bool climbs = effort.climbs && best.distance > rounding * Face_piece<Reference>(corners).largest_rise();
    return { climbs ? farthest.climb(corners, best) : best.distance, number_of_cuts };
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
