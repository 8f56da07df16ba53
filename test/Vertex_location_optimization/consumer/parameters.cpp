// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/named_parameters.h>

// The parameters of the package, in any order, before those of CGAL: this works wherever the include directories are.
auto make_parameters()
{
  return CGAL::parameters::convergence_threshold(1e-3).number_of_free_iterations(5).sharpness_angle(3).number_of_iterations(
    10);
}
