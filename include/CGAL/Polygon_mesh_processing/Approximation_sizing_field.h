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

#ifndef CGAL_POLYGON_MESH_PROCESSING_APPROXIMATION_SIZING_FIELD_H
#define CGAL_POLYGON_MESH_PROCESSING_APPROXIMATION_SIZING_FIELD_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/version.h>

// Before CGAL 6 `isotropic_remeshing()` takes no sizing field, and this header is empty.
#if CGAL_VERSION_NR >= 1060000000

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/make_reference_patches.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Sizing/compute_edge_lengths.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/named_parameters.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/read_parameters.h>
#include <CGAL/Polygon_mesh_processing/Tolerance_report.h>

#include <CGAL/assertions.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {

/*!
 * \ingroup PkgVertexLocationOptimizationRef
 *
 * \brief The class `Approximation_sizing_field` gives `isotropic_remeshing()` the edge lengths with which a given number of
 *        vertices approximates a surface best: short where it is curved.
 *
 * The best edge length is proportional to a power of the larger principal curvature: -1/4 for the smallest mean error, -1/3
 * for the root mean square, -1/2 for the maximum. It does not change faster than `gradation` allows, so that the triangles
 * can be nearly equilateral. The curvatures are those of the mesh at construction, computed from normals that are not
 * averaged across creases. During the remeshing, the edge length at a vertex is that of the closest point of the mesh at
 * construction.
 *
 * The class is available with \cgal 6.0 and later only: `isotropic_remeshing()` of older versions takes no sizing field.
 *
 * The construction takes \cgalBigO{n \log n} time for \f$ n \f$ vertices.
 *
 * \tparam PolygonMesh a model of `MutableFaceGraph` that has an internal property map for `CGAL::vertex_point_t`
 *
 * \cgalModels{PMPSizingField}
 *
 * \sa `CGAL::Polygon_mesh_processing::isotropic_remeshing()`
 * \sa `CGAL::Polygon_mesh_processing::remesh_within_tolerance()`
 */
template <typename PolygonMesh>
class Approximation_sizing_field
{
  using Vertex_point_map = typename boost::property_map<PolygonMesh, vertex_point_t>::const_type;

public:
  using Point_3 = typename boost::property_traits<Vertex_point_map>::value_type;
  using FT = typename Kernel_traits<Point_3>::Kernel::FT;
  using vertex_descriptor = typename boost::graph_traits<PolygonMesh>::vertex_descriptor;
  using halfedge_descriptor = typename boost::graph_traits<PolygonMesh>::halfedge_descriptor;

  /*!
   * \brief constructs the field for about `number_of_vertices` vertices.
   *
   * \param number_of_vertices the number of vertices that the remesh should have
   * \param pmesh the triangle mesh that is to be remeshed. It must outlive the field.
   * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{tolerated_error}
   *     \cgalParamDescription{the error that is minimized}
   *     \cgalParamType{`Tolerated_error`}
   *     \cgalParamDefault{`MEAN_ERROR`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{gradation}
   *     \cgalParamDescription{the largest growth of the edge length from one point to another, relative to their distance}
   *     \cgalParamType{a number type convertible to `double`}
   *     \cgalParamDefault{`0.5`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{edge_is_constrained_map}
   *     \cgalParamDescription{a property map containing the crease-or-not status of each edge of `pmesh`}
   *     \cgalParamType{a class model of `ReadablePropertyMap` with
   *                    `boost::graph_traits<PolygonMesh>::%edge_descriptor` as key type and `bool` as value type}
   *     \cgalParamDefault{the edges that are sharper than `sharpness_angle`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{sharpness_angle}
   *     \cgalParamDescription{the angle between the normals of two faces, in degrees, above which the edge between them is a
   *                           crease}
   *     \cgalParamType{a number type convertible to `double`}
   *     \cgalParamDefault{`40`}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \pre `CGAL::is_triangle_mesh(pmesh)`, all coordinates are finite, and the area is positive
   * \pre `number_of_vertices` and `gradation` are positive
   */
  template <typename NamedParameters = parameters::Default_named_parameters>
  Approximation_sizing_field(std::size_t number_of_vertices,
                             PolygonMesh& pmesh,
                             const NamedParameters& np = parameters::default_values())
    : m_state(std::make_shared<State>(pmesh))
  {
    using namespace internal::vertex_location;
    using parameters::choose_parameter;
    using parameters::get_parameter;

    const double gradation = to_double(choose_parameter(get_parameter(np, internal_np::gradation), 0.5));
    const Tolerated_error kind = choose_parameter(get_parameter(np, internal_np::tolerated_error), MEAN_ERROR);
    CGAL_precondition_msg(number_of_vertices > 0 && gradation > 0, "number_of_vertices and gradation must be positive.");

    Mesh_descriptors<PolygonMesh> descriptors;
    Mesh_arrays mesh;
    read_mesh(pmesh, m_state->vpm, mesh, descriptors); // which checks its preconditions
    const std::vector<Vector> face_normals = compute_face_normals<Sequential_tag>(mesh);
    const std::vector<char> is_crease = find_creases<Sequential_tag>(mesh, descriptors, face_normals, np);
    const Vertex_means curvatures =
      compute_vertex_curvatures<Sequential_tag>(mesh, face_normals, is_crease, kind, double(number_of_vertices));
    m_state->lengths = compute_edge_lengths(mesh, curvatures, kind, static_cast<double>(number_of_vertices), gradation);
    m_state->faces = mesh.faces;
    std::vector<Flat_triangle> triangles;
    for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      triangles.emplace_back(mesh.triangle(f));
    m_state->tree = Patch_tree<Flat_triangle>(std::move(triangles));
  }

