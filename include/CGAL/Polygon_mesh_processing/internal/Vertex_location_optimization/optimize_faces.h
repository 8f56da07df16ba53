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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_OPTIMIZE_FACES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_OPTIMIZE_FACES_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Guarantee/New_intersections.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Placement/make_placement.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/read_optimization_parameters.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/with_reference_surface.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Remesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_mesh.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_parameters.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Vertex_location_optimizer.h>

#include <CGAL/assertions.h>

#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// Reads the faces that are not selected if the placement samples the reference, as some of these samples belong to them.
template <typename PolygonMesh, typename VertexPointMap, typename Selection>
void read_surroundings(const PolygonMesh& pmesh,
                       const VertexPointMap& vpm,
                       const Selection& selection,
                       const Optimization_options& options,
                       Remesh& remesh)
{
  if constexpr(!Selection::is_whole_mesh)
    if(options.placement_method == LEAST_SQUARES || options.guarantee_both_directions)
    {
      Mesh_descriptors<PolygonMesh> descriptors;
      read_faces(pmesh, vpm, Other_faces<Selection>(selection), remesh.surroundings, descriptors);
    }
}

// Writes the points of the vertices that have moved. If the map throws, those that were written are restored.
template <typename PolygonMesh, typename VertexPointMap>
void write_points(const Remesh& remesh, const Mesh_descriptors<PolygonMesh>& descriptors, const VertexPointMap& vpm)
{
  using vertex_descriptor = typename boost::graph_traits<PolygonMesh>::vertex_descriptor;
  using Point_3 = typename boost::property_traits<VertexPointMap>::value_type;
  std::vector<std::pair<vertex_descriptor, Point_3>> originals;
  try
  {
    for(std::size_t i = 0; i < remesh.points.size(); ++i)
      if(remesh.points[i] != remesh.initial_points[i])
      {
        const vertex_descriptor v = descriptors.vertices[i];
        originals.emplace_back(v, get(vpm, v));
        put(vpm, v, convert<Point_3>(remesh.points[i]));
      }
  }
  catch(...)
  {
    for(const auto& [v, point] : originals)
      put(vpm, v, point);
    throw;
  }
}

template <typename Visitor, typename = void>
struct Is_visitor : std::false_type
{};

template <typename Visitor>
struct Is_visitor<Visitor,
                  std::void_t<decltype(std::declval<Visitor&>().start_phase(Vertex_location_optimization_phase())),
                              decltype(std::declval<Visitor&>().end_iteration(Vertex_location_optimization_report())),
                              decltype(bool(std::declval<Visitor&>().go_further()))>> : std::true_type
{};

// What `optimize_vertex_locations()` does, with the selected faces.
template <typename ConcurrencyTag,
          typename PolygonMesh,
          typename Selection,
          typename Reference,
          typename NamedParameters1,
          typename NamedParameters2>
Vertex_location_optimization_report optimize_faces(PolygonMesh& pmesh,
                                                   const Selection& selection,
                                                   const Reference& reference,
                                                   const NamedParameters1& np1,
                                                   const NamedParameters2& np2)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  auto vpm = read_vertex_point_map(pmesh, np1);
  using Point_3 = typename boost::property_traits<decltype(vpm)>::value_type;
  using vertex_descriptor = typename boost::graph_traits<PolygonMesh>::vertex_descriptor;

  Optimization_options options = read_options(np1);
  const bool has_valid_options =
    options.convergence_threshold.value_or(0) >= 0 && options.regularity_weight.value_or(0) >= 0;
  CGAL_precondition_msg(has_valid_options, "convergence_threshold and regularity_weight must not be negative.");
  if(!has_valid_options)
    return {};

  Mesh_arrays mesh;
  Mesh_descriptors<PolygonMesh> descriptors;
  if(!read_faces(pmesh, vpm, selection, mesh, descriptors))
    return {};
  // the lengths of the edges of quads differ on purpose, and springs would equalize them
  if(mesh.has_polygons() && !options.number_of_relaxation_steps)
    options.number_of_relaxation_steps = 0;
  Constraints constraints = read_constraints(pmesh, selection, mesh, descriptors, vpm, np1);
  Remesh remesh(std::move(mesh), std::move(constraints));
  read_surroundings(pmesh, vpm, selection, options, remesh);

  auto is_allowed = choose_parameter(get_parameter(np1, internal_np::allow_move_functor), Allow_all_moves());
  static_assert(std::is_invocable_r<bool, decltype(is_allowed)&, vertex_descriptor, Point_3, Point_3>::value,
                "allow_move_functor must be callable as bool(vertex_descriptor v, Point_3 source, Point_3 target).");
  const auto allow_move = [&](std::size_t i, const Point& source, const Point& target) {
    return is_allowed(descriptors.vertices[i], convert<Point_3>(source), convert<Point_3>(target));
  };
  const Self_intersection_test<ConcurrencyTag, PolygonMesh, decltype(vpm)> find_self_intersections(
    pmesh, vpm, descriptors, options.do_self_intersection_tests);
  auto visitor_or_reference =
    choose_parameter(get_parameter(np1, internal_np::visitor), Vertex_location_optimization_default_visitor());
  auto& visitor = unwrap_reference(visitor_or_reference);
  static_assert(Is_visitor<std::remove_reference_t<decltype(visitor)>>::value,
                "The visitor must be a model of VertexLocationOptimizationVisitor, with start_phase(phase), "
                "end_iteration(report) and bool go_further(). It may derive from the default visitor; a const one cannot "
                "be told anything.");

  const auto report =
    with_reference<ConcurrencyTag>(remesh, reference, np2, Vertex_location_optimization_report(), [&](const auto& surface) {
      Vertex_location_optimization_report result = optimize<ConcurrencyTag>(
        surface, options, allow_move, find_self_intersections, visitor,
        [&](const Optimization_options& o) { return make_placement<ConcurrencyTag>(surface, remesh, o); }, remesh);
      result.reference = surface.template summary<ConcurrencyTag>();
      return result;
    });

  write_points(remesh, descriptors, vpm);
  return report;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_OPTIMIZE_FACES_H
