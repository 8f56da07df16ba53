// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Where attributes come from: the location of a foot, the sides of seams, and the regions of labels.

#include "add_attributes.h"
#include "check.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polygon_mesh_processing/optimize_vertex_attributes.h>
#include <CGAL/Polygon_mesh_processing/transfer_face_attributes.h>

#include <CGAL/Polyhedron_3.h>

#include <set>
#include <string>

void test_location()
{
  start_topic("the location of a foot");
  const Mesh mesh = make_mesh(transformed(icosphere(2), rotated));
  const Flat_surface flat(mesh);
  const Surface smooth(mesh);
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
#if CGAL_VERSION_MAJOR >= 6
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>>;
#else
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
#endif
  Tree tree;
  PMP::build_AABB_tree(mesh, tree);

  CGAL::Random random(1);
  std::set<int> first_vertices;
  for(int i = 0; i < 500; ++i)
  {
    const auto coordinate = [&] { return random.get_double(-1.2, 1.2); };
    const Point p(coordinate(), coordinate(), coordinate());
    const auto foot = flat.project(p);
    const PMP::Face_location<Mesh, double> location = flat.location(foot);
    const auto expected = PMP::locate_with_AABB_tree(p, tree, mesh);
    CHECK(PMP::is_in_face(location, mesh));
    CHECK_NEAR(location.second[0] + location.second[1] + location.second[2], 1., 1e-14);
    CHECK_AT_MOST((PMP::construct_point(location, mesh) - flat.point(foot)).squared_length(), 1e-26);
    CHECK_AT_MOST((PMP::construct_point(location, mesh) - PMP::construct_point(expected, mesh)).squared_length(), 1e-26);
    if(*std::min_element(expected.second.begin(), expected.second.end()) > 1e-9)
    {
      CHECK_EQUAL(location.first, expected.first);
      for(int k = 0; k < 3; ++k)
        CHECK_NEAR(location.second[k], expected.second[k], 1e-12);
      first_vertices.insert(
        static_cast<int>(std::max_element(location.second.begin(), location.second.end()) - location.second.begin()));
    }
    // the curved patches are above the faces, by little
    CHECK_AT_MOST((PMP::construct_point(smooth.location(smooth.project(p)), mesh) - flat.point(foot)).squared_length(),
                  0.04);
  }
  CHECK_EQUAL(first_vertices.size(), 3u);
}

void test_location_on_polyhedron()
{
  start_topic("the location of a foot at a vertex");
  // at the vertices both surfaces are where the mesh is
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  const Polyhedron polyhedron = make_mesh<Polyhedron>(icosphere(1));
  const PMP::PN_triangle_surface<Polyhedron> of_polyhedron(polyhedron);
  for(auto v : vertices(polyhedron))
  {
    const auto location = of_polyhedron.location(of_polyhedron.project(v->point()));
    CHECK_AT_MOST((PMP::construct_point(location, polyhedron) - v->point()).squared_length(), 1e-20);
  }
}

// a torus of nearly equilateral triangles, turned in itself
Soup torus(std::size_t columns, std::size_t rows, double turn, double shift = 0.5)
{
  Soup soup = triangle_grid(columns, rows, true, shift);
  soup.points.resize(columns * rows); // the last row is the first
  for(auto& triangle : soup.triangles)
    for(std::size_t& i : triangle)
      i %= columns * rows;
  return transformed(soup, [&](const Point& p) {
    const double a = 2 * CGAL_PI * (p.x() + turn) / columns, b = 2 * CGAL_PI * (p.y() + turn) / rows, r = 3 + std::cos(b);
    return Point(r * std::cos(a), r * std::sin(a), std::sin(b));
  });
}

// the angles of a point of the torus around both its axes, in turns
Point_2 angles(const Point& p)
{
  const auto in_turns = [](double y, double x) { return std::fmod(std::atan2(y, x) / (2 * CGAL_PI) + 1, 1.); };
  return { in_turns(p.y(), p.x()), in_turns(p.z(), std::hypot(p.x(), p.y()) - 3) };
}

double from_nearest_integer(double x) { return std::abs(x - std::round(x)); }

