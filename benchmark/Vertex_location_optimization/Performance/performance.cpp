// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures how long the optimization takes, on CGAL's armadillo: the call beside the remeshing, a projection and a sparse
// fit; a projection; the speed-up by threads; the growth with the sizes; the memory. `performance --help` names the
// options.
//
// Times are those of the thread, in seconds; those of several threads are of the wall clock.

#include "measure_growth.h"
#include "measure_memory.h"
#include "measure_projections.h"
#include "measure_ratios.h"
#include "measure_threads.h"
#include "meshes.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>

#include <boost/algorithm/string.hpp>
#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace po = boost::program_options;

const std::vector<std::string> known_sections{ "ratios", "projections", "threads", "growth", "memory", "large" };

struct Options
{
  std::string file, csv, growth;
  std::vector<std::string> sections;
  bool is_quick = false;

  bool has(const std::string& section) const
  {
    return std::find(sections.begin(), sections.end(), section) != sections.end();
  }
};

Options read_options(int argc, char** argv)
{
  Options options;
  std::string sections;
  po::options_description description("Options");
  auto add = description.add_options();
  add("help,h", "print this text");
  add("quick", po::bool_switch(&options.is_quick), "small meshes, to see that it runs");
  add("sections", po::value(&sections)->default_value("ratios,projections,threads,growth,memory"),
      "which parts; `large` is a further one: 1M vertices against 5M triangles");
  add("csv", po::value(&options.csv), "file for all values: table, row, column, value");
  add("growth", po::value(&options.growth),
      "what the names of two files for the curves of the growth begin with, for plot_curves.gp; if that is measured");
  add("input", po::value(&options.file)->default_value(CGAL::data_file_path("meshes/armadillo.off")), "the model");

  po::variables_map values;
  po::store(po::parse_command_line(argc, argv, description), values);
  po::notify(values);
  if(values.count("help"))
  {
    std::printf("Usage: %s [options]\n", argv[0]);
    std::cout << description;
    std::exit(EXIT_SUCCESS);
  }
  boost::split(options.sections, sections, boost::is_any_of(","));
  for(const std::string& section : options.sections)
    if(std::find(known_sections.begin(), known_sections.end(), section) == known_sections.end())
      throw std::runtime_error("there is no section `" + section + "'");
  return options;
}

void open(std::ofstream& file, const std::string& name)
{
  if(name.empty())
    return;
  file.open(name);
  if(!file)
    throw std::runtime_error(name + " cannot be written");
}

void measure_growth(
  std::ofstream& csv, std::ofstream& remesh_csv, std::ofstream& reference_csv, const Mesh& input, bool is_quick)
{
  const auto of_remesh = measure_growth_with_remesh(csv, subdivided(input, is_quick ? 0 : 1), is_quick ? 0 : 3);
  const auto of_reference = measure_growth_with_reference(csv, input, is_quick ? 2 : 5);
  print_exponents(csv, of_remesh, of_reference);
  write_CSV(remesh_csv, "vertices", of_remesh, "linear", [](double n) { return n; });
  write_CSV(reference_csv, "triangles of the reference", of_reference, "logarithmic", [](double m) { return std::log(m); });
}

// Returns false if a result is wrong, however fast.
bool measure(const Options& options)
{
  Mesh input;
  if(!PMP::IO::read_polygon_mesh(options.file, input) || !CGAL::is_triangle_mesh(input) || is_empty(input))
    throw std::runtime_error(options.file + " is no triangle mesh that can be read");
  std::ofstream csv, growth_with_remesh, growth_with_reference; // opened now, so that nothing is measured in vain
  open(csv, options.csv);
  if(!options.growth.empty())
  {
    open(growth_with_remesh, options.growth + "_with_remesh.csv");
    open(growth_with_reference, options.growth + "_with_reference.csv");
  }
  csv << "table,row,column,value\n";

  const double edge_length = options.is_quick ? 0.03 : 0.0106;
  const Mesh reference = subdivided(input, options.is_quick ? 0 : 2);
  if(options.has("ratios"))
  {
    measure_ratios(csv, reference, edge_length);
    compare_with_remeshing(csv, input, options.is_quick ? 0.03 : 0.012);
  }
  bool is_right = true;
  if(options.has("projections") || options.has("threads") || options.has("memory"))
  {
    const Mesh mesh = remeshed(reference, edge_length);
    if(options.has("projections"))
      measure_projections(csv, reference, mesh);
    if(options.has("threads"))
      is_right = measure_threads(csv, reference, mesh);
    if(options.has("memory"))
      measure_memory(csv, reference, mesh);
  }
  if(options.has("growth"))
    measure_growth(csv, growth_with_remesh, growth_with_reference, input, options.is_quick);
  if(options.has("large"))
    measure_large(csv, input);
  return is_right;
}

int main(int argc, char** argv)
{
  try
  {
    if(measure(read_options(argc, argv)))
      return EXIT_SUCCESS;
    std::fprintf(stderr, "The result depends on the number of threads.\n");
  }
  catch(const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
  }
  return EXIT_FAILURE;
}
