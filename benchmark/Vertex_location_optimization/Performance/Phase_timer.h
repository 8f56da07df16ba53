// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_PHASE_TIMER_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_PHASE_TIMER_H

#include "clocks.h"

#include <CGAL/Polygon_mesh_processing/Vertex_location_optimization_report.h>

#include <array>
#include <cstddef>
#include <vector>

// A visitor that takes the time of each phase of each iteration. What is not a phase, the set-up before the first one and
// the writing of the points, has a column of its own.
class Phase_timer : public CGAL::Polygon_mesh_processing::Vertex_location_optimization_default_visitor
{
public:
  using Phase = CGAL::Polygon_mesh_processing::Vertex_location_optimization_phase;

  static constexpr std::size_t guarantee = static_cast<std::size_t>(Phase::ENFORCE_GUARANTEE); // the last phase
  static constexpr std::size_t number_of_phases = guarantee + 1;
  static constexpr std::size_t apart = number_of_phases;
  using Times = std::array<double, number_of_phases + 1>; // seconds

  void start() { m_last = thread_time(); }
  void stop() { end_phase(); }

  void start_phase(Phase phase)
  {
    end_phase();
    m_phase = static_cast<std::size_t>(phase);
    if(phase == Phase::SAMPLE_REFERENCE)
      m_iterations.push_back(Times());
  }

  void end_iteration(const CGAL::Polygon_mesh_processing::Vertex_location_optimization_report&) { end_phase(); }

  const std::vector<Times>& iterations() const { return m_iterations; }
  const Times& total() const { return m_total; }

private:
  void end_phase()
  {
    const double now = thread_time();
    m_total[m_phase] += now - m_last;
    if(m_phase < guarantee)
      m_iterations.back()[m_phase] += now - m_last;
    m_last = now;
    m_phase = apart;
  }

  double m_last = 0;
  std::size_t m_phase = apart;
  Times m_total{};
  std::vector<Times> m_iterations; // without what comes before and after them
};

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_PHASE_TIMER_H
