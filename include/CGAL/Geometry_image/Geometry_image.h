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

#ifndef CGAL_GEOMETRY_IMAGE_GEOMETRY_IMAGE_H
#define CGAL_GEOMETRY_IMAGE_GEOMETRY_IMAGE_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/assertions.h>
#include <CGAL/Origin.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL {

/*!
 * \ingroup PkgVertexLocationOptimizationImages
 *
 * \brief The class `Geometry_image` represents a surface by a regular grid of points, its samples, in rows and columns.
 *
 * Neighbors in the grid are neighbors on the surface; the connectivity is not stored. Border samples that coincide exactly,
 * the *side-band*, are one vertex of the surface, so that an image can also represent a closed surface. See
 * `geometry_image_to_polygon_mesh()`.
 *
 * \tparam Point_3_ the type of the points, `%Point_3` of a model of `Kernel`
 *
 * \sa `CGAL::make_geometry_image()`
 * \sa `CGAL::IO::read_geometry_image()`
 * \sa `CGAL::Polygon_mesh_processing::optimize_geometry_image()`
 */
template <typename Point_3_>
class Geometry_image
{
public:
  /// the type of the samples
  using Point_3 = Point_3_;

  /// constant iterator over the samples, row by row
  using const_iterator = typename std::vector<Point_3>::const_iterator;

  /*!
   * constructs an image without samples.
   */
  Geometry_image() = default;

  /*!
   * constructs an image whose samples are all at the origin.
   *
   * \throw std::length_error if the number of samples is too large
   */
  Geometry_image(std::size_t width, std::size_t height)
    : m_width(width), m_height(height), m_samples(checked_product(width, height), Point_3(ORIGIN))
  {}

  /*!
   * returns the number of columns.
   */
  std::size_t width() const { return m_width; }

  /*!
   * returns the number of rows.
   */
  std::size_t height() const { return m_height; }

  /*!
   * returns the sample in row `i` and column `j`.
   * \pre `i < height()` and `j < width()`
   */
  const Point_3& operator()(std::size_t i, std::size_t j) const
  {
    CGAL_precondition_msg(i < m_height && j < m_width, "The image has no such row or column.");
    return m_samples[i * m_width + j];
  }

#ifndef DOXYGEN_RUNNING
  Point_3& operator()(std::size_t i, std::size_t j)
  {
    CGAL_precondition_msg(i < m_height && j < m_width, "The image has no such row or column.");
    return m_samples[i * m_width + j];
  }
#else
  /*!
   * returns a reference to the sample in row `i` and column `j`.
   * \pre `i < height()` and `j < width()`
   */
  Point_3& operator()(std::size_t i, std::size_t j);
#endif

  /*!
   * returns the begin of the samples, row by row.
   */
  const_iterator begin() const { return m_samples.begin(); }

  /*!
   * returns the past-the-end of the samples.
   */
  const_iterator end() const { return m_samples.end(); }

  /*!
   * returns an image of every `step`-th row and column, and of the last ones: border samples remain border samples.
   *
   * Where `width() - 1` and `height() - 1` are multiples of `step`, samples at the same distance from the two ends of a side
   * are kept or dropped together, so that a side that is folded onto itself or onto another one remains folded.
   *
   * \pre `step > 0`
   */
  Geometry_image downsampled(std::size_t step) const
  {
    CGAL_precondition_msg(step > 0, "The step must be positive.");
    step = (std::max)(std::size_t(1), (std::min)(step, (std::max)(m_width, m_height))); // no product overflows
    auto number_of_steps = [step](std::size_t size) { return size == 0 ? 0 : (size + step - 2) / step + 1; };

    Geometry_image result(number_of_steps(m_width), number_of_steps(m_height));
    for(std::size_t i = 0; i < result.m_height; ++i)
      for(std::size_t j = 0; j < result.m_width; ++j)
        result(i, j) = (*this)((std::min)(i * step, m_height - 1), (std::min)(j * step, m_width - 1));
    return result;
  }

private:
  static std::size_t checked_product(std::size_t width, std::size_t height)
  {
    if(height > 0 && width > std::vector<Point_3>().max_size() / height)
      throw std::length_error("Geometry_image: too many samples");
    return width * height;
  }

  std::size_t m_width = 0;
  std::size_t m_height = 0;
  std::vector<Point_3> m_samples; // row by row
};

} // namespace CGAL

#endif // CGAL_GEOMETRY_IMAGE_GEOMETRY_IMAGE_H
