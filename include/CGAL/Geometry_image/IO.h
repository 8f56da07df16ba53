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

#ifndef CGAL_GEOMETRY_IMAGE_IO_H
#define CGAL_GEOMETRY_IMAGE_IO_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Geometry_image/Geometry_image.h>
#include <CGAL/Geometry_image/internal/raster_files.h>

#include <CGAL/IO/helpers.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace CGAL {
namespace internal {
namespace geometry_image {

// Calls f(), and returns whether it succeeded. Exceptions are reported if the user asks for it.
template <typename NamedParameters, typename F>
bool try_with_file(const std::string& fname, const NamedParameters& np, const F& f)
{
  const bool verbose = parameters::choose_parameter(parameters::get_parameter(np, internal_np::verbose), false);
  try
  {
    f();
    return true;
  }
  catch(const std::exception& e)
  {
    if(verbose)
      std::cerr << "Error: " << fname << ": " << e.what() << std::endl;
    return false;
  }
}

inline Raster_format format_of_file(const std::string& fname)
{
  const std::string extension = IO::internal::get_file_extension(fname);
  if(extension == "gim")
    return Raster_format::GIM;
  if(extension == "pfm")
    return Raster_format::PFM;
  throw std::runtime_error("its extension is neither .gim nor .pfm");
}

// Writes a file with `write(os)`. It is first written under another name and renamed when complete, so that an existing file
// is not damaged if the disk is full. Something other than a regular file, such as a pipe, is written directly.
template <typename Write>
void write_or_keep(const std::string& fname, const Write& write)
{
  namespace fs = std::filesystem;
  const fs::path path = fs::exists(fname) ? fs::canonical(fname) : fs::path(fname); // not a link, but what it refers to
  const bool is_new = !fs::exists(path);
  if(!is_new && !std::ofstream(path, std::ios::binary | std::ios::app))
    throw std::runtime_error("it cannot be opened");
  fs::path partial = path;
  if(is_new || fs::is_regular_file(path))
    partial += ".partial";
  std::ofstream os(partial, std::ios::binary);
  if(!os)
    throw std::runtime_error("it cannot be opened");
  if(partial == path)
    return write(os);
  try
  {
    write(os);
    os.close();
    if(!is_new)
      fs::permissions(partial, fs::status(path).permissions());
    fs::rename(partial, path);
  }
  catch(...)
  {
    std::error_code ignored;
    fs::remove(partial, ignored);
    throw;
  }
}

template <typename Point_3>
Raster make_raster(const Geometry_image<Point_3>& image)
{
  Raster raster;
  raster.width = static_cast<std::int64_t>(image.width());
  raster.height = static_cast<std::int64_t>(image.height());
  check_size(raster);
  raster.samples.reserve(image.width() * image.height());
  for(const Point_3& p : image)
  {
    raster.samples.push_back(
      { static_cast<float>(to_double(p.x())), static_cast<float>(to_double(p.y())), static_cast<float>(to_double(p.z())) });
    for(float x : raster.samples.back())
      if(!std::isfinite(x))
        throw std::runtime_error("a coordinate is not finite in single precision");
  }
  return raster;
}

} // namespace geometry_image
} // namespace internal

namespace IO {

/*!
 * \ingroup PkgVertexLocationOptimizationImages
 *
 * \brief reads a geometry image from a file.
 *
 * The format is detected from the filename extension (letter case is not important):
 * - `.gim`: the width and the height as little endian 32 bit integers, then `x`, `y` and `z` of each sample as little
 *   endian floating point numbers in single precision, row by row from the first one
 * - `.pfm`: a portable float map with three channels, in either byte order. As in all files of this format the rows are
 *   stored from the last one to the first. The magnitude of the scale in the header is ignored.
 *
 * \tparam Point_3 a point type
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param fname the name of the file
 * \param image the image
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{verbose}
 *     \cgalParamDescription{indicates whether error messages are printed to `std::cerr`}
 *     \cgalParamType{Boolean}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return `true` if the file is an image, with finite coordinates and nothing before or after it; otherwise `false`,
 *         and `image` is untouched
 */
template <typename Point_3, typename NamedParameters = parameters::Default_named_parameters>
bool read_geometry_image(const std::string& fname,
                         Geometry_image<Point_3>& image,
                         const NamedParameters& np = parameters::default_values())
{
  using namespace CGAL::internal::geometry_image;

  return try_with_file(fname, np, [&]() {
    const Raster_format format = format_of_file(fname);
    std::ifstream is(fname, std::ios::binary);
    if(!is)
      throw std::runtime_error("it cannot be opened");
    const Raster raster = read_raster(is, format);

    Geometry_image<Point_3> result(static_cast<std::size_t>(raster.width), static_cast<std::size_t>(raster.height));
    for(std::size_t i = 0, s = 0; i < result.height(); ++i)
      for(std::size_t j = 0; j < result.width(); ++j, ++s)
        result(i, j) = Point_3(raster.samples[s][0], raster.samples[s][1], raster.samples[s][2]);
    image = std::move(result);
  });
}

/*!
 * \ingroup PkgVertexLocationOptimizationImages
 *
 * \brief writes a geometry image to a file, in single precision.
 *
 * The format is detected from the filename extension, see `read_geometry_image()`. Samples that coincide also coincide in
 * the file. If the file cannot be written completely, an existing file is unchanged: the new one is first written as `fname`
 * with the suffix `.partial`, and then renamed.
 *
 * \tparam Point_3 a point type
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param fname the name of the file
 * \param image the image
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{verbose}
 *     \cgalParamDescription{indicates whether error messages are printed to `std::cerr`}
 *     \cgalParamType{Boolean}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return `true` if the file was written; `false` also if the image has no samples, or some that are not finite in
 *         single precision
 */
template <typename Point_3, typename NamedParameters = parameters::Default_named_parameters>
bool write_geometry_image(const std::string& fname,
                          const Geometry_image<Point_3>& image,
                          const NamedParameters& np = parameters::default_values())
{
  using namespace CGAL::internal::geometry_image;

  return try_with_file(fname, np, [&]() {
    const Raster_format format = format_of_file(fname);
    Raster raster = make_raster(image);
    write_or_keep(fname, [&](std::ostream& os) { write_raster(os, format, std::move(raster)); });
  });
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_GEOMETRY_IMAGE_IO_H
