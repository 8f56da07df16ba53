/*!
 * \ingroup PkgVertexLocationOptimizationConcepts
 * \cgalConcept
 *
 * The concept `ReferenceSurface` describes the surface that a remesh approximates. A model finds the point of the surface
 * that is closest to a given point, and returns the position and the normal there.
 *
 * A *foot* represents a point of the surface, for example by a patch and coordinates in the patch; the representation is
 * up to the model. The algorithms of this package keep the feet of the vertices from iteration to iteration and pass them as
 * hints, so that a search need not start from scratch.
 *
 * The functions are called from several threads at the same time when a function of this package is called with
 * `CGAL::Parallel_tag`.
 *
 * Between the first and the last iteration, a sample moves along with its query in the tangent plane; its foot is recomputed
 * only when the query has moved far enough. In the models of this package, the search then walks from the last foot; for
 * other models, `project()` is called with the last foot as the hint. With such other models, the vertices of constrained
 * edges do not move even if `relax_constraints` is `true`, and `LEAST_SQUARES` takes its samples from the remesh alone.
 *
 * A class with a nested type `Foot` is assumed to be a model of this concept, any other class to be a polygon mesh.
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Polygon_mesh_processing::PN_triangle_surface}
 * \cgalHasModels{CGAL::Polygon_mesh_processing::Flat_triangle_surface}
 * \cgalHasModelsEnd
 *
 * \sa `CGAL::Polygon_mesh_processing::optimize_vertex_locations()`
 */
class ReferenceSurface
{
public:
  /// \name Types
  /// @{

  /*!
   * The point type of a \cgal kernel. The functions of this package convert their points, whose type may differ, via
   * `double`.
   */
  typedef unspecified_type Point_3;

  /*!
   * The vector type of a \cgal kernel.
   */
  typedef unspecified_type Vector_3;

  /*!
   * Where a point of the surface is. A model of `DefaultConstructible`, `CopyConstructible` and `CopyAssignable`.
   */
  typedef unspecified_type Foot;

  /// @}

  /// \name Operations
  /// @{

  /*!
   * returns the foot of `query`: the point of the surface with the smallest Euclidean distance to it.
   */
  Foot project(const Point_3& query) const;

  /*!
   * returns the foot of `query` as above. `hint` is a foot returned by a previous call of `project()`, usually for a point
   * nearby. The hint may accelerate the search, but must not change the distance found.
   */
  Foot project(const Point_3& query, const Foot& hint) const;

  /*!
   * returns the point of the surface that `foot` stands for.
   */
  Point_3 point(const Foot& foot) const;

  /*!
   * returns the normal of the surface there: a vector of length 1, or the null vector where the surface has no normal.
   */
  Vector_3 normal(const Foot& foot) const;

  /// @}
};
