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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_NAMED_PARAMETERS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_NAMED_PARAMETERS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Named_function_parameters.h>

#include <type_traits>

// Where this package's parameters_interface.h takes the place of CGAL's, as it would within CGAL, the named parameters of
// this package are members of `Named_function_parameters` like all others, and nothing is left to do here.
#ifdef CGAL_VERTEX_LOCATION_EXTENDS_NAMED_PARAMETERS

namespace CGAL::Polygon_mesh_processing::internal {

template <typename T, typename Tag, typename Base = internal_np::No_property>
using Vertex_location_named_parameters = Named_function_parameters<T, Tag, Base>;

} // namespace CGAL::Polygon_mesh_processing::internal

// If the directory of CGAL comes first on the include path, no members can be added to that class, and they belong to a
// class derived from it. The derived class has no data of its own, so that the conversion to its base is lossless. A
// parameter of CGAL that is chained to it returns a `Named_function_parameters`, so that parameters of this package must
// come first.
#else

namespace CGAL {
namespace internal_np {
#define CGAL_add_named_parameter(X, Y, Z)                                                                                   \
  enum X                                                                                                                    \
  {                                                                                                                         \
    Y                                                                                                                       \
  };
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/parameters_interface.h>
#undef CGAL_add_named_parameter
} // namespace internal_np

namespace Polygon_mesh_processing {
namespace internal {

template <typename T, typename Tag, typename Base = internal_np::No_property>
struct Vertex_location_named_parameters : Named_function_parameters<T, Tag, Base>
{
  using Parameters = Named_function_parameters<T, Tag, Base>;
  using Parameters::Parameters;

#define CGAL_add_named_parameter(X, Y, Z)                                                                                   \
  template <typename K>                                                                                                     \
  Vertex_location_named_parameters<K, internal_np::X, Parameters> Z(const K& k) const                                       \
  {                                                                                                                         \
    return Vertex_location_named_parameters<K, internal_np::X, Parameters>(k, *this);                                       \
  }
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/parameters_interface.h>
  CGAL_add_named_parameter(sharpness_angle_t, sharpness_angle, sharpness_angle)
#undef CGAL_add_named_parameter
};

} // namespace internal
} // namespace Polygon_mesh_processing

namespace parameters {

#define CGAL_add_named_parameter(X, Y, Z)                                                                                   \
  template <typename K>                                                                                                     \
  Polygon_mesh_processing::internal::Vertex_location_named_parameters<K, internal_np::X> Z(const K& k)                      \
  {                                                                                                                         \
    return Polygon_mesh_processing::internal::Vertex_location_named_parameters<K, internal_np::X>(k);                       \
  }
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/parameters_interface.h>
#undef CGAL_add_named_parameter

} // namespace parameters
} // namespace CGAL

#endif // CGAL_VERTEX_LOCATION_EXTENDS_NAMED_PARAMETERS

namespace CGAL::Polygon_mesh_processing::internal {

// Whether T is a sequence of named parameters, to tell it from an argument that comes before.
template <typename T, typename Tag, typename Base>
std::true_type is_named_parameters(const Named_function_parameters<T, Tag, Base>*);
std::false_type is_named_parameters(const void*);

template <typename T>
using Is_named_parameters = decltype(is_named_parameters(static_cast<const T*>(nullptr)));

} // namespace CGAL::Polygon_mesh_processing::internal

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_NAMED_PARAMETERS_H
