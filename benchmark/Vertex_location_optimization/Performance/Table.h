// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_TABLE_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_TABLE_H

#include <cstddef>
#include <cstdio>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

// A table that is printed row by row, while the measurements go on, and written to a CSV file, a line for each value:
// title, row, column, value. Without an open file it is only printed.
class Table
{
public:
  Table(std::ofstream& csv, std::string title, std::vector<std::string> columns)
    : m_csv(csv), m_title(std::move(title)), m_columns(std::move(columns))
  {
    std::printf("\n%s\n%-40s", m_title.c_str(), "");
    for(const std::string& column : m_columns)
      std::printf(" %*s", width(column), column.c_str());
    std::printf("\n");
  }

  void add_row(const std::string& name, const std::vector<double>& values)
  {
    std::printf("%-40s", name.c_str());
    for(std::size_t i = 0; i < values.size(); ++i)
    {
      std::printf(" %*.5g", width(m_columns[i]), values[i]);
      m_csv << '"' << m_title << "\",\"" << name << "\",\"" << m_columns[i] << "\"," << values[i] << '\n';
    }
    std::printf("\n");
    std::fflush(stdout);
    m_csv.flush();
  }

private:
  static int width(const std::string& column) { return column.size() < 9 ? 9 : static_cast<int>(column.size()); }

  std::ofstream& m_csv;
  std::string m_title;
  std::vector<std::string> m_columns;
};

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_TABLE_H
