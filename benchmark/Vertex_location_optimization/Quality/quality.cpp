// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Reproduces Table 1, Table 2 and Figure 6 of "Vertex Location Optimisation for Improved Remeshing":
//
//   quality [DIRECTORY...]
//
// The models are those of CGAL's data, and lucy.off and david.off of the paper, where a directory has them. Prints the
// tables, with the figures of the paper beside; writes them to quality.csv, and the curves of the figure to
// error_by_vertices_MODEL.csv. Then how near to the limits of piecewise linear surfaces least squares comes, by the
// curvatures of the input. At last, what the parameter `regularity_weight` trades, and trade_off_MODEL.csv. plot_curves.gp
// draws the curves.
//
// Four numbers in a row are those of the remesh, of the two placement methods, and of a least squares fit as one sparse
// linear system. The limit is the least mean error that so many vertices can have off a smooth surface: of equilateral
// triangles of one size or, for a simplified mesh, of the best triangles. Distances are in 1e-4 of the longest side of the
// bounding box.

#include "measures.h"
#include "models.h"
#include "normals.h"
#include "remeshers.h"
#include "table_of_limits.h"
#include "tables.h"
#include "trade_off.h"

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

void make_table_1(const std::vector<std::string>& directories, std::ostream& csv)
{
  std::vector<Row> rows;
  for(const Model& model : models_of_table_1(directories))
  {
    std::cerr << model.name << std::endl;
    const std::vector<Row> of_model =
      with_reference(model, [&](const auto& reference) { return measure_remeshers(model, reference); });
    write_CSV(csv, of_model);
    rows.insert(rows.end(), of_model.begin(), of_model.end());
  }
  std::cout << "Table 1: remeshes of several remeshers\n\n";
  print_errors(std::cout, rows);
  print_costs(std::cout, rows);
}

// the curves of Figure 6
void write_figure_6(const std::vector<Row>& rows)
{
  std::ofstream csv("error_by_vertices_" + rows.front().model + ".csv");
  csv << "vertices";
  for(Method method : { REMESH, PIECEWISE_LINEAR, LEAST_SQUARES })
    csv << ',' << method_names[method];
  csv << '\n';
  for(const Row& row : rows)
  {
    csv << row.number_of_vertices;
    for(Method method : { REMESH, PIECEWISE_LINEAR, LEAST_SQUARES })
      csv << ',' << row.measures[method].mean;
    csv << '\n';
  }
}

void make_table_2(const std::vector<std::string>& directories, std::ostream& csv)
{
  for(auto& [model, edge_lengths] : models_of_table_2(directories))
  {
    std::cerr << model.name << " with " << edge_lengths.size() << " edge lengths" << std::endl;
    const PMP::PN_triangle_surface<Mesh> reference(model.input);
    std::vector<Row> rows;
    for(double edge_length : edge_lengths)
    {
      model.edge_length = edge_length;
      rows.push_back(measure_isotropic_remesh(model, reference));
    }
    write_CSV(csv, rows);
    std::cout << "Table 2 and Figure 6: " << model.name << " with several edge lengths\n\n";
    print_errors(std::cout, rows);
    print_costs(std::cout, rows);
    print_fewer_vertices(std::cout, rows);
    write_figure_6(rows);
  }
}

void print_table_of_normals(const std::vector<std::string>& directories)
{
  std::cout << "Normals\n\n";
  print_head_of_normals(std::cout);
  for(const Model& model : models_of_normals(directories))
    print_normals(std::cout, model, remesh_isotropically(model), PMP::PN_triangle_surface<Mesh>(model.input));
}

int main(int argc, char* argv[])
{
  try
  {
    const std::vector<std::string> directories(argv + 1, argv + argc);
    for(const std::string& directory : directories)
      if(!std::filesystem::is_directory(directory))
        throw std::runtime_error(directory + ": there is no such directory");

    std::ofstream csv("quality.csv");
    write_head_of_CSV(csv);
    make_table_1(directories, csv);
    make_table_2(directories, csv);
    print_table_of_normals(directories);
    std::cout << "Limits\n\n";
    print_table_of_limits(std::cout);
    if(Mesh armadillo = read_model(data_file("armadillo")); !armadillo.is_empty())
      make_trade_off({ "armadillo", std::move(armadillo), 0.03 }, std::cout);
    if(!csv)
      throw std::runtime_error("quality.csv cannot be written");
    return EXIT_SUCCESS;
  }
  catch(const std::exception& e)
  {
    std::cerr << "quality: " << e.what() << std::endl;
    return EXIT_FAILURE;
  }
}
