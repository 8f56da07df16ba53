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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CHECK_ARGUMENTS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CHECK_ARGUMENTS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/named_parameters.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <type_traits>
#include <utility>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Checks of the arguments of the public functions, at compile time. `value` of each is `false` after an error, so that the
// function can leave out what would only give more errors.

template <typename NamedParameters, typename Tag>
constexpr bool has_parameter = !parameters::is_default_parameter<NamedParameters, Tag>::value;

// The requirements on a mesh, and on a model of `ReferenceSurface`.
struct Requirement
{
  template <typename Mesh>
  static auto descriptors(const Mesh&) -> std::void_t<typename boost::graph_traits<Mesh>::vertex_descriptor,
                                                      typename boost::graph_traits<Mesh>::halfedge_descriptor,
                                                      typename boost::graph_traits<Mesh>::face_descriptor>;
  struct Descriptors
  {
    template <typename Mesh>
    auto operator()(const Mesh& mesh) const -> decltype(descriptors(mesh));
  };
  struct Vertices
  {
    template <typename Mesh>
    auto operator()(const Mesh& mesh) const -> decltype(vertices(mesh));
  };
  struct Edges
  {
    template <typename Mesh>
    auto operator()(const Mesh& mesh) const -> decltype(edges(mesh));
  };
  struct Faces
  {
    template <typename Mesh>
    auto operator()(const Mesh& mesh) const -> decltype(faces(mesh));
  };
  struct Vertex_points
  {
    template <typename Mesh>
    auto operator()(const Mesh& mesh) const -> decltype(get(vertex_point, mesh));
  };
  struct Types
  {
    template <typename Surface>
    auto operator()(const Surface&) const -> std::void_t<typename Surface::Point_3, typename Surface::Foot>;
  };
  struct Project
  {
    template <typename Surface>
    auto operator()(const Surface& surface) const
      -> std::enable_if_t<std::is_convertible<decltype(surface.project(std::declval<typename Surface::Point_3>())),
                                              typename Surface::Foot>::value>;
  };
  struct Project_with_hint
  {
    template <typename Surface>
    auto operator()(const Surface& surface) const
      -> decltype(surface.project(std::declval<typename Surface::Point_3>(), std::declval<const typename Surface::Foot&>()));
  };
  struct Point_of_foot
  {
    template <typename Surface>
    auto operator()(const Surface& surface) const -> decltype(surface.point(std::declval<const typename Surface::Foot&>()));
  };
  struct Normal_of_foot
  {
    template <typename Surface>
    auto operator()(const Surface& surface) const -> decltype(surface.normal(std::declval<const typename Surface::Foot&>()));
  };
};

template <typename What, typename T>
constexpr bool fulfills = std::conjunction<std::is_class<T>, std::is_invocable<What, const T&>>::value;

// Whether the keys of the property map with this tag, if there is one, are the descriptors.
template <typename NamedParameters, typename Tag, typename Descriptor>
constexpr bool has_keys()
{
  if constexpr(has_parameter<NamedParameters, Tag>)
  {
    using Map = std::decay_t<decltype(parameters::get_parameter(std::declval<const NamedParameters&>(), Tag()))>;
    return std::is_convertible<Descriptor, typename boost::property_traits<Map>::key_type>::value;
  }
  else
    return true;
}

// `PolygonMesh` with the named parameters that belong to it.
template <typename PolygonMesh, typename NamedParameters>
struct Mesh_check
{
  static_assert(!std::is_const<PolygonMesh>::value, "The mesh is const: its vertices cannot be moved.");
  static constexpr bool is_graph = fulfills<Requirement::Descriptors, PolygonMesh>;
  static_assert(is_graph,
                "This is no mesh: it must be a model of FaceListGraph, with vertex_descriptor, halfedge_descriptor "
                "and face_descriptor in boost::graph_traits.");
  static constexpr bool has_vertices = !is_graph || fulfills<Requirement::Vertices, PolygonMesh>;
  static_assert(has_vertices, "vertices(mesh) is missing: the mesh must be a model of VertexListGraph.");
  static constexpr bool has_edges = !is_graph || fulfills<Requirement::Edges, PolygonMesh>;
  static_assert(has_edges, "edges(mesh) is missing: the mesh must be a model of EdgeListGraph.");
  static constexpr bool has_faces = !is_graph || fulfills<Requirement::Faces, PolygonMesh>;
  static_assert(has_faces, "faces(mesh) is missing: the mesh must be a model of FaceListGraph.");
  static constexpr bool has_points = !is_graph || has_parameter<NamedParameters, internal_np::vertex_point_t> ||
                                     fulfills<Requirement::Vertex_points, PolygonMesh>;
  static_assert(has_points, "The mesh has no internal map of its points: give one by the named parameter vertex_point_map.");

