// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_GROWTH_CURVE_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_GROWTH_CURVE_H

#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

// Times against sizes.
struct Growth_curve
{
  std::string name;
  std::vector<double> sizes;
  std::vector<double> seconds;
};

// The slope of the straight line that fits y(x) best.
inline double slope(const std::vector<double>& x, const std::vector<double>& y)
{
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
  for(std::size_t i = 0; i < x.size(); ++i)
  {
    mean_x += x[i] / static_cast<double>(x.size());
    mean_y += y[i] / static_cast<double>(x.size());
  }
  for(std::size_t i = 0; i < x.size(); ++i)
  {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  return xy / xx;
}

inline std::vector<double> logarithms(std::vector<double> values)
{
  for(double& value : values)
    value = std::log(value);
  return values;
}

// k, where the time grows like size^k
inline double exponent(const Growth_curve& curve) { return slope(logarithms(curve.sizes), logarithms(curve.seconds)); }

// k, where the time grows like (log size)^k
inline double exponent_of_logarithm(const Growth_curve& curve)
{
  return slope(logarithms(logarithms(curve.sizes)), logarithms(curve.seconds));
}

// Writes curves over the same sizes, and the growth to compare them with: a time proportional to growth(size) that meets the
// last curve at its end.
inline void write_CSV(std::ostream& out,
                      const std::string& size,
                      const std::vector<Growth_curve>& curves,
                      const std::string& name_of_growth,
                      double (*growth)(double))
{
  out << size;
  for(const Growth_curve& curve : curves)
    out << ',' << curve.name;
  out << ',' << name_of_growth << '\n';
  const Growth_curve& last = curves.back();
  for(std::size_t i = 0; i < last.sizes.size(); ++i)
  {
    out << last.sizes[i];
    for(const Growth_curve& curve : curves)
      out << ',' << curve.seconds[i];
    out << ',' << last.seconds.back() * growth(last.sizes[i]) / growth(last.sizes.back()) << '\n';
  }
}

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_GROWTH_CURVE_H
