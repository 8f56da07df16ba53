// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_SPARSE_LEAST_SQUARES_H
#define VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_SPARSE_LEAST_SQUARES_H

#include <CGAL/Kernel_traits.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

// What the explicit placement stands against: all vertices at once, as the solution of one sparse linear system.
//
// With samples x_s of the faces, linear in the vertices v, and their closest points q_s on the reference, it minimizes
//
//   sum_s w_s |x_s - q_s|^2  +  regularity_weight * sum_i a_i |(L v)_i - n_i n_i^T (L v')_i|^2
//
// over v. w_s and a_i are areas, L is the uniform Laplacian, v' are the vertices before and n_i normals of the
// reference: the second term evens the triangles along the surface, but does not shrink it. The areas are those of the
// remesh, so that the matrix is the same for all iterations and is factorized once.
template <typename Point, typename ReferenceSurface>
class Sparse_least_squares
{
  using Mesh = CGAL::Surface_mesh<Point>;
  using Vertex = typename Mesh::Vertex_index;
  using Foot = typename ReferenceSurface::Foot;
  using Matrix = Eigen::SparseMatrix<double>;
  using Coordinates = Eigen::Matrix<double, Eigen::Dynamic, 3>;

public:
  // Vertices on the border stay, and those for which `is_fixed(v)`. `mesh` has no removed elements.
  template <typename IsFixed>
  Sparse_least_squares(Mesh& mesh, const ReferenceSurface& reference, const IsFixed& is_fixed, double regularity_weight)
    : m_mesh(mesh), m_reference(reference),
      m_number_of_samples(mesh.number_of_vertices() + mesh.number_of_edges() + mesh.number_of_faces()),
      m_feet(m_number_of_samples)
  {
    number_vertices(is_fixed);
    assemble(regularity_weight);
  }

  // Each iteration takes the closest points to the samples and solves the system. Returns false, with the mesh as it
  // was, if the system is singular.
  bool run(std::size_t number_of_iterations)
  {
    const Matrix of_free = m_matrix.leftCols(m_number_of_free);
    const Matrix of_fixed = m_matrix.rightCols(m_matrix.cols() - m_number_of_free);
    const Matrix weighted = of_free.transpose() * m_weights.asDiagonal();
    const Eigen::SimplicialLDLT<Matrix> solver(weighted * of_free);
    if(solver.info() != Eigen::Success)
      return false;

    Coordinates v = coordinates();
    const Coordinates fixed = v.bottomRows(v.rows() - m_number_of_free);
    for(std::size_t i = 0; i < number_of_iterations; ++i)
      v.topRows(m_number_of_free) = solver.solve(weighted * (wanted_values(v, i == 0) - of_fixed * fixed)).eval();
    for(Vertex u : m_mesh.vertices())
      m_mesh.point(u) = Point(v(m_column[u], 0), v(m_column[u], 1), v(m_column[u], 2));
    return true;
  }

private:
  // the columns of the free vertices come first
  template <typename IsFixed>
  void number_vertices(const IsFixed& is_fixed)
  {
    m_column.resize(m_mesh.number_of_vertices());
    int first = 0, last = static_cast<int>(m_column.size());
    for(Vertex v : m_mesh.vertices())
      m_column[v] = m_mesh.is_border(v) || is_fixed(v) ? --last : first++;
    m_number_of_free = first;
  }

