// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_GROWTH_CURVE_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_GROWTH_CURVE_H

#include "../Log_log_plot.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
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

// Beside each curve the paper's growth, up to its last point: the time would be proportional to growth(size).
inline Log_log_plot growth_plot(const std::vector<Growth_curve>& curves,
                                const std::string& label,
                                const std::string& name_of_growth,
                                double (*growth)(double))
{
  Log_log_plot plot("", label, "seconds");
  const std::vector<std::string> colors{ "#0050c0", "#008000", "#808080" };
  for(std::size_t k = 0; k < curves.size(); ++k)
  {
    const Growth_curve& curve = curves[k];
    std::vector<std::pair<double, double>> measured, expected;
    for(std::size_t i = 0; i < curve.sizes.size(); ++i)
    {
      measured.emplace_back(curve.sizes[i], curve.seconds[i]);
      expected.emplace_back(curve.sizes[i], curve.seconds.back() * growth(curve.sizes[i]) / growth(curve.sizes.back()));
    }
    plot.add_curve(curve.name, colors[k % colors.size()], measured);
    plot.add_guide(k == 0 ? name_of_growth : "", colors[k % colors.size()], expected);
  }
  return plot;
}

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_GROWTH_CURVE_H
