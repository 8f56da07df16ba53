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

// CGAL's list of named parameters with those of Vertex_location_optimization, for whoever has this directory before that of
// CGAL on the include path: they are then members of CGAL's own class and can be given in any order. The file is included
// several times, with different macros, and has no guard. Within CGAL it is not needed: there the lines of the second file
// are added to the first.
//
// clang-format off
#ifdef __GNUC__
#pragma GCC system_header // for #include_next
#endif

#ifndef CGAL_VERTEX_LOCATION_IN_PARAMETERS_INTERFACE // else there are two copies of this file
#define CGAL_VERTEX_LOCATION_IN_PARAMETERS_INTERFACE
#define CGAL_VERTEX_LOCATION_EXTENDS_NAMED_PARAMETERS
#ifdef __GNUC__
#include_next <CGAL/STL_Extension/internal/parameters_interface.h>
#else
#include "STL_Extension/internal/parameters_interface.h" // beside the file that includes this one, where MSVC looks
#endif
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/parameters_interface.h>
#undef CGAL_VERTEX_LOCATION_IN_PARAMETERS_INTERFACE
#elif defined(__GNUC__)
#include_next <CGAL/STL_Extension/internal/parameters_interface.h>
#endif
