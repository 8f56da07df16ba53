// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The command line of optimize_remesh.

#ifndef VERTEX_LOCATION_OPTIMIZATION_EXAMPLES_OPTIMIZE_REMESH_SETTINGS_H
#define VERTEX_LOCATION_OPTIMIZATION_EXAMPLES_OPTIMIZE_REMESH_SETTINGS_H

#include <CGAL/Polygon_mesh_processing/Tolerance_report.h>

#include <boost/program_options.hpp>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

struct Settings
{
  std::string input;
  std::string remesh;        // instead of remeshing
  std::string output = "./"; // prefix of the names of the files
  std::string format;        // empty: that of the input
  std::string reference = "pn";
  double edge_length = 0.02;
  bool is_absolute = false;
  double tolerance = 0; // 0: the edge length is given instead
  bool is_tolerance_relative = false;
  CGAL::Polygon_mesh_processing::Tolerated_error tolerated_error = CGAL::Polygon_mesh_processing::MAXIMUM_ERROR;
  std::optional<int> simplify; // the number of vertices, instead of remeshing
  unsigned int remeshing_iterations = 10;
  double crease_angle = 180;
  double sharpness_angle = 40;
  std::size_t iterations = 30;
  std::size_t free_iterations = 20;
  std::optional<std::size_t> relaxation_steps; // by default it depends on the mesh, as does the weight
  bool is_least_squares = false;
  std::optional<double> regularity_weight; // of least squares
  bool guarantee_both_directions = false;
  bool preserve_volume = false;
  bool relax_constraints = false;
  bool test_self_intersections = false;
  bool is_measured = false; // densely, in both directions
  bool is_triangulated = false;
  bool is_sequential = false;
  double largest_color = 0; // 0: three times the mean error of the remesh
};

// the extension of a file name, if it is a supported format
inline std::string format_of(const std::string& name)
{
  const std::string extension = std::filesystem::path(name).extension().string();
  for(const char* format : { "obj", "ply", "stl" })
    if(extension == std::string(".") + format)
      return format;
  return "off";
}

// the options, which write to the settings
inline boost::program_options::options_description describe_options(Settings& s)
{
  namespace po = boost::program_options;
  po::options_description options("Options");
  // clang-format off
  options.add_options()
    ("help,h", "print this help")
    ("edge-length,l", po::value(&s.edge_length)->default_value(s.edge_length, "0.02"),
     "target edge length of the remesh, relative to the longest side of the bounding box")
    ("absolute,a", po::bool_switch(&s.is_absolute), "the edge length is in the unit of the input")
    ("tolerance,t", po::value<std::string>(),
     "instead of an edge length: find the coarsest remesh whose largest distance from the faces of the input, in both "
     "directions, is at most this length, or this percentage of the longest side, as in 0.5%; implies "
     "--least-squares, --relax-constraints, and --reference flat unless another reference is given")
    ("tolerated-error", po::value<std::string>()->default_value("max"),
     "the error that --tolerance bounds: max, mean or rms")
    ("remesh,r", po::value(&s.remesh),
     "use this remesh, whose faces may have any number of corners, instead of remeshing the input")
    ("triangulate", po::bool_switch(&s.is_triangulated), "triangulate the faces of the input")
    ("simplify", po::value<int>()->notifier([&s](int n) { s.simplify = n; }),
     "instead of remeshing the input, simplify it by edge_collapse() to about this number of vertices")
    ("remeshing-iterations", po::value(&s.remeshing_iterations)->default_value(s.remeshing_iterations),
     "number of iterations of isotropic_remeshing()")
    ("crease-angle,c", po::value(&s.crease_angle)->default_value(s.crease_angle, "180"),
     "constrain the edges that are sharper than this angle, in degrees")
    ("relax-constraints", po::bool_switch(&s.relax_constraints), "fit creases and borders to those of the input")
    ("reference", po::value(&s.reference)->default_value(s.reference),
     "the surface that the input represents: pn, a smooth surface, or flat, its faces as they are")
    ("sharpness-angle", po::value(&s.sharpness_angle)->default_value(s.sharpness_angle, "40"),
     "the smooth surface has creases at edges sharper than this angle, in degrees")
    ("iterations,n", po::value(&s.iterations)->default_value(s.iterations),
     "maximum number of iterations of the optimization")
    ("free-iterations", po::value(&s.free_iterations)->default_value(s.free_iterations),
     "number of initial iterations in which moves are not restricted to the normals")
    ("relaxation-steps", po::value<std::size_t>()->notifier([&s](std::size_t n) { s.relaxation_steps = n; }),
     "number of relaxation steps in each free iteration; default: depends on the mesh")
    ("least-squares", po::bool_switch(&s.is_least_squares),
     "place the vertices by least squares over both surfaces instead of by the piecewise linear method")
    ("regularity-weight", po::value<double>()->notifier([&s](double weight) { s.regularity_weight = weight; }),
     "weight of the shape of the triangles in least squares; default: depends on the mesh")
    ("both-directions", po::bool_switch(&s.guarantee_both_directions),
     "also keep the distance from the input to the mesh from increasing, as least squares and --tolerance always do")
    ("preserve-volume", po::bool_switch(&s.preserve_volume), "give a closed mesh the volume of the input")
    ("test-self-intersections", po::bool_switch(&s.test_self_intersections),
     "allow no new self-intersections; implied by --least-squares")
    ("measure", po::bool_switch(&s.is_measured),
     "also measure the errors before and after densely, in both directions")
    ("sequential", po::bool_switch(&s.is_sequential), "use one thread")
    ("output,o", po::value(&s.output)->default_value(s.output), "prefix of the names of the written files")
    ("format", po::value(&s.format), "format of the meshes: off, obj, ply, stl; default: that of the input")
    ("largest-color", po::value(&s.largest_color),
     "the error that is shown in yellow, in the unit of the input; default: three times the mean error of the remesh");
  // clang-format on
  return options;
}

