// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_TEST_READ_MODEL_H
#define VERTEX_LOCATION_OPTIMIZATION_TEST_READ_MODEL_H

#include "test_meshes.h"

#include <cstdlib>
#include <iostream>
#include <string>

// Ends a test, as a failure, that has nothing to go on with.
[[noreturn]] inline void fail_without(const std::string& file)
{
  std::cerr << file << " cannot be read: is CGAL_DATA_DIR the directory of CGAL's data?" << std::endl;
  std::exit(EXIT_FAILURE);
}

// a model of CGAL
inline Mesh read_model(const std::string& name)
{
  const std::string file = CGAL::data_file_path("meshes/" + name + ".off");
  Mesh mesh;
  if(!CGAL::IO::read_OFF(file, mesh) || mesh.is_empty())
    fail_without(file);
  return mesh;
}

#endif // VERTEX_LOCATION_OPTIMIZATION_TEST_READ_MODEL_H
