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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_REFERENCE_ACCESS_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_REFERENCE_ACCESS_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Feature_curves.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/geometry.h>
#include <CGAL/Polygon_mesh_processing/Vertex_location_optimization_report.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// What the phases need of a reference surface: a refinement of the concept `ReferenceSurface`, in double precision.
//
//   Foot, Hint                    a point of the surface, and what is kept of it to be the hint of a later search; a hint
//                                 converts to a foot
//   is_empty()                    whether there is nothing to project to
//   project(q), project(q, hint)  the closest point
//   project_locally(q, hint)      the closest point as far as walking from `hint` over neighbors leads closer. Much faster,
//                                 and the same point unless another sheet of the surface is closer.
//   project_among_neighbors(q, hint)
//                                 the same, but it looks beyond concave edges and around corners, too: rather
//                                 slower, and rarely wrong
//   walks                         whether these two walk, and may so miss a point that is closer
//   prefetch(hint)                asks for what `project_locally(q, hint)` reads first, to be called some time before it
//   point(foot), normal(foot)     a unit vector; the null vector where there is no normal
//   feet_at(foot)                 all feet that are the same point: on an edge they have the normals of several faces
//   area_at(foot)                 the area of the patch that the foot is in, to tell how fine the surface is; 0: it has none
//   area()                        0: the surface cannot be sampled
//   for_each_area_sample(n, m, hint, area, f)
//                                 calls f(foot, a) for some n points spread over the surface, each of which stands for the
//                                 area a; near the feet hint(0), ..., hint(m - 1) a is proportional to area(k)
//   number_of_patches()           0 if it has none
//   is_closed(), volume<Tag>()    whether it encloses a volume, and that
//   summary<ConcurrencyTag>()     its kind, and how far it is from the faces of its mesh
//   feature_curves()              its creases and borders, see `Feature_curves`
//
// `Reference_patches` is a model. For any other model of `ReferenceSurface`, this class provides what the concept allows: it
// always searches the whole surface, has one normal at each point, is not sampled, and has no creases.
template <typename Surface>
class Reference_surface_adaptor
{
  using Surface_point = typename Surface::Point_3;

public:
  using Foot = typename Surface::Foot;
  using Hint = Foot;

  static constexpr bool walks = false;

  explicit Reference_surface_adaptor(const Surface& surface) : m_surface(surface) {}

  bool is_empty() const { return false; }
  Foot project(const Point& query) const { return m_surface.project(convert<Surface_point>(query)); }
  Foot project(const Point& query, const Foot& hint) const { return m_surface.project(convert<Surface_point>(query), hint); }
  Foot project_locally(const Point& query, const Foot& hint) const { return project(query, hint); }
  Foot project_among_neighbors(const Point& query, const Foot& hint) const { return project(query, hint); }
  void prefetch(const Foot&) const {}
  Point point(const Foot& foot) const { return convert<Point>(m_surface.point(foot)); }
  Vector normal(const Foot& foot) const { return convert<Vector>(m_surface.normal(foot)); }
  std::array<Foot, 1> feet_at(const Foot& foot) const { return { { foot } }; }
  double area_at(const Foot&) const { return 0; }
  double area() const { return 0; }
  template <typename HintAt, typename AreaAt, typename F>
  void for_each_area_sample(std::size_t, std::size_t, const HintAt&, const AreaAt&, const F&) const
  {}
  std::size_t number_of_patches() const { return 0; }
  bool is_closed() const { return false; }
  template <typename ConcurrencyTag>
  double volume() const
  {
    return 0;
  }
  template <typename ConcurrencyTag>
  Reference_surface_summary summary() const
  {
    return {};
  }
  const Feature_curves& feature_curves() const { return m_no_curves; }

private:
  const Surface& m_surface;
  const Feature_curves m_no_curves;
};

// Whether a surface is one of this package, with `patches()`.
template <typename Surface, typename = void>
struct Is_patch_surface : std::false_type
{};

template <typename Surface>
struct Is_patch_surface<Surface, std::void_t<decltype(std::declval<const Surface&>().patches())>> : std::true_type
{};

// `surface` as the phases see it
template <typename Surface>
decltype(auto) access_reference(const Surface& surface)
{
  if constexpr(Is_patch_surface<Surface>::value)
    return surface.patches();
  else
    return Reference_surface_adaptor<Surface>(surface);
}

template <typename Reference>
double distance_to_foot(const Point& p, const Reference& reference, const typename Reference::Foot& foot)
{
  return norm(p - reference.point(foot));
}

// The same, negative on the inner side of the reference. Where the direction to the foot is nearly along the surface, as
// beyond a boundary, only rounding would say on which side it is, and it is positive.
template <typename Reference>
double signed_distance_to_foot(const Point& p, const Reference& reference, const typename Reference::Foot& foot)
{
  constexpr double least_cosine = 0.3;
  const Vector offset = p - reference.point(foot);
  const double distance = norm(offset);
  return offset * reference.normal(foot) < -least_cosine * distance ? -distance : distance;
}

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_REFERENCE_ACCESS_H
