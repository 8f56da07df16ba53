// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_PARTS_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_PARTS_H

#include "test_meshes.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

// Parts as a CAD kernel tessellates them, with long thin triangles, beside the exact surfaces that they stand for.

using Point_2 = Kernel::Point_2;
using Vector_2 = Kernel::Vector_2;

// Lines and arcs in the plane, one after the other, and the points at which they are sampled.
class Profile
{
public:
  explicit Profile(const Point_2& start) : m_points{ start } {}

  Profile& line_to(const Point_2& end)
  {
    const Point_2 start = m_points.back();
    m_distances.push_back(
      [=](const Point_2& p) { return std::sqrt(CGAL::squared_distance(p, Kernel::Segment_2(start, end))); });
    m_points.push_back(end);
    return *this;
  }

  // turns by `angle`, in radians, around `center`
  Profile& arc(const Point_2& center, const double angle, const int number_of_steps)
  {
    const Vector_2 from_center = m_points.back() - center;
    const double radius = std::sqrt(from_center.squared_length()), start = std::atan2(from_center.y(), from_center.x());
    const auto at = [=](double t) { return center + radius * Vector_2(std::cos(start + t), std::sin(start + t)); };
    m_distances.push_back([=](const Point_2& p) {
      const Vector_2 d = p - center;
      const double middle = start + angle / 2;
      const double from_middle = std::remainder(std::atan2(d.y(), d.x()) - middle, 2 * CGAL_PI);
      if(std::abs(from_middle) <= std::abs(angle) / 2)
        return std::abs(std::sqrt(d.squared_length()) - radius);
      return std::sqrt((std::min)(CGAL::squared_distance(p, at(0)), CGAL::squared_distance(p, at(angle))));
    });
    for(int i = 1; i <= number_of_steps; ++i)
      m_points.push_back(at(angle * i / number_of_steps));
    return *this;
  }

  const std::vector<Point_2>& points() const { return m_points; }
  bool is_closed() const { return CGAL::squared_distance(m_points.front(), m_points.back()) < 1e-24; }

  double distance(const Point_2& p) const
  {
    double result = (std::numeric_limits<double>::max)();
    for(const auto& distance : m_distances)
      result = (std::min)(result, distance(p));
    return result;
  }

private:
  std::vector<Point_2> m_points;
  std::vector<std::function<double(const Point_2&)>> m_distances;
};

struct Part
{
  std::string name;
  Mesh mesh;
  std::function<double(const Point&)> distance; // to the exact surface
};

// which diagonal splits the quad in row i and column j
enum class Diagonals
{
  ONE_WAY,
  OTHER_WAY,
  ALTERNATING
};

// Rows of quads between the samples of a profile, `point(p, j)` being the place of its point p in column j.
template <typename At>
Mesh sweep(const Profile& profile, std::size_t columns, bool is_closed, Diagonals diagonals, const At& point)
{
  std::vector<Point_2> samples = profile.points();
  if(profile.is_closed())
    samples.pop_back();
  const std::size_t rows = samples.size() - (profile.is_closed() ? 0 : 1), n = columns + (is_closed ? 0 : 1);

  Soup soup;
  std::vector<std::vector<std::size_t>> index(samples.size());
  for(std::size_t i = 0; i < samples.size(); ++i)
    for(std::size_t j = 0; j < n; ++j)
    {
      const bool is_pole = is_closed && j > 0 && std::abs(samples[i].x()) < 1e-12;
      if(!is_pole)
        soup.points.push_back(point(samples[i], j));
      index[i].push_back(soup.points.size() - 1);
    }
  for(std::size_t i = 0; i < rows; ++i)
    for(std::size_t j = 0; j < columns; ++j)
    {
      const std::size_t next_row = (i + 1) % samples.size(), next = (j + 1) % n;
      const std::size_t a = index[i][j], b = index[i][next], c = index[next_row][j], d = index[next_row][next];
      const bool other_way = diagonals == Diagonals::OTHER_WAY || (diagonals == Diagonals::ALTERNATING && (i + j) % 2 == 1);
      const auto add = [&](std::size_t p, std::size_t q, std::size_t r) {
        if(p != q && q != r && r != p)
          soup.triangles.push_back({ p, q, r });
      };
      add(a, c, other_way ? b : d);
      add(other_way ? c : a, d, b);
    }
  return make_mesh(soup);
}

// the profile along z, from 0 to `depth`
inline Part extruded(std::string name, const Profile& profile, double depth, Diagonals diagonals = Diagonals::ONE_WAY)
{
  return { std::move(name),
           sweep(profile, 1, false, diagonals,
                 [&](const Point_2& p, std::size_t j) { return Point(p.x(), p.y(), depth * j); }),
           [=](const Point& p) {
             const double beyond = (std::max)({ 0., -p.z(), p.z() - depth });
             return std::hypot(profile.distance({ p.x(), p.y() }), beyond);
           } };
}

// the profile, x being the radius, around the axis z
inline Part revolved(std::string name, const Profile& profile, int segments, Diagonals diagonals = Diagonals::ONE_WAY)
{
  return { std::move(name),
           sweep(profile, segments, true, diagonals,
                 [&](const Point_2& p, std::size_t j) {
                   const double angle = 2 * CGAL_PI * j / segments;
                   return Point(p.x() * std::cos(angle), p.x() * std::sin(angle), p.y());
                 }),
           [=](const Point& p) {
             return profile.distance({ std::hypot(p.x(), p.y()), p.z() });
           } };
}

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_PARTS_H
