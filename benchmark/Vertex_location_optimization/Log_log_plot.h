// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_LOG_LOG_PLOT_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_LOG_LOG_PLOT_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <sstream>
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
  static constexpr int width = 740, height = 430;

  Log_log_plot(std::string title, std::string x_label, std::string y_label)
    : m_title(std::move(title)), m_x_label(std::move(x_label)), m_y_label(std::move(y_label))
  {}

  void add_curve(std::string name, std::string color, std::vector<std::pair<double, double>> points)
  {
    m_curves.push_back({ std::move(name), std::move(color), std::move(points) });
  }

  // a dashed curve, to compare with; in the legend if it has a name
  void add_guide(std::string name, std::string color, std::vector<std::pair<double, double>> points)
  {
    m_guides.push_back({ std::move(name), std::move(color), std::move(points) });
  }

  void write(std::ostream& out, double left) const
  {
    const Axis x = axis(&std::pair<double, double>::first, 80, 550);
    const Axis y = axis(&std::pair<double, double>::second, 370, 50);
    const double center = (x.begin + x.end) / 2;
    out << "<g transform=\"translate(" << left << " 0)\" font-family=\"sans-serif\" font-size=\"14\">\n"
        << "<text x=\"" << center << "\" y=\"28\" text-anchor=\"middle\" font-size=\"17\">" << m_title << "</text>\n"
        << "<text x=\"" << center << "\" y=\"418\" text-anchor=\"middle\">" << m_x_label << "</text>\n"
        << "<text transform=\"translate(22 210) rotate(-90)\" text-anchor=\"middle\">" << m_y_label << "</text>\n"
        << "<g stroke=\"#ddd\">\n";
    for(double tick : ticks(x))
      out << "<path d=\"M" << x.at(tick) << " " << y.begin << "V" << y.end << "\"/>\n";
    for(double tick : ticks(y))
      out << "<path d=\"M" << x.begin << " " << y.at(tick) << "H" << x.end << "\"/>\n";
    out << "</g>\n";
    for(double tick : ticks(x))
      out << "<text x=\"" << x.at(tick) << "\" y=\"390\" text-anchor=\"middle\">" << label(tick) << "</text>\n";
    for(double tick : ticks(y))
      out << "<text x=\"72\" y=\"" << y.at(tick) + 5 << "\" text-anchor=\"end\">" << label(tick) << "</text>\n";
    out << "<rect x=\"" << x.begin << "\" y=\"" << y.end << "\" width=\"" << x.end - x.begin << "\" height=\""
        << y.begin - y.end << "\" fill=\"none\" stroke=\"black\"/>\n";

    double legend = y.end + 12;
    const auto write_curves = [&](const std::vector<Curve>& curves, const std::string& style, double radius) {
      for(const Curve& curve : curves)
      {
        const std::string stroke = " stroke=\"" + curve.color + "\" " + style;
        out << "<polyline fill=\"none\"" << stroke << " points=\"";
        for(const auto& point : curve.points)
          out << x.at(point.first) << "," << y.at(point.second) << " ";
        out << "\"/>\n";
        for(const auto& point : curve.points)
          out << "<circle cx=\"" << x.at(point.first) << "\" cy=\"" << y.at(point.second) << "\" r=\"" << radius
              << "\" fill=\"" << curve.color << "\"/>\n";
        if(curve.name.empty())
          continue;
        out << "<path d=\"M562 " << legend - 5 << "h25\"" << stroke << "/>\n"
            << "<text x=\"594\" y=\"" << legend << "\">" << curve.name << "</text>\n";
        legend += 20;
      }
    };
    write_curves(m_guides, "stroke-width=\"1\" stroke-dasharray=\"4 4\"", 0);
    write_curves(m_curves, "stroke-width=\"2.5\"", 4);
    out << "</g>\n";
  }

private:
  // an axis for one of the coordinates, with a margin
  Axis axis(double std::pair<double, double>::*coordinate, double begin, double end) const
  {
    constexpr double margin = 0.06;
    Axis result{ 1e300, -1e300, begin, end };
    for(const std::vector<Curve>* curves : { &m_curves, &m_guides })
      for(const Curve& curve : *curves)
        for(const auto& point : curve.points)
        {
          result.min = (std::min)(result.min, std::log10(point.*coordinate) - margin);
          result.max = (std::max)(result.max, std::log10(point.*coordinate) + margin);
        }
    return result;
  }

  // the powers of ten within an axis; where these are few 2 and 5 times them, too
  static std::vector<double> ticks(const Axis& axis)
  {
    std::vector<double> result;
    const bool has_many_powers = axis.max - axis.min > 2;
    for(int power = int(std::floor(axis.min)); power <= axis.max; ++power)
      for(double factor : { 1., 2., 5. })
        if(const double tick = factor * std::pow(10., power);
           std::log10(tick) >= axis.min && std::log10(tick) <= axis.max && (factor == 1 || !has_many_powers))
          result.push_back(tick);
    return result;
  }

  // with K for thousands and M for millions
  static std::string label(double tick)
  {
    std::ostringstream text;
    if(tick >= 1e6)
      text << tick / 1e6 << "M";
    else if(tick >= 1e3)
      text << tick / 1e3 << "K";
    else
      text << tick;
    return text.str();
  }

  std::string m_title, m_x_label, m_y_label;
  std::vector<Curve> m_curves, m_guides;
};

// Writes an SVG file of plots side by side.
inline void write_svg(std::ostream& out, const std::vector<Log_log_plot>& plots)
{
  const int width = Log_log_plot::width * static_cast<int>(plots.size());
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << width << " " << Log_log_plot::height << "\">\n"
      << "<rect width=\"" << width << "\" height=\"" << Log_log_plot::height << "\" fill=\"white\"/>\n";
  for(std::size_t k = 0; k < plots.size(); ++k)
    plots[k].write(out, Log_log_plot::width * static_cast<double>(k));
  out << "</svg>\n";
}

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_LOG_LOG_PLOT_H
