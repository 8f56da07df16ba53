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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PATCH_SURFACE_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PATCH_SURFACE_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/make_reference_patches.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Patch_descriptors.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/check_arguments.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/Default.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Polygon_mesh_processing/locate.h>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// The kernel of the points of a mesh that has an internal vertex point map.
template <typename TriangleMesh>
struct Kernel_of
{
  using Vertex_point_map = typename boost::property_map<TriangleMesh, vertex_point_t>::const_type;
  using type = typename Kernel_traits<typename boost::property_traits<Vertex_point_map>::value_type>::Kernel;
};

template <typename TriangleMesh, typename GeomTraits>
using Geom_traits_or_kernel_of = typename Default::Lazy_get<GeomTraits, Kernel_of<TriangleMesh>>::type;

// What the two models of `ReferenceSurface` have in common: their patches, for the points of any kernel.
template <typename Patch, typename TriangleMesh, typename GeomTraits>
class Patch_surface
{
public:
  using Geom_traits = GeomTraits;
  using Point_3 = typename Geom_traits::Point_3;
  using Vector_3 = typename Geom_traits::Vector_3;
  using Foot = Patch_foot;

  bool is_empty() const { return m_patches.is_empty(); }

  Foot project(const Point_3& query) const { return project(query, Foot()); }

  Foot project(const Point_3& query, const Foot& hint) const
  {
    CGAL_precondition_msg(!is_empty(), "The surface has no face to project to.");
    return m_patches.project(convert<Point>(query), hint);
  }

  Point_3 point(const Foot& foot) const { return convert<Point_3>(m_patches.point(foot)); }
  Vector_3 normal(const Foot& foot) const { return convert<Vector_3>(m_patches.normal(foot)); }

  // where a foot is in the mesh
  Face_location<TriangleMesh, double> location(const Foot& foot) const
  {
    return m_descriptors.location(foot.patch, foot.coordinates.barycentric());
  }

  // for the phases, which work in double precision; not part of the concept
  const Reference_patches<Patch>& patches() const { return m_patches; }
  const Patch_descriptors<TriangleMesh>& descriptors() const { return m_descriptors; }

protected:
  template <typename NamedParameters, typename ConcurrencyTag>
  Patch_surface(const TriangleMesh& tmesh, const NamedParameters& np, const ConcurrencyTag&)
    : m_patches(make_reference_patches<Patch, ConcurrencyTag>(tmesh, np, &m_descriptors))
  {
    static_assert(Mesh_check<TriangleMesh, NamedParameters>::value && Second_sequence_check<NamedParameters>::value,
                  "The errors above say why.");
  }

private:
  Patch_descriptors<TriangleMesh> m_descriptors;
  Reference_patches<Patch> m_patches;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_PATCH_SURFACE_H
