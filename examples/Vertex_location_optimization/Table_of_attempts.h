// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_EXAMPLES_TABLE_OF_ATTEMPTS_H
#define VERTEX_LOCATION_OPTIMIZATION_EXAMPLES_TABLE_OF_ATTEMPTS_H

#include "Progress_bar.h"

#include <CGAL/Polygon_mesh_processing/Tolerance_report.h>

#include <cstdio>
#include <iostream>

// Prints a row for each attempt of a search, and shows its progress on a terminal.
class Table_of_attempts : public CGAL::Polygon_mesh_processing::Tolerance_default_visitor
{
public:
  explicit Table_of_attempts(double side) : m_side(side), m_is_visible(is_terminal())
  {
    std::printf("\n   edge length  vertices       mean       rms   maximum  mean back  max. back\n");
  }

  void start_remeshing(double edge_length)
  {
    m_edge_length = edge_length;
    show("remeshing");
  }

  void end_iteration(const CGAL::Polygon_mesh_processing::Vertex_location_optimization_report&) { show("optimizing"); }

  void end_remeshing(const CGAL::Polygon_mesh_processing::Tolerance_report& r)
  {
    if(m_is_visible)
      std::cerr << "\r\033[K" << std::flush;
    const double unit = 1e-4 * m_side;
    std::printf("  %12.6g %9zu %10.3f %9.3f %9.3f %10.3f %10.3f  %s\n", r.edge_length, r.number_of_vertices,
                r.to_reference.mean / unit, r.to_reference.rms / unit, r.to_reference.max / unit,
                r.from_reference.mean / unit, r.from_reference.max / unit, r.is_within_tolerance ? "within" : "beyond");
    std::fflush(stdout);
  }

private:
  void show(const char* phase) const
  {
    if(m_is_visible)
      std::cerr << "\r\033[K" << phase << ", edge length " << m_edge_length << std::flush;
  }

  double m_side;
  bool m_is_visible;
  double m_edge_length = 0;
};

#endif // VERTEX_LOCATION_OPTIMIZATION_EXAMPLES_TABLE_OF_ATTEMPTS_H
