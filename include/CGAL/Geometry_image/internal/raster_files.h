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

#ifndef CGAL_GEOMETRY_IMAGE_INTERNAL_RASTER_FILES_H
#define CGAL_GEOMETRY_IMAGE_INTERNAL_RASTER_FILES_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <istream>
#include <limits>
#include <locale>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::internal::geometry_image {

// The files that geometry images are stored in. Errors are reported by a std::runtime_error.
enum class Raster_format
{
  GIM,
  PFM
};

struct Raster
{
  using Sample = std::array<float, 3>;

  std::int64_t width = 0;
  std::int64_t height = 0;
  std::vector<Sample> samples; // row by row
};

template <typename Bits>
Bits swap_if_other_endian(Bits bits, bool is_little_endian)
{
  return is_little_endian ? boost::endian::little_to_native(bits) : boost::endian::big_to_native(bits);
}

inline void check_size(const Raster& raster)
{
  constexpr std::int64_t max_size = (std::numeric_limits<std::int32_t>::max)();
  if(raster.width < 1 || raster.height < 1 || raster.width > max_size || raster.height > max_size)
    throw std::runtime_error("its size, " + std::to_string(raster.width) + " x " + std::to_string(raster.height) +
                             ", is none of an image");
}

// Reads the header; returns whether the samples are little endian.
inline bool read_header_of_GIM(std::istream& is, Raster& raster)
{
  std::array<std::int32_t, 2> size;
  if(!is.read(reinterpret_cast<char*>(size.data()), sizeof(size)))
    throw std::runtime_error("it ends before its size");
  raster.width = swap_if_other_endian(size[0], true);
  raster.height = swap_if_other_endian(size[1], true);
  return true;
}

// The same. The magnitude of the scale, the unit of the samples, is ignored; its sign is the byte order.
inline bool read_header_of_PFM(std::istream& is, Raster& raster)
{
  is.imbue(std::locale::classic());
  std::string magic(2, ' ');
  if(!is.read(&magic[0], 2) || magic != "PF")
    throw std::runtime_error("it is no portable float map with three channels");
  double scale = 0;
  if(!(is >> raster.width >> raster.height >> scale) || scale == 0 || is.get() == std::istream::traits_type::eof())
    throw std::runtime_error("its header is no width, height and scale");
  return scale < 0;
}

// Reads the number of samples given in the header. The memory grows with the samples actually read, not with this number.
inline void read_samples(std::istream& is, bool is_little_endian, Raster& raster)
{
  const std::uint64_t size = static_cast<std::uint64_t>(raster.width) * static_cast<std::uint64_t>(raster.height);
  for(std::uint64_t s = 0; s < size; ++s)
  {
    std::array<std::uint32_t, 3> bits;
    if(!is.read(reinterpret_cast<char*>(bits.data()), sizeof(bits)))
      throw std::runtime_error("it ends after " + std::to_string(s) + " of " + std::to_string(size) + " samples");
    Raster::Sample sample;
    for(std::size_t k = 0; k < 3; ++k)
    {
      bits[k] = swap_if_other_endian(bits[k], is_little_endian);
      std::memcpy(&sample[k], &bits[k], sizeof(float));
      if(!std::isfinite(sample[k]))
        throw std::runtime_error("sample " + std::to_string(s) + " is not finite");
    }
    raster.samples.push_back(sample);
  }
  if(is.peek() != std::istream::traits_type::eof())
    throw std::runtime_error("there is more in it than its size says");
}

// the rows of a portable float map go from the last one to the first
inline void reverse_rows(Raster& raster)
{
  for(std::int64_t i = 0; i < raster.height / 2; ++i)
    std::swap_ranges(raster.samples.begin() + i * raster.width, raster.samples.begin() + (i + 1) * raster.width,
                     raster.samples.begin() + (raster.height - 1 - i) * raster.width);
}

inline Raster read_raster(std::istream& is, Raster_format format)
{
  Raster raster;
  const bool is_little_endian =
    format == Raster_format::GIM ? read_header_of_GIM(is, raster) : read_header_of_PFM(is, raster);
  check_size(raster);
  read_samples(is, is_little_endian, raster);
  if(format == Raster_format::PFM)
    reverse_rows(raster);
  return raster;
}

// Writes in little endian.
inline void write_raster(std::ostream& os, Raster_format format, Raster raster)
{
  if(format == Raster_format::PFM)
  {
    os << "PF\n" << std::to_string(raster.width) << " " << std::to_string(raster.height) << "\n-1\n";
    reverse_rows(raster);
  }
  else
    for(std::int64_t size : { raster.width, raster.height })
    {
      const std::int32_t bits = swap_if_other_endian(static_cast<std::int32_t>(size), true);
      os.write(reinterpret_cast<const char*>(&bits), sizeof(bits));
    }

  for(const Raster::Sample& sample : raster.samples)
    for(float x : sample)
    {
      std::uint32_t bits;
      std::memcpy(&bits, &x, sizeof(float));
      bits = swap_if_other_endian(bits, true);
      os.write(reinterpret_cast<const char*>(&bits), sizeof(bits));
    }
  if(!os.flush())
    throw std::runtime_error("it cannot be written");
}

} // namespace CGAL::internal::geometry_image

#endif // CGAL_GEOMETRY_IMAGE_INTERNAL_RASTER_FILES_H
