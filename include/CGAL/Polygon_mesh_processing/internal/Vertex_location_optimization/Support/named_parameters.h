// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_NAMED_PARAMETERS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_NAMED_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>

#include <type_traits>

// the parameters that CGAL does not have
#define CGAL_VERTEX_LOCATION_for_each_named_parameter(F)                                                                    \
  F(number_of_free_iterations)                                                                                              \
  F(convergence_threshold)                                                                                                  \
  F(placement_method)                                                                                                       \
  F(regularity_weight)                                                                                                      \
  F(guarantee_both_directions)                                                                                              \
  F(preserve_volume)                                                                                                        \
  F(face_error_map)                                                                                                         \
  F(vertex_error_map)                                                                                                       \
  F(clamp_to_samples)                                                                                                       \
  F(tolerated_error) F(edge_length_precision) F(maximum_number_of_remeshings) F(reference_surface) F(gradation)

namespace CGAL {
namespace internal_np {
#define CGAL_VERTEX_LOCATION_named_parameter(NAME) enum NAME##_t{ NAME };
CGAL_VERTEX_LOCATION_for_each_named_parameter(CGAL_VERTEX_LOCATION_named_parameter)
#undef CGAL_VERTEX_LOCATION_named_parameter
} // namespace internal_np

namespace Polygon_mesh_processing {
namespace internal {

// The named parameters of this package. `Named_function_parameters` is closed to new members, so this class adds them;
// it holds no data of its own, so that converting it to its base loses nothing. A parameter of CGAL that is chained to
// it returns a `Named_function_parameters`: parameters of this package come first.
template <typename T, typename Tag, typename Base = internal_np::No_property>
struct Vertex_location_named_parameters : Named_function_parameters<T, Tag, Base>
{
  using Parameters = Named_function_parameters<T, Tag, Base>;
  using Parameters::Parameters;

#define CGAL_VERTEX_LOCATION_named_parameter(NAME)                                                                          \
  template <typename K>                                                                                                     \
  Vertex_location_named_parameters<K, internal_np::NAME##_t, Parameters> NAME(const K& k) const                             \
  {                                                                                                                         \
    return Vertex_location_named_parameters<K, internal_np::NAME##_t, Parameters>(k, *this);                                \
  }
  CGAL_VERTEX_LOCATION_for_each_named_parameter(CGAL_VERTEX_LOCATION_named_parameter)
    CGAL_VERTEX_LOCATION_named_parameter(sharpness_angle)
#undef CGAL_VERTEX_LOCATION_named_parameter
};

// Whether T is a sequence of named parameters, to tell it from an argument that comes before.
template <typename T, typename Tag, typename Base>
std::true_type is_named_parameters(const Named_function_parameters<T, Tag, Base>*);
std::false_type is_named_parameters(const void*);

template <typename T>
using Is_named_parameters = decltype(is_named_parameters(static_cast<const T*>(nullptr)));

} // namespace internal
} // namespace Polygon_mesh_processing

namespace parameters {

#define CGAL_VERTEX_LOCATION_named_parameter(NAME)                                                                          \
  template <typename K>                                                                                                     \
  Polygon_mesh_processing::internal::Vertex_location_named_parameters<K, internal_np::NAME##_t> NAME(const K& k)            \
  {                                                                                                                         \
    return Polygon_mesh_processing::internal::Vertex_location_named_parameters<K, internal_np::NAME##_t>(k);                \
  }
CGAL_VERTEX_LOCATION_for_each_named_parameter(CGAL_VERTEX_LOCATION_named_parameter)
#undef CGAL_VERTEX_LOCATION_for_each_named_parameter
#undef CGAL_VERTEX_LOCATION_named_parameter

} // namespace parameters
} // namespace CGAL

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_NAMED_PARAMETERS_H
