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
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Samples the faces of a mesh coarsely first, and then more finely where the mean of the distance is least certain, until
// its standard error is small enough. Faces go by blocks; neighbors follow each other.
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
    constexpr int most_rounds = 6;
    m_blocks.assign((m_faces.size() + block_size - 1) / block_size, Block{ 0, { 16, least_depth() } });
    std::vector<Index> coarse(m_blocks.size());
    std::iota(coarse.begin(), coarse.end(), Index(0));
    for(int round = 1; !coarse.empty(); ++round)
    {
      for_each_index<ConcurrencyTag>(coarse.size(), [&](std::size_t i) { measure_block(coarse[i]); });
      if(round == most_rounds)
        return;
      coarse = find_uncertain_blocks();
      for(Index b : coarse)
        m_blocks[b].refine();
    }
  }

private:
  static constexpr std::size_t block_size = 16;
  static constexpr double reduction = 1. / 12; // of the variance, where pieces have a quarter of the area; often more

  struct Block
  {
    // Pieces of a quarter of the area. Most were not as coarse as they might have been.
    void refine()
    {
      fineness.largest_coarseness = (std::min)(fineness.largest_coarseness, 2 * coarseness / area) / 4;
      ++level;
    }

    int level = 0; // of the refinement
    Fineness fineness;
    double area = 0, distance = 0, coarseness = 0; // integrals over the faces
    double variance = 0;                           // of the integral of the distance
    std::size_t number_of_pieces = 0;
  };

  // small meshes are cut to more pieces, which costs little
  int least_depth() const
  {
    constexpr std::size_t enough_pieces = 1000;
    int depth = 0;
    for(std::size_t n = m_faces.size(); n > 0 && n < enough_pieces; n *= 4)
      ++depth;
    return depth;
  }

  void measure_block(const Index b)
  {
    Block block{ m_blocks[b].level, m_blocks[b].fineness };
    const std::size_t begin = b * block_size, end = (std::min)(begin + block_size, m_faces.size());
    for(std::size_t f = begin; f < end; ++f)
    {
      const Face_measurement& face = m_faces[f] = m_measure_face(f, block.fineness);
      block.area += face.area;
      block.distance += face.area * face.mean;
      block.coarseness += face.area * face.coarseness;
      block.variance += square(face.area) * face.variance;
      block.number_of_pieces += face.number_of_pieces;
    }
    m_blocks[b] = block;
  }

  // The blocks that are to be refined, in the order of what is gained for the time that it takes.
  std::vector<Index> find_uncertain_blocks() const
  {
    constexpr double standard_error = 1.2e-3; // of the mean
    constexpr double nearly_enough = 1.3;     // times its square, which further rounds would hardly lower
    double variance = 0, distance = 0;
    for(const Block& block : m_blocks)
    {
      variance += block.variance;
      distance += block.distance;
    }
    const double allowed = square(standard_error * distance);
    if(!(variance > nearly_enough * allowed))
      return {};

    std::vector<double> expected, gains;
    for(Index b = 0; b < m_blocks.size(); ++b)
    {
      expected.push_back(expected_variance(b, allowed));
      gains.push_back(expected[b] / m_blocks[b].number_of_pieces);
    }
    std::vector<Index> order(m_blocks.size());
    std::iota(order.begin(), order.end(), Index(0));
    std::sort(order.begin(), order.end(),
              [&](Index a, Index b) { return gains[a] > gains[b] || (gains[a] == gains[b] && a < b); });
    // near the end, a few blocks may have all of it, unnoticed by the others: at most half of the blocks in a round
    const bool is_far = variance > square(3) * allowed;
    const auto last = is_far ? order.end() : order.begin() + (order.size() + 1) / 2;
    auto end = order.begin();
    for(double remaining = variance; end != last && remaining > allowed; ++end)
      remaining -= (1 - reduction) * expected[*end];
    order.erase(end, order.end());
    return order;
  }

  // The variance of a block, estimated from those before and after it. A choice by its own samples would be biased: blocks
  // that seem accurate by chance would stay coarse, and make the mean too small. Only a few blocks with a large part of the
  // total variance allowed are judged by their own samples.
  double expected_variance(const Index b, const double allowed) const
  {
    constexpr Index reach = 2;
    constexpr double good_part = 1. / 4;
    const double own = m_blocks[b].variance;
    double sum = 0;
    Index count = 0;
    for(Index other = b - (std::min)(b, reach); other < m_blocks.size() && other <= b + reach; ++other)
      if(other != b)
      {
        sum += m_blocks[other].variance * std::pow(reduction, m_blocks[b].level - m_blocks[other].level);
        ++count;
      }
    const double average = count > 0 ? sum / count : own;
    return own > good_part * allowed ? (std::max)(own, average) : average;
  }

  const MeasureFace& m_measure_face;
  std::vector<Face_measurement>& m_faces;
  std::vector<Block> m_blocks;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_ADAPTIVE_SAMPLING_H
