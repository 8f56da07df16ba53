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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_ADAPTIVE_SAMPLING_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_ADAPTIVE_SAMPLING_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/Face_measure.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Samples the faces of a mesh coarsely first, and then more finely where the distance is rough, until the standard error of
// its mean is small enough.
template <typename ConcurrencyTag, typename MeasureFace>
class Adaptive_sampling
{
public:
  // `measure_face(f, fineness)` is a `Face_measurement`, with its area
  Adaptive_sampling(const MeasureFace& measure_face, std::vector<Face_measurement>& faces)
    : m_measure_face(measure_face), m_faces(faces)
  {}

  void run()
  {
    m_fineness.assign(m_faces.size(), Fineness{ 16, least_depth() });
    m_levels.assign(m_faces.size(), 0);
    std::vector<Index> coarse(m_faces.size());
    std::iota(coarse.begin(), coarse.end(), Index(0));
    for(int round = 1; !coarse.empty(); ++round)
    {
      for_each_index<ConcurrencyTag>(coarse.size(), [&](std::size_t i) {
        const Index f = coarse[i];
        m_faces[f] = m_measure_face(f, m_fineness[f]);
      });
      if(round == most_rounds)
        return;
      coarse = find_coarse_faces();
      for(Index f : coarse)
        refine(f);
    }
  }

private:
  static constexpr int most_rounds = 6;

  // small meshes are cut to more pieces, which costs little
  int least_depth() const
  {
    constexpr std::size_t enough_pieces = 1000;
    int depth = 0;
    for(std::size_t n = m_faces.size(); n > 0 && n < enough_pieces; n *= 4)
      ++depth;
    return depth;
  }

  // Cuts face f to pieces of a quarter of the area; most pieces were smaller than they might have been.
  void refine(const Index f)
  {
    ++m_levels[f];
    double& coarseness = m_fineness[f].largest_coarseness;
    coarseness = (std::min)(coarseness, 2 * m_faces[f].coarseness) / 4;
  }

  // The faces that are to be refined, in the order of what is gained for the time that it takes.
  std::vector<Index> find_coarse_faces() const
  {
    constexpr double standard_error = 1.2e-3; // of the mean
    constexpr double nearly_enough = 1.3;     // times its square, which further rounds would hardly lower
    constexpr double reduction = 1. / 16;     // of the variance, where pieces have a quarter of the area; often less remains
    double distance = 0, variance = 0;
    for(const Face_measurement& face : m_faces)
    {
      distance += face.area * face.mean;
      variance += variance_of_integral(face);
    }
    const double allowed = square(standard_error * distance);
    if(!(variance > nearly_enough * allowed))
      return {};

    const std::vector<double> expected = expected_variances(allowed);
    std::vector<double> gains(m_faces.size());
    for(std::size_t f = 0; f < m_faces.size(); ++f)
      gains[f] = expected[f] / m_faces[f].number_of_pieces;
    std::vector<Index> order(m_faces.size());
    std::iota(order.begin(), order.end(), Index(0));
    std::sort(order.begin(), order.end(),
              [&](Index f, Index g) { return gains[f] > gains[g] || (gains[f] == gains[g] && f < g); });
    // until it is enough, or most is what remains of the faces refined, which takes another round
    auto end = order.begin();
    double remaining = 0, others = variance;
    for(; end != order.end() && others + remaining > allowed && others > remaining; ++end)
    {
      remaining += reduction * expected[*end];
      others -= expected[*end];
    }
    order.erase(end, order.end());
    return order;
  }

  // The variances of the integrals over the faces, estimated from their roughness. A choice by the samples that tell the
  // variance would be biased: faces that seem accurate by chance would stay coarse, and make the mean too small. Samples say
  // what the faces that were refined equally often have together; only those with a large part of the variance that is
  // allowed are judged by their own samples.
  std::vector<double> expected_variances(const double allowed) const
  {
    constexpr double large_part = 1. / 4;
    constexpr double spread = 0.2; // evenly over the area, as some faces are rougher than they seem
    struct Class
    {
      double variance = 0, roughness = 0, squared_area = 0;
    };
    std::array<Class, most_rounds + 1> classes;
    std::vector<double> expected(m_faces.size(), 0);
    for(std::size_t f = 0; f < m_faces.size(); ++f)
    {
      const double variance = variance_of_integral(m_faces[f]);
      if(variance > large_part * allowed)
      {
        expected[f] = variance;
        continue;
      }
      Class& c = classes[class_of(f)];
      c.variance += variance;
      c.roughness += roughness_of_integral(m_faces[f]);
      c.squared_area += square(m_faces[f].area);
    }
    for(std::size_t f = 0; f < m_faces.size(); ++f)
    {
      const Class& c = classes[class_of(f)];
      if(expected[f] > 0 || !(c.variance > 0)) // judged by its own samples, or of a class that is certain
        continue;
      const double by_area = square(m_faces[f].area) / c.squared_area;
      const double by_roughness = c.roughness > 0 ? roughness_of_integral(m_faces[f]) / c.roughness : by_area;
      expected[f] = c.variance * (spread * by_area + (1 - spread) * by_roughness);
    }
    return expected;
  }

  static double roughness_of_integral(const Face_measurement& face) { return square(face.area) * face.roughness; }

  // Those that are measured as flat, without midpoints, have no roughness: a class of their own until they are refined.
  std::size_t class_of(const std::size_t f) const
  {
    return m_faces[f].roughness > 0 || m_levels[f] > 0 ? 1 + m_levels[f] : 0;
  }

  static double variance_of_integral(const Face_measurement& face) { return square(face.area) * face.variance; }

  const MeasureFace& m_measure_face;
  std::vector<Face_measurement>& m_faces;
  std::vector<Fineness> m_fineness;
  std::vector<unsigned char> m_levels;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_ADAPTIVE_SAMPLING_H
