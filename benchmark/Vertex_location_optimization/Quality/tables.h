// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_TABLES_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_TABLES_H

#include "measures.h"

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

inline std::string to_text(double value, int digits)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

inline std::string to_text(const std::optional<double>& value, int digits) { return value ? to_text(*value, digits) : "-"; }

// one measure of all methods: remesh / piecewise linear / least squares / sparse system
template <typename T>
std::string of_all_methods(const Row& row, T Measures::*measure, int digits)
{
  std::string text;
  for(const Measures& m : row.measures)
    text += (text.empty() ? "" : " / ") + to_text(static_cast<double>(m.*measure), digits);
  return text;
}

// the reduction of an error by the three methods, in percent
inline std::string reductions(const Row& row, double Measures::*error)
{
  return to_text(row.reduction(PIECEWISE_LINEAR, error), 1) + " / " + to_text(row.reduction(LEAST_SQUARES, error), 1) +
         " / " + to_text(row.reduction(SPARSE, error), 1);
}

// The errors beside those of the paper; four values are those of the remesh and of the three methods, three those of
// the methods.
inline void print_errors(std::ostream& out, const std::vector<Row>& rows)
{
  out << "| model | remesher | vertices | mean | less, % | paper | limit | maximum | less, % | paper |\n"
         "|---|---|---|---|---|---|---|---|---|---|\n";
  for(const Row& row : rows)
    out << "| " << row.model << " | " << row.remesher << " | " << row.number_of_vertices << " | "
        << of_all_methods(row, &Measures::mean, 2) << " | " << reductions(row, &Measures::mean) << " | " << row.paper.mean
        << " | " << to_text(row.limit, 2) << " | " << of_all_methods(row, &Measures::max, 1) << " | "
        << reductions(row, &Measures::max) << " | " << row.paper.max << " |\n";
  out << std::endl;
}

// what the smaller error costs, in the same order
inline void print_costs(std::ostream& out, const std::vector<Row>& rows)
{
  out << "| model | remesher | mean back | maximum back | mean angle | smallest angle | intersecting pairs | seconds "
         "|\n"
         "|---|---|---|---|---|---|---|---|\n";
  for(const Row& row : rows)
    out << "| " << row.model << " " << row.number_of_vertices << " | " << row.remesher << " | "
        << of_all_methods(row, &Measures::mean_back, 2) << " | " << of_all_methods(row, &Measures::max_back, 1) << " | "
        << of_all_methods(row, &Measures::mean_angle, 1) << " | " << of_all_methods(row, &Measures::smallest_angle, 1)
        << " | " << of_all_methods(row, &Measures::intersections, 0) << " | " << of_all_methods(row, &Measures::seconds, 2)
        << " |\n";
  out << std::endl;
}

inline void write_head_of_CSV(std::ostream& out)
{
  out << "model,remesher,vertices,method,mean,max,mean_back,max_back,mean_angle,smallest_angle,intersecting_pairs,"
         "seconds,"
         "mean_reduction,max_reduction,paper_mean_reduction,paper_max_reduction\n";
}

// one line for each mesh
inline void write_CSV(std::ostream& out, const std::vector<Row>& rows)
{
  for(const Row& row : rows)
    for(Method method : { REMESH, PIECEWISE_LINEAR, LEAST_SQUARES, SPARSE })
    {
      const Measures& m = row.measures[method];
      out << '"' << row.model << "\",\"" << row.remesher << "\"," << row.number_of_vertices << ",\"" << method_names[method]
          << "\"," << m.mean << ',' << m.max << ',' << m.mean_back << ',' << m.max_back << ',' << m.mean_angle << ','
          << m.smallest_angle << ',' << m.intersections << ',' << m.seconds << ',' << row.reduction(method, &Measures::mean)
          << ',' << row.reduction(method, &Measures::max) << ',' << row.paper.mean << ',' << row.paper.max << '\n';
    }
  out.flush();
}

// The number of vertices with which a method has this mean error, interpolated between the rows, where both numbers are
// logarithms; nothing if the error is that of no row and between no two.
inline std::optional<double> vertices_with_error(const std::vector<Row>& rows, Method method, double error)
{
  for(std::size_t i = 1; i < rows.size(); ++i)
  {
    const double a = rows[i - 1].measures[method].mean, b = rows[i].measures[method].mean;
    if((a >= error) != (b > error) && a > b)
    {
      const double t = std::log(a / error) / std::log(a / b);
      return rows[i - 1].number_of_vertices *
             std::pow(double(rows[i].number_of_vertices) / rows[i - 1].number_of_vertices, t);
    }
  }
  return {};
}

// How many fewer vertices than a remesh, in percent, a method needs for the same mean error. `rows` are those of one
// model, coarsest first.
inline std::optional<double> fewer_vertices(const std::vector<Row>& rows, std::size_t i, Method method)
{
  const auto n = vertices_with_error(rows, method, rows[i].measures[REMESH].mean);
  return n ? std::optional<double>(100 * (1 - *n / rows[i].number_of_vertices)) : std::nullopt;
}

inline void print_fewer_vertices(std::ostream& out, const std::vector<Row>& rows)
{
  out << "| model | vertices | mean | fewer vertices, %: piecewise linear | least squares | sparse system |\n"
         "|---|---|---|---|---|---|\n";
  for(std::size_t i = 0; i < rows.size(); ++i)
  {
    out << "| " << rows[i].model << " | " << rows[i].number_of_vertices << " | "
        << of_all_methods(rows[i], &Measures::mean, 2);
    for(Method method : { PIECEWISE_LINEAR, LEAST_SQUARES, SPARSE })
      out << " | " << to_text(fewer_vertices(rows, i, method), 1);
    out << " |\n";
  }
  out << std::endl;
}

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_QUALITY_TABLES_H
