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

#ifndef CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_REFERENCE_PATCHES_H
#define CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_REFERENCE_PATCHES_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Connected_patches.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Feature_curves.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/Patch_deviation.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/patch_volume.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Reference/sample_patches.h>
#include <CGAL/Polygon_mesh_processing/internal/Vertex_location_optimization/Support/for_each_index.h>
#include <CGAL/Polygon_mesh_processing/Vertex_location_optimization_report.h>

#include <cstddef>
#include <utility>

namespace CGAL::Polygon_mesh_processing::internal::vertex_location {

// A reference surface: a patch on each face of a mesh, and the curves of its creases and borders. A model of the concept
// documented in `Reference_access.h`, which also provides attributes with the connectivity of the patches.
template <typename Patch>
class Reference_patches : public Connected_patches<Patch>
{
  using Base = Connected_patches<Patch>;

public:
  using Foot = typename Base::Foot;
  using Base::number_of_patches;
  using Base::patch;

  Reference_patches() = default;

  Reference_patches(Base patches, Feature_curves curves, const Reference_surface_kind kind)
    : Base(std::move(patches)), m_curves(std::move(curves)), m_kind(kind)
  {}

  double area_at(const Foot& foot) const { return patch(foot.patch).area(); }

  double area() const
  {
    double sum = 0;
    for(Index i = 0; i < number_of_patches(); ++i)
      sum += patch(i).area();
    return sum;
  }

  template <typename ConcurrencyTag>
  double volume() const
  {
    const Point apex = patch(0).point({ 0, 0 });
    return sum_over_indices<ConcurrencyTag, double>(
      number_of_patches(), [&](std::size_t i) { return volume_of_cone(patch(static_cast<Index>(i)), apex); });
  }

  template <typename ConcurrencyTag>
  Reference_surface_summary summary() const
  {
    if(m_kind == Reference_surface_kind::FLAT)
      return { m_kind, 0, 0 };
    const auto deviation_of = [&](std::size_t i) { return deviation_of_patch(patch(static_cast<Index>(i))); };
    const auto deviation = sum_over_indices<ConcurrencyTag, Patch_deviation>(number_of_patches(), deviation_of);
    return { m_kind, deviation.area > 0 ? deviation.integral / deviation.area : 0, deviation.maximum };
  }

  template <typename HintAt, typename AreaAt, typename F>
  void
  for_each_area_sample(const std::size_t n, const std::size_t m, const HintAt& hint, const AreaAt& area, const F& f) const
  {
    sample_patches(this->patches(), n, m, hint, area, f);
  }

  const Feature_curves& feature_curves() const { return m_curves; }

private:
  Feature_curves m_curves;
  Reference_surface_kind m_kind = Reference_surface_kind::OTHER;
};

} // namespace CGAL::Polygon_mesh_processing::internal::vertex_location

#endif // CGAL_PMP_INTERNAL_VERTEX_LOCATION_OPTIMIZATION_REFERENCE_PATCHES_H