  static constexpr bool have_keys()
  {
    if constexpr(is_graph)
    {
      using vertex_descriptor = typename boost::graph_traits<PolygonMesh>::vertex_descriptor;
      using edge_descriptor = typename boost::graph_traits<PolygonMesh>::edge_descriptor;
      return has_keys<NamedParameters, internal_np::vertex_point_t, vertex_descriptor>() &&
             has_keys<NamedParameters, internal_np::vertex_is_constrained_t, vertex_descriptor>() &&
             has_keys<NamedParameters, internal_np::edge_is_constrained_t, edge_descriptor>();
    }
    else
      return true;
  }
  static_assert(have_keys(),
                "The keys of a property map are not the vertices or edges of the mesh: the maps of the remesh "
                "belong to np1, the first sequence of named parameters, those of the reference to np2.");

  static constexpr bool value =
    !std::is_const<PolygonMesh>::value && is_graph && has_vertices && has_edges && has_faces && has_points && have_keys();
};

// The sequences are distinguished by the parameters that only one of them has.
#define CGAL_VERTEX_LOCATION_refuse(NAME, TAG, REASON)                                                                      \
  static_assert(!has_parameter<NamedParameters, internal_np::TAG>, "The named parameter " #NAME " " REASON);

template <typename NamedParameters>
struct First_sequence_check
{
  CGAL_VERTEX_LOCATION_refuse(sharpness_angle,
                              sharpness_angle_t,
                              "is about the reference: give it in np2, the second sequence.");
  static constexpr bool value = true;
};

#define CGAL_VERTEX_LOCATION_refuse_in_second(NAME, TAG)                                                                    \
  CGAL_VERTEX_LOCATION_refuse(NAME, TAG, "is not about the reference: give it in np1, the first sequence.")

template <typename NamedParameters>
struct Second_sequence_check
{
  CGAL_VERTEX_LOCATION_refuse_in_second(number_of_iterations, number_of_iterations_t);
  CGAL_VERTEX_LOCATION_refuse_in_second(number_of_free_iterations, number_of_free_iterations_t);
  CGAL_VERTEX_LOCATION_refuse_in_second(number_of_relaxation_steps, number_of_relaxation_steps_t);
  CGAL_VERTEX_LOCATION_refuse_in_second(convergence_threshold, convergence_threshold_t);
  CGAL_VERTEX_LOCATION_refuse_in_second(placement_method, placement_method_t);
  CGAL_VERTEX_LOCATION_refuse_in_second(regularity_weight, regularity_weight_t);
  CGAL_VERTEX_LOCATION_refuse_in_second(vertex_is_constrained_map, vertex_is_constrained_t);
  CGAL_VERTEX_LOCATION_refuse_in_second(relax_constraints, relax_constraints_t);
  CGAL_VERTEX_LOCATION_refuse_in_second(allow_move_functor, allow_move_functor_t);
  CGAL_VERTEX_LOCATION_refuse_in_second(do_self_intersection_tests, do_self_intersection_tests_t);
  CGAL_VERTEX_LOCATION_refuse_in_second(guarantee_both_directions, guarantee_both_directions_t);
  CGAL_VERTEX_LOCATION_refuse_in_second(preserve_volume, preserve_volume_t);
  CGAL_VERTEX_LOCATION_refuse_in_second(visitor, visitor_t);
  CGAL_VERTEX_LOCATION_refuse_in_second(number_of_points_per_face, number_of_points_per_face_t);
  CGAL_VERTEX_LOCATION_refuse_in_second(number_of_points_per_area_unit, nb_points_per_area_unit_t);
  CGAL_VERTEX_LOCATION_refuse_in_second(face_error_map, face_error_map_t);
  CGAL_VERTEX_LOCATION_refuse_in_second(vertex_error_map, vertex_error_map_t);
  CGAL_VERTEX_LOCATION_refuse_in_second(clamp_to_samples, clamp_to_samples_t);
  CGAL_VERTEX_LOCATION_refuse_in_second(tolerated_error, tolerated_error_t);
  CGAL_VERTEX_LOCATION_refuse_in_second(edge_length_precision, edge_length_precision_t);
  CGAL_VERTEX_LOCATION_refuse_in_second(maximum_number_of_remeshings, maximum_number_of_remeshings_t);
  CGAL_VERTEX_LOCATION_refuse_in_second(reference_surface, reference_surface_t);
  static constexpr bool value = true;
};
#undef CGAL_VERTEX_LOCATION_refuse_in_second

// The creases of an existing surface cannot be changed.
template <typename NamedParameters>
struct Second_sequence_check_with_surface : Second_sequence_check<NamedParameters>
{
  CGAL_VERTEX_LOCATION_refuse(sharpness_angle,
                              sharpness_angle_t,
                              "comes too late for a surface that is ready: give it to the constructor of the surface.");
  CGAL_VERTEX_LOCATION_refuse(
    edge_is_constrained_map,
    edge_is_constrained_t,
    "comes too late for a surface that is ready: give the creases of the reference to the constructor of the surface, and "
    "those of the remesh in np1, the first sequence.");
};
#undef CGAL_VERTEX_LOCATION_refuse

template <typename Surface>
struct Surface_check
{
  static constexpr bool has_types = fulfills<Requirement::Types, Surface>;
  static_assert(has_types, "A model of ReferenceSurface must have the types Point_3 and Foot.");
  static constexpr bool has_project = !has_types || fulfills<Requirement::Project, Surface>;
  static_assert(has_project, "A model of ReferenceSurface must have Foot project(const Point_3& query) const.");
  static constexpr bool has_project_with_hint = !has_types || fulfills<Requirement::Project_with_hint, Surface>;
  static_assert(has_project_with_hint,
                "A model of ReferenceSurface must have Foot project(const Point_3& query, const Foot& hint) const.");
  static constexpr bool has_point = !has_types || fulfills<Requirement::Point_of_foot, Surface>;
  static_assert(has_point, "A model of ReferenceSurface must have Point_3 point(const Foot& foot) const.");
  static constexpr bool has_normal = !has_types || fulfills<Requirement::Normal_of_foot, Surface>;
  static_assert(has_normal, "A model of ReferenceSurface must have Vector_3 normal(const Foot& foot) const.");
  static constexpr bool value = has_types && has_project && has_project_with_hint && has_point && has_normal;
};

// A model of `ReferenceSurface` has a type `Foot`, a model of `FaceGraph` has none.
template <typename Reference, typename = void>
struct Is_reference_surface : std::false_type
{};

template <typename Reference>
struct Is_reference_surface<Reference, std::void_t<typename Reference::Foot>> : std::true_type
{};

template <typename Reference, typename NamedParameters>
constexpr bool check_reference()
{
  if constexpr(Is_reference_surface<Reference>::value)
    return Surface_check<Reference>::value && Second_sequence_check_with_surface<NamedParameters>::value;
  else if constexpr(!fulfills<Requirement::Descriptors, Reference>)
  {
    static_assert(
      fulfills<Requirement::Descriptors, Reference>,
      "The reference is neither a mesh, that is, a model of FaceListGraph, nor a model of ReferenceSurface, which "
      "has a type Foot.");
    return false;
  }
  else
    return Mesh_check<Reference, NamedParameters>::value && Second_sequence_check<NamedParameters>::value;
}

template <typename PolygonMesh, typename Reference, typename NamedParameters1, typename NamedParameters2>
constexpr bool check_arguments = Mesh_check<PolygonMesh, NamedParameters1>::value&&
  First_sequence_check<NamedParameters1>::value&&
  check_reference<Reference, NamedParameters2>();

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_CHECK_ARGUMENTS_H
