// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_EXAMPLES_PROGRESS_BAR_H
#define VERTEX_LOCATION_OPTIMIZATION_EXAMPLES_PROGRESS_BAR_H

#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

#include <cstddef>
#include <cstdio>
#include <iostream>

// whether the output is a terminal
inline bool is_terminal()
{
#ifdef _WIN32
  return _isatty(_fileno(stderr)) != 0;
#else
  return isatty(fileno(stderr)) != 0;
#endif
}

// Shows the progress on a terminal.
class Progress_bar : public CGAL::Polygon_mesh_processing::Vertex_location_optimization_default_visitor
{
public:
  explicit Progress_bar(std::size_t iterations) : m_iterations(iterations), m_is_visible(is_terminal()) {}

  ~Progress_bar()
  {
    if(m_is_visible)
      std::cerr << "\r\033[K" << std::flush;
  }

  void end_iteration(const CGAL::Polygon_mesh_processing::Vertex_location_optimization_report& report)
  {
    if(m_is_visible)
      std::cerr << "\roptimizing: iteration " << report.iterations << " of at most " << m_iterations << std::flush;
  }

private:
  std::size_t m_iterations;
  bool m_is_visible;
};

#endif // VERTEX_LOCATION_OPTIMIZATION_EXAMPLES_PROGRESS_BAR_H