  // A row for each sample, at the vertices, the midpoints and the barycenters, whose weights integrate cubics exactly;
  // then a row of the Laplacian for each free vertex.
  void assemble(double regularity_weight)
  {
    const int edge_row = m_mesh.number_of_vertices(), face_row = edge_row + m_mesh.number_of_edges();
    const int laplacian_row = static_cast<int>(m_number_of_samples);
    std::vector<Eigen::Triplet<double>> entries;
    m_weights = Eigen::VectorXd::Zero(laplacian_row + m_number_of_free);

    for(Vertex v : m_mesh.vertices())
    {
      const int i = m_column[v];
      entries.emplace_back(i, i, 1);
      if(i >= m_number_of_free)
        continue;
      entries.emplace_back(laplacian_row + i, i, -1);
      for(Vertex neighbor : vertices_around_target(v, m_mesh))
        entries.emplace_back(laplacian_row + i, m_column[neighbor], 1. / m_mesh.degree(v));
    }
    for(auto e : m_mesh.edges())
      for(int k : { 0, 1 })
        entries.emplace_back(edge_row + int(e), m_column[m_mesh.vertex(e, k)], 0.5);
    for(auto f : m_mesh.faces())
    {
      const double area = CGAL::to_double(CGAL::Polygon_mesh_processing::face_area(f, m_mesh));
      m_weights[face_row + int(f)] = area * 9 / 20;
      for(auto h : halfedges_around_face(m_mesh.halfedge(f), m_mesh))
      {
        const int i = m_column[m_mesh.target(h)];
        entries.emplace_back(face_row + int(f), i, 1. / 3);
        m_weights[i] += area / 20;
        m_weights[edge_row + int(m_mesh.edge(h))] += area * 2 / 15;
        if(i < m_number_of_free)
          m_weights[laplacian_row + i] += regularity_weight * area / 3;
      }
    }
    m_matrix.resize(m_weights.size(), m_mesh.number_of_vertices());
    m_matrix.setFromTriplets(entries.begin(), entries.end());
  }

  // what the rows should be: the closest points, and the part of the Laplacian along the normal
  Coordinates wanted_values(const Coordinates& v, bool is_first)
  {
    Coordinates values = m_matrix * v;
    for(std::size_t s = 0; s < m_number_of_samples; ++s)
    {
      const Point x(values(s, 0), values(s, 1), values(s, 2));
      m_feet[s] = is_first ? m_reference.project(x) : m_reference.project(x, m_feet[s]);
      const auto q = m_reference.point(m_feet[s]);
      values.row(s) << q.x(), q.y(), q.z();
    }
    for(int i = 0; i < m_number_of_free; ++i)
    {
      const auto normal = m_reference.normal(m_feet[i]);
      const Eigen::RowVector3d n(normal.x(), normal.y(), normal.z());
      auto laplacian = values.row(m_number_of_samples + i);
      laplacian = (laplacian.dot(n) * n).eval();
    }
    return values;
  }

  Coordinates coordinates() const
  {
    Coordinates v(m_mesh.number_of_vertices(), 3);
    for(Vertex u : m_mesh.vertices())
      v.row(m_column[u]) << m_mesh.point(u).x(), m_mesh.point(u).y(), m_mesh.point(u).z();
    return v;
  }

  Mesh& m_mesh;
  const ReferenceSurface& m_reference;
  const std::size_t m_number_of_samples;
  std::vector<Foot> m_feet;  // of the samples
  std::vector<int> m_column; // of the vertices
  int m_number_of_free = 0;
  Matrix m_matrix;
  Eigen::VectorXd m_weights; // of its rows
};

// Fits `mesh` to `reference`, with as many iterations as `optimize_vertex_locations()`. Returns false, with `mesh` as
// it was, if that cannot be done.
template <typename Point, typename ReferenceSurface, typename IsFixed>
bool fit_sparse_least_squares(CGAL::Surface_mesh<Point>& mesh,
                              const ReferenceSurface& reference,
                              const IsFixed& is_fixed,
                              double regularity_weight = 0.01,
                              std::size_t number_of_iterations = 30)
{
  return Sparse_least_squares<Point, ReferenceSurface>(mesh, reference, is_fixed, regularity_weight)
    .run(number_of_iterations);
}

#endif // VERTEX_LOCATION_OPTIMIZATION_BENCHMARK_SPARSE_LEAST_SQUARES_H
