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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_READ_SIGNAL_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_READ_SIGNAL_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/attribute_maps.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Attributes/Attribute_value.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Patch_descriptors.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Reads the values at the corners of the patches of a reference surface from a map of the mesh that it was made from, of its
// vertices or of the corners of its faces. Returns whether all are there and finite.
template <typename TriangleMesh, typename Map, std::size_t N>
bool read_patch_values(const Patch_descriptors<TriangleMesh>& patches,
                       const Map& map,
                       std::vector<std::array<Signal_value<N>, 3>>& values)
{
  const auto read = [&](const auto& key, Signal_value<N>& value) {
    if(!has_value_for(map, key))
      return false;
    value = Attribute_value<typename boost::property_traits<Map>::value_type>::to_signal(get(map, key));
    return is_finite(value);
  };
  values.resize(patches.size());
  for(std::size_t patch = 0; patch < patches.size(); ++patch)
    for(int k = 0; k < 3; ++k)
    {
      bool is_read;
      if constexpr(Is_corner_map<TriangleMesh, Map>::value)
        is_read = read(patches.corner(patch, k), values[patch][k]);
      else
        is_read = read(patches.vertex(patch, k), values[patch][k]);
      if(!is_read)
        return false;
    }
  return true;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_READ_SIGNAL_H
