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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_REMESHING_ATTEMPT_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_REMESHING_ATTEMPT_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/approximation_error.h>
#include <CGAL/Polygon_mesh_processing/Flat_triangle_surface.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/named_parameters.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Tolerance/measure_deviations.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Tolerance/refine_spots.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Tolerance/Tolerance_setting.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_locations.h>
#include <CGAL/Polygon_mesh_processing/Tolerance_report.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// One remesh: made, optimized, refined where it is beyond the tolerance, and measured.
template <typename ConcurrencyTag, typename TriangleMesh, typename Surface, typename NamedParameters, typename Visitor>
class Remeshing_attempt
{
  // This part of the faces, or eight faces, may exceed the tolerance after the optimization: their edges are split, in
  // rounds. The largest error of a remesh occurs in some spots; a few more vertices there are better than a shorter edge
  // length everywhere. With a larger part, more vertices would be added than the longer edges save, or the rounds would not
  // end.
  static constexpr double largest_part_to_refine = 0.2;
  static constexpr std::size_t least_number_to_refine = 8;
  static constexpr double margin = 0.985; // of the tolerance: deviations are those of samples
  static constexpr int largest_number_of_rounds = 24;
  static constexpr int largest_number_in_vain = 4; // rounds, in which no fewer faces were beyond, and at least eight

  using Setting = Tolerance_setting<TriangleMesh, Surface>;
  using Edge_map = typename boost::property_map<TriangleMesh, dynamic_edge_property_t<bool>>::type;
  using Vertex_map = typename boost::property_map<TriangleMesh, dynamic_vertex_property_t<bool>>::type;
  using Named_parameters_with_method = Polygon_mesh_processing::internal::
    Vertex_location_named_parameters<Placement_method, internal_np::placement_method_t, NamedParameters>;
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

public:
  Remeshing_attempt(const Setting& setting, const NamedParameters& np, Visitor& visitor, TriangleMesh& mesh)
    : m_setting(setting), m_np(np), m_visitor(visitor), m_mesh(mesh)
  {}

  template <typename Remesh>
  void run(const Remesh& remesh, double edge_length)
  {
    m_report.edge_length = edge_length;
    call_remesher(remesh, edge_length);
    if(!has_finite_triangles())
      return;
    optimize();
    if(m_setting.kind == MAXIMUM_ERROR)
      refine();
    else
      measure();
  }

  const Tolerance_report& report() const { return m_report; }

  // The error that guides the search, relative to the tolerance. It leaves out the few faces that may be refined, whose
  // error varies strongly from length to length.
  double typical_error() const
  {
    const double error = m_setting.kind == MAXIMUM_ERROR ? m_typical_deviation : tolerated_value(m_report, m_setting.kind);
    return error / m_setting.tolerance;
  }

private:
  // A remesher may take the map of the constrained edges, which it must update, and that of the corners. A remesher without
  // these maps may replace the copy by another mesh, without constrained edges.
  template <typename Remesh>
  void call_remesher(const Remesh& remesh, double edge_length)
  {
    if constexpr(std::is_invocable<const Remesh&, TriangleMesh&, double, const Edge_map&, const Vertex_map&>::value)
      remesh(m_mesh, edge_length, mark_kept_edges(), mark_corners());
    else if constexpr(std::is_invocable<const Remesh&, TriangleMesh&, double, const Edge_map&>::value)
      remesh(m_mesh, edge_length, mark_kept_edges());
    else
    {
      static_assert(
        std::is_invocable<const Remesh&, TriangleMesh&, double>::value,
        "The remesher must be callable as remesh(mesh, edge_length), and may take maps of the edges and vertices.");
      remesh(m_mesh, edge_length);
      m_is_constrained.emplace(get(dynamic_edge_property_t<bool>(), m_mesh));
      for(auto e : edges(m_mesh))
        put(*m_is_constrained, e, false);
    }
  }

