// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_PLOT_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_PLOT_H

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

// Curves over two logarithmic axes, as SVG.
class Log_log_plot
{
  struct Curve
  {
    std::string name, color;
    std::vector<std::pair<double, double>> points; // positive, from left to right
  };

  // an axis, from the pixel `begin` to the pixel `end`
  struct Axis
  {
    double min, max; // decimal logarithms
    double begin, end;

    double at(double value) const { return begin + (std::log10(value) - min) / (max - min) * (end - begin); }
  };

public:
  Log_log_plot(std::string title, std::string x_label, std::string y_label)
    : m_title(std::move(title))
    , m_x_label(std::move(x_label))
    , m_y_label(std::move(y_label))
  {
  }

  void add_curve(std::string name, std::string color, std::vector<std::pair<double, double>> points)
  {
    m_curves.push_back({ std::move(name), std::move(color), std::move(points) });
  }

  void write(std::ostream& out) const
  {
    const Axis x = axis(&std::pair<double, double>::first, 80, 600);
    const Axis y = axis(&std::pair<double, double>::second, 370, 50);
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 430\" font-family=\"sans-serif\" "
           "font-size=\"14\">\n"
        << "<rect width=\"640\" height=\"430\" fill=\"white\"/>\n"
        << "<text x=\"340\" y=\"28\" text-anchor=\"middle\" font-size=\"17\">" << m_title << "</text>\n"
        << "<text x=\"340\" y=\"418\" text-anchor=\"middle\">" << m_x_label << "</text>\n"
        << "<text transform=\"translate(22 210) rotate(-90)\" text-anchor=\"middle\">" << m_y_label << "</text>\n"
        << "<g stroke=\"#ddd\">\n";
    for(double tick : ticks(x))
      out << "<path d=\"M" << x.at(tick) << " " << y.begin << "V" << y.end << "\"/>\n";
    for(double tick : ticks(y))
      out << "<path d=\"M" << x.begin << " " << y.at(tick) << "H" << x.end << "\"/>\n";
    out << "</g>\n";
    for(double tick : ticks(x))
      out << "<text x=\"" << x.at(tick) << "\" y=\"390\" text-anchor=\"middle\">" << tick << "</text>\n";
    for(double tick : ticks(y))
      out << "<text x=\"72\" y=\"" << y.at(tick) + 5 << "\" text-anchor=\"end\">" << tick << "</text>\n";
    out << "<rect x=\"" << x.begin << "\" y=\"" << y.end << "\" width=\"" << x.end - x.begin << "\" height=\""
        << y.begin - y.end << "\" fill=\"none\" stroke=\"black\"/>\n";

    double legend = y.end + 22;
    for(const Curve& curve : m_curves)
    {
      write_curve(out, curve, x, y);
      out << "<path d=\"M430 " << legend - 5 << "h30\" stroke=\"" << curve.color << "\" stroke-width=\"2.5\"/>\n"
          << "<text x=\"468\" y=\"" << legend << "\">" << curve.name << "</text>\n";
      legend += 20;
    }
    out << "</svg>\n";
  }

private:
  // an axis for one of the coordinates, with a margin
  Axis axis(double std::pair<double, double>::*coordinate, double begin, double end) const
  {
    constexpr double margin = 0.06;
    Axis result{ 1e300, -1e300, begin, end };
    for(const Curve& curve : m_curves)
      for(const auto& point : curve.points)
      {
        result.min = (std::min)(result.min, std::log10(point.*coordinate) - margin);
        result.max = (std::max)(result.max, std::log10(point.*coordinate) + margin);
      }
    return result;
  }

  // 1, 2 and 5 times the powers of ten within an axis
  static std::vector<double> ticks(const Axis& axis)
  {
    std::vector<double> result;
    for(int power = int(std::floor(axis.min)); power <= axis.max; ++power)
      for(double factor : { 1., 2., 5. })
        if(const double tick = factor * std::pow(10., power);
           std::log10(tick) >= axis.min && std::log10(tick) <= axis.max)
          result.push_back(tick);
    return result;
  }

  static void write_curve(std::ostream& out, const Curve& curve, const Axis& x, const Axis& y)
  {
    out << "<polyline fill=\"none\" stroke=\"" << curve.color << "\" stroke-width=\"2.5\" points=\"";
    for(const auto& point : curve.points)
      out << x.at(point.first) << "," << y.at(point.second) << " ";
    out << "\"/>\n";
    for(const auto& point : curve.points)
      out << "<circle cx=\"" << x.at(point.first) << "\" cy=\"" << y.at(point.second) << "\" r=\"4\" fill=\""
          << curve.color << "\"/>\n";
  }

  std::string m_title, m_x_label, m_y_label;
  std::vector<Curve> m_curves;
};

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_PLOT_H
