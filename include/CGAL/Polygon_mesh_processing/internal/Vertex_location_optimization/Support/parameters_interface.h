// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
//
// Author(s)     : The Vertex_location_optimization authors

// The named parameters that CGAL does not have: the lines that would be added to
// CGAL/STL_Extension/internal/parameters_interface.h. Like that file it has no guard.
// clang-format off

// List of named parameters used in the package 'Vertex Location Optimization'
CGAL_add_named_parameter(number_of_free_iterations_t, number_of_free_iterations, number_of_free_iterations)
CGAL_add_named_parameter(convergence_threshold_t, convergence_threshold, convergence_threshold)
CGAL_add_named_parameter(placement_method_t, placement_method, placement_method)
CGAL_add_named_parameter(regularity_weight_t, regularity_weight, regularity_weight)
CGAL_add_named_parameter(guarantee_both_directions_t, guarantee_both_directions, guarantee_both_directions)
CGAL_add_named_parameter(preserve_volume_t, preserve_volume, preserve_volume)
CGAL_add_named_parameter(face_error_map_t, face_error_map, face_error_map)
CGAL_add_named_parameter(vertex_error_map_t, vertex_error_map, vertex_error_map)
CGAL_add_named_parameter(clamp_to_samples_t, clamp_to_samples, clamp_to_samples)
CGAL_add_named_parameter(tolerated_error_t, tolerated_error, tolerated_error)
CGAL_add_named_parameter(edge_length_precision_t, edge_length_precision, edge_length_precision)
CGAL_add_named_parameter(maximum_number_of_remeshings_t, maximum_number_of_remeshings, maximum_number_of_remeshings)
CGAL_add_named_parameter(reference_surface_t, reference_surface, reference_surface)
CGAL_add_named_parameter(gradation_t, gradation, gradation)