  /*!
   * returns approximately how many vertices `isotropic_remeshing()` makes with a uniform edge length. A field with this
   * number of vertices can replace that edge length, for example in `remesh_within_tolerance()`.
   */
  static std::size_t number_of_vertices(double edge_length, const PolygonMesh& pmesh)
  {
    using namespace internal::vertex_location;
    Mesh_descriptors<PolygonMesh> descriptors;
    Mesh_arrays mesh;
    read_mesh(pmesh, get(vertex_point, pmesh), mesh, descriptors);
    double area = 0;
    for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      area += mesh.area(f);
    return static_cast<std::size_t>((std::max)(4., estimate_number_of_vertices(area, edge_length)));
  }

  /// \name Sizing
  /// The functions of `PMPSizingField`.
  /// @{

  FT at(vertex_descriptor v, const PolygonMesh&) const { return FT(m_state->length(v)); }

  std::optional<FT> is_too_long(vertex_descriptor v, vertex_descriptor w, const PolygonMesh&) const
  {
    const double ratio = squared_ratio(v, w) / square(4. / 3);
    return ratio > 1 ? std::optional<FT>(ratio) : std::nullopt;
  }

  std::optional<FT> is_too_short(halfedge_descriptor h, const PolygonMesh& pmesh) const
  {
    const double ratio = squared_ratio(source(h, pmesh), target(h, pmesh)) / square(4. / 5);
    return ratio < 1 ? std::optional<FT>(ratio) : std::nullopt;
  }

  Point_3 split_placement(halfedge_descriptor h, const PolygonMesh& pmesh) const
  {
    return midpoint(get(m_state->vpm, source(h, pmesh)), get(m_state->vpm, target(h, pmesh)));
  }

  void register_split_vertex(vertex_descriptor, const PolygonMesh&) {}

  /// @}

private:
  // the edge length at a vertex when it was last asked for, and where it was then
  struct Known_length
  {
    Point_3 point;
    internal::vertex_location::Patch_foot foot;
    double length = 0;
  };

  // Shared by the copies that the remesher makes.
  struct State
  {
    explicit State(PolygonMesh& pmesh)
      : vpm(get(vertex_point, static_cast<const PolygonMesh&>(pmesh))),
        known(get(dynamic_vertex_property_t<Known_length>(), pmesh))
    {}

    double length(vertex_descriptor v)
    {
      Known_length last = get(known, v);
      const Point_3& p = get(vpm, v);
      if(last.length > 0 && last.point == p)
        return last.length;
      using namespace internal::vertex_location;
      last.point = p;
      last.foot = tree.project(convert<Point>(p), last.foot.patch);
      const auto x = last.foot.coordinates.barycentric();
      last.length = 0;
      for(int k = 0; k < 3; ++k)
        last.length += x[k] * lengths[faces[last.foot.patch][k]];
      put(known, v, last);
      return last.length;
    }

    Vertex_point_map vpm;
    typename boost::property_map<PolygonMesh, dynamic_vertex_property_t<Known_length>>::type known;
    std::vector<double> lengths; // at the vertices of the mesh at construction
    std::vector<std::array<internal::vertex_location::Index, 3>> faces;
    internal::vertex_location::Patch_tree<internal::vertex_location::Flat_triangle> tree;
  };

  // the squared distance of two vertices, relative to the shorter of their edge lengths
  double squared_ratio(vertex_descriptor v, vertex_descriptor w) const
  {
    const double length = (std::min)(m_state->length(v), m_state->length(w));
    return to_double(squared_distance(get(m_state->vpm, v), get(m_state->vpm, w))) / square(length);
  }

  std::shared_ptr<State> m_state;
};

} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_VERSION_NR

#endif // CGAL_POLYGON_MESH_PROCESSING_APPROXIMATION_SIZING_FIELD_H