// The texture coordinates of a torus that is cut open where they jump from 1 to 0.
Corner_map<Point_2> add_texture(Mesh& torus)
{
  const auto texture = add_corner_map<Point_2>(torus);
  for(Face f : torus.faces())
  {
    const Point_2 center =
      angles(CGAL::centroid(torus.point(torus.source(torus.halfedge(f))), torus.point(torus.target(torus.halfedge(f))),
                            torus.point(torus.target(torus.next(torus.halfedge(f))))));
    for(Halfedge h : CGAL::halfedges_around_face(torus.halfedge(f), torus))
    {
      const Point_2 a = angles(torus.point(torus.target(h)));
      texture[h] = Point_2(a.x() + std::round(center.x() - a.x()), a.y() + std::round(center.y() - a.y()));
    }
  }
  return texture;
}

// The texture coordinates that the corners of a mesh get: right but for whole turns, and on one side of the seams in each
// face.
template <typename NamedParameters>
Corner_map<Point_2> check_corners(
  Mesh& mesh, const Surface& surface, const Corner_map<Point_2>& texture, const NamedParameters& np, double tolerance)
{
  const auto corners = add_corner_map<Point_2>(mesh);
  PMP::optimize_vertex_attributes(mesh, surface, texture, corners, np);
  std::size_t seam_corners = 0;
  for(Face f : mesh.faces())
    for(Halfedge h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
    {
      // right but for whole turns, and on one side in each face
      const Point_2 t = corners[h], next = corners[mesh.next(h)], a = angles(mesh.point(mesh.target(h)));
      CHECK_AT_MOST(from_nearest_integer(t.x() - a.x()), tolerance);
      CHECK_AT_MOST(from_nearest_integer(t.y() - a.y()), 3 * tolerance);
      CHECK_AT_MOST((std::max)(std::abs(t.x() - next.x()), std::abs(t.y() - next.y())), 0.2);
      CHECK((std::min)(t.x(), t.y()) > -1e-9 && (std::max)(t.x(), t.y()) < 1 + 1e-9);
      seam_corners += std::abs(corners[mesh.opposite(mesh.next(h))].x() - t.x()) > 0.5;
    }
  CHECK_LESS(5u, seam_corners);
  CHECK_LESS(seam_corners, mesh.number_of_faces() / 4);
  return corners;
}

void test_seams()
{
  Mesh reference = make_mesh(torus(90, 30, 0, 0));
  const auto texture = add_texture(reference);
  for(Halfedge h : reference.halfedges()) // the seams are at edges
    CHECK(texture[h].x() > -1e-9 && texture[h].x() < 1 + 1e-9 && texture[h].y() > -1e-9 && texture[h].y() < 1 + 1e-9);
  const Surface surface(reference);

  start_topic("seams that the mesh has, too");
  Mesh aligned = make_mesh(torus(60, 20, 0, 0));
  auto is_seam = aligned.add_property_map<Mesh::Edge_index, bool>("e:is_seam", false).first;
  for(Mesh::Edge_index e : aligned.edges())
  {
    const Point_2 a = angles(aligned.point(aligned.vertex(e, 0))), b = angles(aligned.point(aligned.vertex(e, 1)));
    is_seam[e] = (from_nearest_integer(a.x()) < 1e-9 && from_nearest_integer(b.x()) < 1e-9) ||
                 (from_nearest_integer(a.y()) < 1e-9 && from_nearest_integer(b.y()) < 1e-9);
  }
  const auto marked = check_corners(aligned, surface, texture, parameters::edge_is_constrained_map(is_seam), 0.002);
  const auto found = check_corners(aligned, surface, texture, parameters::default_values(), 0.002);
  for(Halfedge h : aligned.halfedges())
    CHECK(marked[h] == found[h]);

  start_topic("seams that cross the faces of the mesh");
  Mesh turned = make_mesh(torus(61, 21 + 1, 0.37));
  check_corners(turned, surface, texture, parameters::default_values(), 0.02);

  start_topic("one value at a vertex on a seam");
  const auto vertex_values = add_vertex_map<Point_2>(turned);
  PMP::optimize_vertex_attributes(turned, surface, texture, vertex_values);
  for(Vertex v : turned.vertices())
  {
    CHECK_AT_MOST(from_nearest_integer(vertex_values[v].x() - angles(turned.point(v)).x()), 0.02);
    CHECK_AT_MOST(from_nearest_integer(vertex_values[v].y() - angles(turned.point(v)).y()), 0.06);
  }
}

// the area of the part of a polygon left of x = c
double area_left_of(const std::array<Point, 3>& t, double c)
{
  std::vector<Point> left;
  for(int k = 0; k < 3; ++k)
  {
    const Point &p = t[k], &q = t[(k + 1) % 3];
    if(p.x() <= c)
      left.push_back(p);
    if((p.x() <= c) != (q.x() <= c))
      left.push_back(p + (c - p.x()) / (q.x() - p.x()) * (q - p));
  }
  double area = 0;
  for(std::size_t i = 2; i < left.size(); ++i)
    area += CGAL::cross_product(left[i - 1] - left[0], left[i] - left[0]).z() / 2;
  return area;
}

void test_labels()
{
  start_topic("labels by majority");
  Mesh mesh = make_mesh(planar_patch(9)),
       reference = make_mesh(
         transformed(triangle_grid(45, 45, false, 0), [](const Point&p) { return Point(p.x() / 5, p.y() / 5, 0); }));
  // a half, and a stripe that takes most of no face of the mesh, along edges of the reference
  const double half = 6.4, begin = 4.4, end = 4.6;
  const auto corners = [](const Mesh& m, Face f) {
    const Halfedge h = m.halfedge(f);
    return std::array<Point, 3>{ m.point(m.source(h)), m.point(m.target(h)), m.point(m.target(m.next(h))) };
  };
  const auto words = add_face_map<std::string>(reference);
  const auto bits = add_face_map<bool>(reference);
  for(Face f : reference.faces())
  {
    const auto t = corners(reference, f);
    const double x = CGAL::centroid(t[0], t[1], t[2]).x();
    bits[f] = x > begin && x < end;
    words[f] = x < half ? "left" : "right";
  }
  const auto word_of_face = add_face_map<std::string>(mesh);
  const auto bit_of_face = add_face_map<bool>(mesh);
  PMP::transfer_face_attributes(mesh, reference, words, word_of_face);
  PMP::transfer_face_attributes<CGAL::Parallel_if_available_tag>(mesh, Flat_surface(reference), bits, bit_of_face);
  int number_divided = 0, number_of_barycenters = 0;
  for(Face f : mesh.faces())
  {
    const auto t = corners(mesh, f);
    const double area = std::sqrt(CGAL::squared_area(t[0], t[1], t[2])), left = area_left_of(t, half) / area;
    number_divided += left > 0 && left < 1;
    if(std::abs(left - 0.5) > 0.05)
      CHECK_EQUAL(word_of_face[f], left > 0.5 ? "left" : "right");
    const double x = CGAL::centroid(t[0], t[1], t[2]).x(),
                 in_stripe = (area_left_of(t, end) - area_left_of(t, begin)) / area;
    number_of_barycenters += x > begin && x < end;
    if(std::abs(in_stripe - 0.5) > 0.05)
      CHECK_EQUAL(bit_of_face[f], in_stripe > 0.5);
  }
  CHECK_LESS(5, number_divided);
  CHECK_LESS(2, number_of_barycenters);
}

void test_sides_of_cube()
{
  start_topic("the sides of a cube");
  Mesh box = make_mesh(cube(2)), fine_box = make_mesh(cube(4));
  const auto side = add_face_map<int>(fine_box), found = add_face_map<int>(box);
  const auto side_of = [](const Mesh& m, Face f) {
    const Vector n = PMP::compute_face_normal(f, m);
    return int(std::lround(n.x() + 2 * n.y() + 4 * n.z()));
  };
  for(Face f : fine_box.faces())
    side[f] = side_of(fine_box, f);
  PMP::transfer_face_attributes(box, fine_box, side, found);
  for(Face f : box.faces())
    CHECK_EQUAL(found[f], side_of(box, f));
}

int main()
{
  test_location();
  test_location_on_polyhedron();
  test_seams();
  test_labels();
  test_sides_of_cube();
  return test_result();
}
