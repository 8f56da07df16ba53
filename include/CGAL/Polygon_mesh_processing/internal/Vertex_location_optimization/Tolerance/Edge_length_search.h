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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_EDGE_LENGTH_SEARCH_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_EDGE_LENGTH_SEARCH_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// the outcome of a remeshing
struct Attempt
{
  double edge_length;
  double error;   // relative to the tolerance; infinite: there is no mesh
  bool is_within; // within the tolerance; may be false for a small `error`, which can leave out a few spots
  std::size_t number_of_vertices;
};

// Looks for the largest edge length for which the error is within the tolerance. The error is roughly a power of the edge
// length, so that the search is a secant method on logarithms, bracketed by a length that is within the tolerance and one
// that is not. It does not rely on this law: the remesher need only meet the tolerance at some lengths.
//
// At first, a length whose error is small enough counts as within the tolerance even if its remesh is not, as this may be a
// coincidence and a longer length may succeed. If the search ends with such a length, it continues for a few more attempts
// with the lengths that really are within the tolerance.
class Edge_length_search
{
public:
  // the lengths are positive, and `precision` is the relative one that ends the search
  Edge_length_search(double first, double shortest, double longest, double precision)
    : m_next(std::clamp(first, shortest, longest)), m_shortest(shortest), m_longest(longest), m_step(1 + precision)
  {}

  bool is_finished() const { return m_is_finished; }

  // the edge length to try, if the search is not finished
  double next_length() const { return m_next; }

  void add(const Attempt& attempt)
  {
    m_attempts.push_back(attempt);
    update();
    if(m_is_finished && m_relies_on_error && !longest_within_is_certain())
    {
      m_relies_on_error = false;
      update();
    }
  }

private:
  void update()
  {
    const Attempt* within = longest_within();
    const Attempt* beyond = shortest_beyond(within ? within->edge_length : 0);
    if(within && beyond)
      m_is_finished = is_narrow(*within, *beyond) || (!m_relies_on_error && m_attempts.size() >= enough_attempts);
    else
      m_is_finished = (within ? within->edge_length >= m_longest : beyond->edge_length <= m_shortest) || is_unresponsive(3);
    if(m_is_finished)
      return;
    const double next = !beyond ? coarser(*within) : !within ? finer(*beyond) : between(*within, *beyond);
    m_next = std::clamp(next, m_shortest, m_longest);
  }

  static constexpr double expected_exponent = 2; // of the edge length, on a smooth surface
  static constexpr double least_exponent = 0.7;  // the exponent is 1 where creases are cut off
  static constexpr double largest_exponent = 4;
  static constexpr double largest_factor = 3; // between two attempts; its square if the remesher does not respond

  static constexpr std::size_t enough_attempts = 7; // if errors vary randomly; more attempts rarely save much

  bool counts_as_within(const Attempt& a) const { return m_relies_on_error ? a.error <= 1 : a.is_within; }

  bool longest_within_is_certain() const
  {
    const Attempt* within = longest_within();
    return within && within->is_within;
  }

  const Attempt* longest_within() const
  {
    const Attempt* longest = nullptr;
    for(const Attempt& a : m_attempts)
      if(counts_as_within(a) && (!longest || a.edge_length > longest->edge_length))
        longest = &a;
    return longest;
  }

  const Attempt* shortest_beyond(double length) const
  {
    const Attempt* shortest = nullptr;
    for(const Attempt& a : m_attempts)
      if(!counts_as_within(a) && a.edge_length > length && (!shortest || a.edge_length < shortest->edge_length))
        shortest = &a;
    return shortest;
  }

  // Rounding must not keep the search from ending.
  bool is_narrow(const Attempt& within, const Attempt& beyond) const
  {
    return beyond.edge_length <= within.edge_length * m_step * (1 + 1e-9);
  }

  // whether the last so many attempts gave the same mesh
  bool is_unresponsive(std::size_t count) const
  {
    if(m_attempts.size() < count)
      return false;
    return std::all_of(m_attempts.end() - count, m_attempts.end(), [&](const Attempt& a) {
      return a.error == m_attempts.back().error && a.number_of_vertices == m_attempts.back().number_of_vertices;
    });
  }

  // The exponent of the error between the last two attempts, that tells by how much the next edge length must differ.
  double exponent() const
  {
    if(m_attempts.size() < 2)
      return expected_exponent;
    const Attempt &a = *(m_attempts.end() - 2), &b = m_attempts.back();
    const double exponent = std::log(a.error / b.error) / std::log(a.edge_length / b.edge_length);
    return std::isfinite(exponent) ? std::clamp(exponent, least_exponent, largest_exponent) : expected_exponent;
  }

  // All were within the tolerance, or all beyond it: a length past the one that the exponent suggests, so that the solution
  // is bracketed.
  double coarser(const Attempt& within) const
  {
    const double factor = std::pow(within.error, -1 / exponent()) * m_step;
    return within.edge_length * limited(factor);
  }

  double finer(const Attempt& beyond) const
  {
    const double factor = std::isfinite(beyond.error) ? std::pow(beyond.error, 1 / exponent()) * m_step : largest_factor;
    return beyond.edge_length / limited(factor);
  }

  // At least the precision, and twice as much in logarithms with each attempt on the same side: errors that do not follow
  // the exponent do not hold up the search.
  double limited(double factor) const
  {
    if(is_unresponsive(2))
      return largest_factor * largest_factor;
    const double doublings = static_cast<double>((std::min)(number_on_same_side(), std::size_t(10)) - 1);
    return std::clamp(factor, (std::min)(std::pow(m_step, std::exp2(doublings)), largest_factor), largest_factor);
  }

  // Not nearer to the two than the precision, so that one more attempt can end the search.
  double between(const Attempt& within, const Attempt& beyond) const
  {
    const double low = within.edge_length, high = beyond.edge_length;
    if(high <= low * m_step * m_step)
      return std::sqrt(low * high);
    const double e_low = std::log(within.error), e_high = std::log(beyond.error);
    double part = -e_low / (e_high - e_low);
    // after three attempts on one side the error is no power, and halving is safe
    if(!(part >= 0 && part <= 1) || !std::isfinite(e_high - e_low) || number_on_same_side() > 2)
      part = 0.5;
    return std::clamp(low * std::pow(high / low, part), low * m_step, high / m_step);
  }

  // how many of the last attempts were all within the tolerance, or all beyond
  std::size_t number_on_same_side() const
  {
    const auto differs = [&](const Attempt& a) { return counts_as_within(a) != counts_as_within(m_attempts.back()); };
    return std::find_if(m_attempts.rbegin(), m_attempts.rend(), differs) - m_attempts.rbegin();
  }

  std::vector<Attempt> m_attempts;
  double m_next;
  double m_shortest;
  double m_longest;
  double m_step;
  bool m_relies_on_error = true;
  bool m_is_finished = false;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_EDGE_LENGTH_SEARCH_H