  // A copy has its elements in the order of the original.
  const Edge_map& mark_kept_edges()
  {
    m_is_constrained.emplace(get(dynamic_edge_property_t<bool>(), m_mesh));
    auto is_kept = m_setting.kept.edges.begin();
    for(auto e : edges(m_mesh))
      put(*m_is_constrained, e, *is_kept++ != 0);
    return *m_is_constrained;
  }

  Vertex_map mark_corners() const
  {
    Vertex_map is_corner = get(dynamic_vertex_property_t<bool>(), m_mesh);
    auto is_kept = m_setting.kept.vertices.begin();
    for(auto v : vertices(m_mesh))
      put(is_corner, v, *is_kept++ != 0);
    return is_corner;
  }

  bool has_finite_triangles() const
  {
    return faces(m_mesh).begin() != faces(m_mesh).end() && is_finite_triangle_mesh(m_mesh, get(vertex_point, m_mesh));
  }

  void optimize() { optimize_vertex_locations<ConcurrencyTag>(m_mesh, m_setting.surface, named_parameters()); }

  // Only some faces, so that the others remain within the tolerance; all faces if the volume is to be preserved.
  void optimize_around(const std::vector<face_descriptor>& faces)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;

    if(choose_parameter(get_parameter(m_np, internal_np::preserve_volume), false))
      optimize();
    else
      optimize_vertex_locations<ConcurrencyTag>(faces, m_mesh, m_setting.surface, named_parameters());
  }

  auto named_parameters() const
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;

    const Placement_method method = choose_parameter(get_parameter(m_np, internal_np::placement_method), LEAST_SQUARES);
    const bool relax = choose_parameter(get_parameter(m_np, internal_np::relax_constraints), true);
    return Named_parameters_with_method(method, m_np)
      .vertex_point_map(get(vertex_point, m_mesh))
      .edge_is_constrained_map(*m_is_constrained)
      .vertex_is_constrained_map(Static_boolean_property_map<vertex_descriptor, false>())
      .relax_constraints(relax)
      .visitor(std::ref(m_visitor));
  }

  // Refines the faces beyond the tolerance as long as they are few, and measures the result.
  void refine()
  {
    double limit = margin * m_setting.tolerance;
    std::size_t least_number = (std::numeric_limits<std::size_t>::max)(); // of faces beyond, so far
    for(int round = 0, rounds_in_vain = 0;; ++round)
    {
      Mesh_arrays mesh;
      Mesh_descriptors<TriangleMesh> descriptors;
      read_mesh(m_mesh, get(vertex_point, m_mesh), mesh, descriptors);
      const std::vector<double> deviations = measure_face_deviations(mesh);
      const std::size_t largest_number = number_to_refine(deviations.size());
      if(round == 0)
        m_typical_deviation = value_of_rank(deviations, largest_number);

      std::vector<std::size_t> faces_beyond = find_faces_beyond(limit, deviations);
      if(faces_beyond.empty())
      {
        measure();
        if(m_report.is_within_tolerance)
          return;
        // The deviations have missed something: their tolerance is reduced.
        limit *= 0.99 * m_setting.tolerance / tolerated_value(m_report, m_setting.kind);
        faces_beyond = find_faces_beyond(limit, deviations);
        least_number = (std::numeric_limits<std::size_t>::max)();
      }
      rounds_in_vain = faces_beyond.size() < (std::max)(least_number, least_number_to_refine) ? 0 : rounds_in_vain + 1;
      least_number = (std::min)(least_number, faces_beyond.size());
      if(round == largest_number_of_rounds || rounds_in_vain > largest_number_in_vain ||
         faces_beyond.size() > largest_number || !m_visitor.go_further())
        break;
      optimize_around(refine_spots(mesh, descriptors, faces_beyond, limit));
    }
    measure();
  }

  // returns the faces around the changes
  std::vector<face_descriptor> refine_spots(const Mesh_arrays& mesh,
                                            const Mesh_descriptors<TriangleMesh>& descriptors,
                                            const std::vector<std::size_t>& faces_beyond,
                                            double limit)
  {
    const auto& reference = access_reference(m_setting.surface);
    const auto vpm = get(vertex_point, m_mesh);
    return Spot_refinement<ConcurrencyTag, TriangleMesh, std::decay_t<decltype(vpm)>, Edge_map,
                           std::decay_t<decltype(reference)>>(mesh, descriptors, reference, m_mesh, vpm, *m_is_constrained)
      .refine(faces_beyond, limit);
  }

  static std::size_t number_to_refine(std::size_t number_of_faces)
  {
    return (std::max)(least_number_to_refine, static_cast<std::size_t>(largest_part_to_refine * number_of_faces));
  }

  // the value that `rank` values are larger than
  static double value_of_rank(std::vector<double> values, std::size_t rank)
  {
    const auto nth = values.begin() + (std::min)(rank, values.size() - 1);
    std::nth_element(values.begin(), nth, values.end(), std::greater<double>());
    return *nth;
  }

  std::vector<double> measure_face_deviations(const Mesh_arrays& mesh) const
  {
    const auto& reference = access_reference(m_setting.surface);
    return measure_deviations<ConcurrencyTag>(mesh, reference, samples_for(mesh).points);
  }

  // as dense as so many samples for each face of a mesh
  Reference_samples samples_for(const Mesh_arrays& mesh) const
  {
    constexpr double samples_per_face = 36;
    double area = 0;
    for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      area += mesh.area(f);
    return sample_reference<ConcurrencyTag>(access_reference(m_setting.surface), m_setting.input_arrays,
                                            m_setting.input_surface.patches(),
                                            area / (samples_per_face * mesh.number_of_faces()));
  }

  void measure()
  {
    m_report.number_of_vertices = vertices(m_mesh).size();
    m_report.to_reference = approximation_error<ConcurrencyTag>(m_mesh, m_setting.surface);
    m_report.from_reference = measure_from_reference();
    m_report.is_within_tolerance = tolerated_value(m_report, m_setting.kind) <= m_setting.tolerance;
  }

  Approximation_error measure_from_reference() const
  {
    if constexpr(!std::is_same<Surface, Flat_triangle_surface<TriangleMesh>>::value)
    {
      Mesh_arrays mesh;
      Mesh_descriptors<TriangleMesh> descriptors;
      read_mesh(m_mesh, get(vertex_point, m_mesh), mesh, descriptors);
      return measure_samples<ConcurrencyTag>(samples_for(mesh), mesh);
    }
    else
    {
      const Flat_triangle_surface<TriangleMesh> surface(m_mesh, parameters::default_values(), ConcurrencyTag());
      return approximation_error<ConcurrencyTag>(m_setting.input, surface);
    }
  }

  const Setting& m_setting;
  const NamedParameters& m_np;
  Visitor& m_visitor;
  TriangleMesh& m_mesh;
  std::optional<Edge_map> m_is_constrained;
  Tolerance_report m_report;
  double m_typical_deviation = std::numeric_limits<double>::infinity();
};

// Remeshes, optimizes and measures `mesh`, a copy of the input. Returns the report and the error that the search goes by.
template <typename ConcurrencyTag,
          typename TriangleMesh,
          typename Remesh,
          typename Surface,
          typename NamedParameters,
          typename Visitor>
std::pair<Tolerance_report, double> try_edge_length(const Tolerance_setting<TriangleMesh, Surface>& setting,
                                                    double edge_length,
                                                    std::size_t number,
                                                    const Remesh& remesh,
                                                    const NamedParameters& np,
                                                    Visitor& visitor,
                                                    TriangleMesh& mesh)
{
  Remeshing_attempt<ConcurrencyTag, TriangleMesh, Surface, NamedParameters, Visitor> attempt(setting, np, visitor, mesh);
  attempt.run(remesh, edge_length);
  Tolerance_report report = attempt.report();
  report.number_of_remeshings = number;
  return { report, attempt.typical_error() };
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_REMESHING_ATTEMPT_H