// Throws where the settings cannot be used.
inline void check_settings(const Settings& s)
{
  auto require = [](bool condition, const std::string& message) {
    if(!condition)
      throw std::runtime_error(message);
  };
  require(!s.input.empty(), "which mesh? See --help");
  require(s.edge_length > 0 && std::isfinite(s.edge_length), "--edge-length must be positive");
  require(s.is_absolute || s.edge_length <= 1, "--edge-length is relative and must not exceed 1; see --absolute");
  require(s.simplify.value_or(1) > 0, "--simplify must be positive");
  require(s.crease_angle >= 0 && s.sharpness_angle >= 0, "angles must not be negative");
  require(s.regularity_weight.value_or(0) >= 0, "--regularity-weight must not be negative");
  require(s.largest_color >= 0, "--largest-color must not be negative");
  require(s.reference == "pn" || s.reference == "flat", "--reference must be pn or flat");
  require(s.format == "off" || s.format == "obj" || s.format == "ply" || s.format == "stl",
          "--format must be off, obj, ply or stl");
  const std::filesystem::path folder = std::filesystem::path(s.output + "remesh").parent_path();
  require(folder.empty() || std::filesystem::is_directory(folder), folder.string() + ": there is no such folder");
}

// Reads a tolerance: a length, or a part of the longest side in percent.
inline void read_tolerance(const std::string& text, Settings& s)
{
  char* end = nullptr;
  s.tolerance = std::strtod(text.c_str(), &end);
  s.is_tolerance_relative = *end == '%';
  if(s.is_tolerance_relative)
  {
    s.tolerance /= 100;
    ++end;
  }
  if(text.empty() || *end != 0 || !(s.tolerance > 0) || !std::isfinite(s.tolerance))
    throw std::runtime_error("--tolerance must be a positive length, or one in percent of the longest side, as in 0.5%");
}

inline void read_tolerated_error(const std::string& text, Settings& s)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  for(const auto& [name, kind] :
      { std::pair("max", PMP::MAXIMUM_ERROR), std::pair("mean", PMP::MEAN_ERROR), std::pair("rms", PMP::RMS_ERROR) })
    if(text == name)
    {
      s.tolerated_error = kind;
      return;
    }
  throw std::runtime_error("--tolerated-error must be max, mean or rms");
}

// Reads the options about a tolerance.
inline void read_tolerance_options(const boost::program_options::variables_map& values, Settings& s)
{
  read_tolerated_error(values["tolerated-error"].as<std::string>(), s);
  if(!values.count("tolerance"))
    return;
  read_tolerance(values["tolerance"].as<std::string>(), s);
  if(!s.remesh.empty() || !values["edge-length"].defaulted())
    throw std::runtime_error(
      "--tolerance finds the edge length and remeshes: it goes with neither --edge-length nor --remesh");
  if(values["reference"].defaulted())
    s.reference = "flat";
}

// Throws if two options contradict each other about how the mesh is made.
inline void check_remesher(const boost::program_options::variables_map& values)
{
  if(values.count("simplify") && (values.count("remesh") || values.count("tolerance") || !values["edge-length"].defaulted()))
    throw std::runtime_error("--simplify goes with neither --edge-length nor --remesh nor --tolerance");
}

// Reads the command line. Prints the help and returns false if it asks for that.
inline bool read_settings(int argc, char* argv[], Settings& s)
{
  namespace po = boost::program_options;
  const po::options_description options = describe_options(s);
  po::options_description hidden;
  hidden.add_options()("input", po::value(&s.input));
  po::positional_options_description positional;
  positional.add("input", 1);
  po::options_description all;
  all.add(options).add(hidden);

  po::variables_map values;
  po::store(po::command_line_parser(argc, argv).options(all).positional(positional).run(), values);
  if(values.count("help"))
  {
    std::cout << "Usage: optimize_remesh [options] MESH\n\n"
              << "Remeshes MESH, optimizes the locations of the vertices, prints the errors before and after, and\n"
              << "writes the meshes as remesh and optimized, each also with its errors as colors (.ply) and as a\n"
              << "scalar (.vtp). With --tolerance, only optimized is written, and the exit status is 2 if no remesh\n"
              << "is within the tolerance. Both meshes keep the colors and normals of the vertices of MESH (.ply,\n"
              << ".off), and its texture coordinates (.obj).\n\n"
              << options;
    return false;
  }
  po::notify(values);
  if(s.is_least_squares || values.count("tolerance"))
    s.guarantee_both_directions = true; // as the functions have it by default
  if(s.format.empty())
    s.format = format_of(s.input);
  check_settings(s);
  check_remesher(values);
  read_tolerance_options(values, s);
  return true;
}

#endif // VERTEX_LOCATION_OPTIMIZATION_EXAMPLES_OPTIMIZE_REMESH_SETTINGS_H
