// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What optimize_remesh measures and prints about a run.

#ifndef VERTEX_LOCATION_OPTIMIZATION_EXAMPLES_OPTIMIZE_REMESH_REPORT_H
#define VERTEX_LOCATION_OPTIMIZATION_EXAMPLES_OPTIMIZE_REMESH_REPORT_H

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/Vertex_location_optimization_report.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <string>

template <typename Mesh>
double longest_side(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  return (std::max)({ box.x_span(), box.y_span(), box.z_span() });
}

// The input with each face divided into four, on the surface that it represents.
template <typename Mesh, typename Surface>
Mesh refine(const Mesh& mesh, const Surface& reference)
{
  Mesh refined = mesh;
  CGAL::Subdivision_method_3::PTQ(refined, CGAL::Linear_mask_3<Mesh>(&refined, refined.points()));
  for(auto v : refined.vertices())
    refined.point(v) = mesh.has_valid_index(v) ? mesh.point(v) : reference.point(reference.project(refined.point(v)));
  return refined;
}

// the regularity of the faces: smallest angles in degrees
struct Regularity
{
  double mean = 0;
  double min = 180;
};

template <typename Mesh>
Regularity measure_regularity(const Mesh& mesh)
{
  Regularity regularity;
  for(auto f : mesh.faces())
  {
    double smallest = 180;
    for(auto h : halfedges_around_face(mesh.halfedge(f), mesh))
      smallest = (std::min)(smallest, CGAL::approximate_angle(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                                              mesh.point(mesh.target(mesh.next(h)))));
    regularity.mean += smallest / mesh.number_of_faces();
    regularity.min = (std::min)(regularity.min, smallest);
  }
  return regularity;
}

inline void print_reference(const CGAL::Polygon_mesh_processing::Reference_surface_summary& reference, double side)
{
  if(reference.kind == CGAL::Polygon_mesh_processing::Reference_surface_kind::FLAT)
    std::printf("reference: the faces of the input\n");
  else
    std::printf("reference: PN triangles, off the faces of the input by %.3g in the mean, by %.3g at most "
                "(1e-4 of the longest side)\n",
                reference.mean_deviation / side * 1e4, reference.maximum_deviation / side * 1e4);
}

// The number of vertices that moved, and if there are few, why the others did not.
inline void print_moves(const CGAL::Polygon_mesh_processing::Vertex_location_optimization_report& report,
                        std::size_t number_of_vertices)
{
  std::printf("vertices moved: %zu of %zu\n", report.moved_vertices, number_of_vertices);
  if(report.moved_vertices < number_of_vertices / 2)
    std::printf(
      "  moves shortened: %zu for the shape of faces, %zu for the error, %zu for self-intersections; %zu refused\n",
      report.corrected_for_shape, report.corrected_for_error, report.corrected_for_intersection, report.refused_vertices);
}

inline void print_volume(const CGAL::Polygon_mesh_processing::Vertex_location_optimization_report& report, bool is_asked_for)
{
  std::printf("volume: %+.4f%%%s\n", 100 * report.volume_change,
              !is_asked_for                ? ""
              : report.is_volume_preserved ? ", to that of the input"
                                           : ", NOT that of the input");
}

inline void print_heading(const char* what) { std::printf("\n  %-32s %10s %10s\n", what, "before", "after"); }

inline void print_error(const std::string& name, double before, double after, double side)
{
  constexpr double nothing = 1e-9; // relative to the longest side: rounding
  std::printf("  %-32s %10.3f %10.3f", name.c_str(), before / side * 1e4, after / side * 1e4);
  if(before > nothing * side)
    std::printf(" %+9.1f%%\n", 100 * (after - before) / before);
  else
    std::printf(" %10s\n", "-");
}

inline void print_errors(const CGAL::Polygon_mesh_processing::Approximation_error& before,
                         const CGAL::Polygon_mesh_processing::Approximation_error& after,
                         const std::string& direction,
                         double side)
{
  print_error("mean error" + direction, before.mean, after.mean, side);
  print_error("root mean square" + direction, before.rms, after.rms, side);
  print_error("maximum" + direction, before.max, after.max, side);
}

// The errors as measured for the guarantee, and the shape of the faces.
inline void print_table(const CGAL::Polygon_mesh_processing::Vertex_location_optimization_report& report,
                        const Regularity& before,
                        const Regularity& after,
                        bool has_both_directions,
                        double side)
{
  print_heading("");
  print_errors(report.initial_error, report.final_error, "", side);
  if(has_both_directions)
    print_errors(report.initial_error_from_reference, report.final_error_from_reference, " from the input", side);
  std::printf("  %-32s %10.3f %10.3f\n", "mean smallest angle (degrees)", before.mean, after.mean);
  std::printf("  %-32s %10.3f %10.3f\n", "smallest angle (degrees)", before.min, after.min);
  std::printf("  Errors in 1/10000 of the longest side of the bounding box.\n");
}

#endif // VERTEX_LOCATION_OPTIMIZATION_EXAMPLES_OPTIMIZE_REMESH_REPORT_H
