// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_BYTE_READER_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_BYTE_READER_H

#include <array>
#include <cstddef>
#include <cstdint>

// Choices from a sequence of bytes; when these are used up, the first choice of each.
class Byte_reader
{
public:
  Byte_reader(const std::uint8_t* data, std::size_t size) : m_data(data), m_end(data + size) {}

  bool is_empty() const { return m_data == m_end; }
  std::uint8_t byte() { return is_empty() ? 0 : *m_data++; }
  bool boolean() { return byte() & 1; }

  // in [0, n)
  std::size_t below(std::size_t n) { return byte() % n; }

  // in [-1, 1)
  double coordinate() { return static_cast<std::int8_t>(byte()) / 128.; }

  template <typename T, std::size_t n>
  T one_of(const T (&choices)[n])
  {
    return choices[below(n)];
  }

private:
  const std::uint8_t* m_data;
  const std::uint8_t* m_end;
};

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_BYTE_READER_H
