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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACE_MEASURE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACE_MEASURE_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/Error_sum.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/Face_piece.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// What is measured of a face.
struct Face_measurement : Face_error // whose maximum is that of the samples that are exact
{
  double variance = 0;         // of the mean, as a few samples say
  double coarseness = 0;       // the mean over the face of the area of a piece relative to the details there
  double sampled_maximum = 0;  // of all samples, of which some may be too large
  double probable_maximum = 0; // of the distance on the face; rather more than less
  std::size_t number_of_pieces = 0;
};

// Takes the samples of a face.
template <typename Reference>
class Distance_sampler
{
public:
  using Foot = typename Reference::Foot;
  using Sample = Distance_sample<Reference>;

  Distance_sampler(const Reference& reference, const Vector& area_normal)
    : m_reference(reference), m_normal(normalized(area_normal)), m_area(norm(area_normal) / 2)
  {}

  // Walks to the closest point from that of a sample nearby, unless that or another sheet may end too early: in a concave
  // dihedral angle, between two sheets, or where the distance is large. Found by trial: the mean is 0.1% too large at most.
  Sample operator()(const Point& p, const Sample& near) const
  {
    if constexpr(!Reference::walks)
      return Sample(p, m_reference, m_reference.project(p, near.hint));
    else
    {
      constexpr double least_cosine = 0.7;
      constexpr double enough = 2; // so much farther than that it is not tried
      if(near.distance > enough * farthest(near.patch_area))
        return Sample(p, m_reference, m_reference.project(p, near.hint));
      const Foot foot = m_reference.project_locally(p, near.hint);
      const Sample sample(p, m_reference, foot, false);
      if(sample.distance <= farthest(sample.patch_area) && m_reference.normal(foot) * m_normal >= least_cosine)
        return sample;
      return Sample(p, m_reference, m_reference.project(p, foot));
    }
  }

  const Vector& normal() const { return m_normal; }
  double area() const { return m_area; }

private:
  // how far away the closest point may be to walk to it
  double farthest(const double patch_area) const
  {
    constexpr double far = 0.07; // relative to the size of the face or of the patch, whichever is smaller
    return far * std::sqrt((std::min)(m_area, patch_area));
  }

  const Reference& m_reference;
  const Vector m_normal;
  const double m_area;
};

// How finely faces are cut to pieces, and where the sequence of their samples begins.
struct Fineness
{
  double largest_coarseness; // of a piece, see `Face_measurement`
  int least_depth;           // of the pieces: each level has four times as many
};

// Measures a face in pieces whose size follows the reference.
template <typename Reference>
class Face_measure
{
  using Sampler = Distance_sampler<Reference>;
  using Piece = Face_piece<Reference>;

public:
  using Sample = Distance_sample<Reference>;

  // `corners` are the samples at the corners of face f
  Face_measure(const Sampler& sampler, const Fineness& fineness, const std::size_t f)
    : m_sampler(sampler), m_fineness(fineness), m_number(f * step_between_faces)
  {}

  Face_measurement operator()(const std::array<Sample, 3>& corners)
  {
    if(is_flat(Piece(corners)))
      add(Piece(corners), 1, 1);
    else
      measure(Piece(corners, m_sampler), 0, 1);
    return m_result;
  }

private:
  static constexpr std::size_t step_between_faces = 7;

  // whether the face is so much smaller than those of the reference that the distance is nearly linear
  bool is_flat(const Piece& face) const
  {
    constexpr double small = 1. / 32;
    return Reference::walks && m_fineness.least_depth == 0 &&
           m_sampler.area() < small * m_fineness.largest_coarseness * face.area_of_detail();
  }

  void measure(const Piece& piece, const int depth, const double part)
  {
    constexpr int number_of_tests = 2;
    if(is_coarse(piece, depth, part))
      for(const Piece& child : piece.split(m_sampler))
        measure(child, depth + 1, part / 4);
    else
      add(piece, part, number_of_tests);
  }

  bool is_coarse(const Piece& piece, const int depth, const double part) const
  {
    constexpr int largest_depth = 10; // a million pieces
    return depth < m_fineness.least_depth ||
           (depth < largest_depth && coarseness(piece, part) > m_fineness.largest_coarseness);
  }

  double coarseness(const Piece& piece, const double part) const
  {
    constexpr double of_unknown_reference = 256; // of a face; three levels down it is small enough for most
    const double area = part * m_sampler.area(), detail = piece.area_of_detail();
    if(!Reference::walks)
      return part * of_unknown_reference;
    return std::isfinite(area) && area > 0 ? area / detail : 0;
  }

  // Integrates the interpolated distance over a piece, which is part of the face, and adds what it misses as a few samples
  // say, which are spread evenly over the pieces.
  void add(const Piece& piece, const double part, const int number_of_tests)
  {
    const Quadratic_interpolant interpolant = piece.interpolate(m_sampler.normal());
    double largest = piece.largest_distance();
    double missed = 0, missed_square = 0, squared_deviation = 0;
    for(int i = 0; i < number_of_tests; ++i)
    {
      const Coordinates x = next_coordinates();
      const auto [p, near] = piece.at(x);
      const Sample sample = m_sampler(p, near);
      const double interpolated = interpolant.absolute_at(x);
      missed += sample.distance - interpolated;
      missed_square += square(sample.distance) - square(interpolated);
      squared_deviation += square(sample.distance - interpolated);
      largest = (std::max)(largest, sample.distance);
      if(sample.is_exact)
        m_result.max = (std::max)(m_result.max, sample.distance);
    }
    m_result.mean += part * (interpolant.mean_of_absolute() + missed / number_of_tests);
    m_result.mean_square += part * (interpolant.mean_of_square() + missed_square / number_of_tests);
    m_result.variance += square(part / number_of_tests) * squared_deviation;
    m_result.coarseness += part * coarseness(piece, part);
    m_result.max = (std::max)(m_result.max, piece.largest_exact_distance());
    m_result.sampled_maximum = (std::max)(m_result.sampled_maximum, largest);
    m_result.probable_maximum = (std::max)(m_result.probable_maximum, largest + piece.probable_rise(m_sampler.normal()));
    ++m_result.number_of_pieces;
  }

  // the additive recurrence by powers of the plastic number, of low discrepancy
  Coordinates next_coordinates()
  {
    constexpr double plastic_number = 1.3247179572447460; // the real root of x^3 = x + 1
    constexpr double step_u = 1 / plastic_number, step_v = step_u / plastic_number;
    ++m_number;
    const double a = 0.5 + step_u * m_number, b = 0.5 + step_v * m_number;
    const double u = a - std::floor(a), v = b - std::floor(b);
    if(u + v > 1)
      return { 1 - u, 1 - v };
    return { u, v };
  }

  const Sampler& m_sampler;
  const Fineness m_fineness;
  std::size_t m_number; // of the last of the samples that tell what the interpolated distance misses
  Face_measurement m_result;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACE_MEASURE_H
