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

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/Error_integral.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Measure/Face_piece.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The result of measuring a face.
struct Face_measurement : Face_error // whose maximum is that of the samples that are exact
{
  double roughness = 0;        // how much the interpolated distance bends: nearly proportional to the variance
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

  // The sample at p, which is near another one: walks to the closest point from that, unless another sheet may be closer:
  // where the distance is large, relative to the size of the face or of the patch, or the surfaces are not along each other.
  Sample operator()(const Point& p, const Sample& near) const
  {
    if constexpr(!Reference::walks)
      return Sample(p, m_reference, m_reference.project(p, near.foot));
    else
    {
      constexpr double far = 0.3;  // found by trial: with 0.4 means begin to be too large, by 0.01%; with 0.8 by up to 0.7%
      constexpr double enough = 2; // so much farther than that it is not tried
      constexpr double least_cosine = 0.7;
      const auto is_far = [&](const Sample& s, double d) {
        return square(s.distance) > square(d) * (std::min)(m_area, s.patch_area);
      };
      if(is_far(near, enough * far))
        return Sample(p, m_reference, m_reference.project(p, near.foot));
      const Foot foot = m_reference.project_among_neighbors(p, near.foot);
      const Sample sample(p, m_reference, foot, false);
      if(!is_far(sample, far) && m_reference.normal(foot) * m_normal >= least_cosine)
        return sample;
      return Sample(p, m_reference, m_reference.project(p, foot));
    }
  }

  const Vector& normal() const { return m_normal; }
  double area() const { return m_area; }

private:
  const Reference& m_reference;
  const Vector m_normal;
  const double m_area;
};

// How finely a face is cut to pieces.
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

  Face_measure(const Sampler& sampler, const Fineness& fineness, const std::size_t f) // of face f
    : m_sampler(sampler), m_fineness(fineness), m_number(f * step_between_faces)
  {}

  // `corners` are the samples at the corners of the face
  Face_measurement operator()(const std::array<Sample, 3>& corners)
  {
    const Piece face(corners);
    if(is_flat(face))
    {
      add(face, 1, 1);
      m_result.coarseness = coarseness_if_flat(face);
    }
    else
      measure(Piece(corners, m_sampler), 0, 1);
    return m_result;
  }

private:
  static constexpr std::size_t step_between_faces = 7;

  // Whether the face is so much smaller than those of the reference that the distance is nearly linear.
  bool is_flat(const Piece& face) const
  {
    return Reference::walks && m_fineness.least_depth == 0 && coarseness_if_flat(face) < m_fineness.largest_coarseness;
  }

  double coarseness_if_flat(const Piece& face) const
  {
    constexpr double of_flat_face = 32; // relative to that of a piece of the same size
    return of_flat_face * coarseness(face, 1);
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

  // Integrates the interpolated distance over a piece, which is part of the face, and adds the interpolation error,
  // estimated from a few samples spread evenly over the pieces.
  void add(const Piece& piece, const double part, const int number_of_tests)
  {
    const Quadratic_interpolant interpolant = piece.interpolate(m_sampler.normal());
    double largest = piece.largest_distance();
    double missed = 0, missed_square = 0, squared_deviation = 0;
    for(int i = 0; i < number_of_tests; ++i)
    {
      const Coordinates x = low_discrepancy_coordinates(++m_number);
      const auto [p, near] = piece.at(x);
      const Sample sample = m_sampler(p, near);
      const double interpolated = interpolant.absolute_at(x), difference = sample.distance - interpolated;
      missed += difference;
      missed_square += square(sample.distance) - interpolant.square_at(x);
      squared_deviation += square(difference);
      largest = (std::max)(largest, sample.distance);
      if(sample.is_exact)
        m_result.max = (std::max)(m_result.max, sample.distance);
    }
    if(number_of_tests > 1)
      squared_deviation = (squared_deviation - square(missed) / number_of_tests) * number_of_tests / (number_of_tests - 1);
    m_result.mean += part * (interpolant.mean_of_absolute() + missed / number_of_tests);
    m_result.mean_square += part * (interpolant.mean_of_square() + missed_square / number_of_tests);
    m_result.variance += square(part / number_of_tests) * squared_deviation;
    m_result.roughness += square(part) * interpolant.squared_bend();
    m_result.coarseness += part * coarseness(piece, part);
    m_result.max = (std::max)(m_result.max, piece.largest_exact_distance());
    m_result.sampled_maximum = (std::max)(m_result.sampled_maximum, largest);
    m_result.probable_maximum = (std::max)(m_result.probable_maximum, largest + piece.probable_rise(m_sampler.normal()));
    ++m_result.number_of_pieces;
  }

  const Sampler& m_sampler;
  const Fineness m_fineness;
  std::size_t m_number; // of the last of the samples that tell what the interpolated distance misses
  Face_measurement m_result;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_FACE_MEASURE_H
