// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_WRITE_GROWTH_PLOT_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_WRITE_GROWTH_PLOT_H

#include "Growth_curve.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

// One diagram of an SVG file, both axes logarithmic, 100 pixels a power of ten.
class Growth_diagram
{
public:
  // `growth` is the paper's: the time is proportional to it
  Growth_diagram(std::ofstream& svg, double left, const std::vector<Growth_curve>& curves, double (*growth)(double))
    : m_svg(svg)
    , m_left(left)
    , m_growth(growth)
  {
    for(const Growth_curve& curve : curves)
      for(std::size_t i = 0; i < curve.sizes.size(); ++i)
      {
        extend(m_x, std::log10(curve.sizes[i]));
        extend(m_y, std::log10(curve.seconds[i]));
        extend(m_y, expected(curve, i));
      }
    m_x = { std::floor(m_x.min), std::ceil(m_x.max) };
    m_y = { std::floor(m_y.min), std::ceil(m_y.max) };
  }

  double right() const { return x(m_x.max) + 60; }
  double bottom() const { return y(m_y.min) + 60; }

  void write_axes(const std::string& label) const
  {
    for(double power = m_x.min; power <= m_x.max; ++power)
    {
      write_line(x(power), y(m_y.min), x(power), y(m_y.max), "#ccc", "");
      write_text(x(power), y(m_y.min) + 16, power_of_ten(power), "middle");
    }
    for(double power = m_y.min; power <= m_y.max; ++power)
    {
      write_line(x(m_x.min), y(power), x(m_x.max), y(power), "#ccc", "");
      write_text(x(m_x.min) - 6, y(power) + 4, power_of_ten(power), "end");
    }
    write_text(x((m_x.min + m_x.max) / 2), y(m_y.min) + 36, label, "middle");
    write_text(x(m_x.min), top - 10, "seconds", "middle");
  }

  // the k-th curve and, dashed, the paper's growth up to its last point
  void write_curve(const Growth_curve& curve, std::size_t k) const
  {
    const std::string color = k == 0 ? "#1f5fa8" : "#c0392b";
    for(std::size_t i = 0; i < curve.sizes.size(); ++i)
    {
      const double px = x(std::log10(curve.sizes[i])), py = y(std::log10(curve.seconds[i]));
      m_svg << "<circle cx='" << px << "' cy='" << py << "' r='3' fill='" << color << "'/>\n";
      if(i == 0)
        continue;
      const double previous = x(std::log10(curve.sizes[i - 1]));
      write_line(previous, y(std::log10(curve.seconds[i - 1])), px, py, color, "");
      write_line(previous, y(expected(curve, i - 1)), px, y(expected(curve, i)), color, " stroke-dasharray='4 4'");
    }
    m_svg << "<g fill='" << color << "'>";
    write_text(x(m_x.min) + 8, top + 16 + 16 * static_cast<double>(k), curve.name, "start");
    m_svg << "</g>\n";
  }

private:
  struct Range
  {
    double min = (std::numeric_limits<double>::max)();
    double max = std::numeric_limits<double>::lowest();
  };

  static void extend(Range& range, double value)
  {
    range.min = (std::min)(range.min, value);
    range.max = (std::max)(range.max, value);
  }

  // the power of ten of the seconds that the paper's growth gives for the i-th size
  double expected(const Growth_curve& curve, std::size_t i) const
  {
    return std::log10(curve.seconds.back() * m_growth(curve.sizes[i]) / m_growth(curve.sizes.back()));
  }

  static std::string power_of_ten(double power)
  {
    return "10<tspan dy='-5' font-size='9'>" + std::to_string(static_cast<int>(power)) + "</tspan>";
  }

  double x(double power) const { return m_left + 60 + 100 * (power - m_x.min); }
  double y(double power) const { return top + 100 * (m_y.max - power); }

  void write_line(double x0, double y0, double x1, double y1, const std::string& color, const std::string& style) const
  {
    m_svg << "<line x1='" << x0 << "' y1='" << y0 << "' x2='" << x1 << "' y2='" << y1 << "' stroke='" << color << "'"
          << style << "/>\n";
  }

  void write_text(double px, double py, const std::string& text, const char* anchor) const
  {
    m_svg << "<text x='" << px << "' y='" << py << "' text-anchor='" << anchor << "'>" << text << "</text>\n";
  }

  static constexpr double top = 40;

  std::ofstream& m_svg;
  double m_left;
  double (*m_growth)(double);
  Range m_x, m_y; // powers of ten
};

// The diagrams side by side: the growth with the size of the remesh, and with that of the reference.
inline void write_growth_plot(std::ofstream& svg,
                              const std::vector<Growth_curve>& of_remesh,
                              const std::vector<Growth_curve>& of_reference)
{
  const Growth_diagram left(svg, 0, of_remesh, [](double n) { return n; });
  const Growth_diagram right(svg, left.right(), of_reference, [](double n) { return std::log(n); });
  svg << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 " << right.right() << " "
      << (std::max)(left.bottom(), right.bottom()) << "' font-family='sans-serif' font-size='12'>\n"
      << "<rect width='100%' height='100%' fill='white'/>\n";
  left.write_axes("vertices (dashed: linear)");
  right.write_axes("reference triangles (dashed: logarithmic)");
  for(std::size_t k = 0; k < of_remesh.size(); ++k)
    left.write_curve(of_remesh[k], k);
  for(std::size_t k = 0; k < of_reference.size(); ++k)
    right.write_curve(of_reference[k], k);
  svg << "</svg>\n";
}

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_WRITE_GROWTH_PLOT_H
