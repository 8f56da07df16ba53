/*!
 * \ingroup PkgVertexLocationOptimizationConcepts
 * \cgalConcept
 *
 * The concept `ToleranceVisitor` describes the visitor of
 * `CGAL::Polygon_mesh_processing::remesh_within_tolerance()`, which is notified of each remeshing and can stop the search.
 *
 * The visitor is also passed to the optimization of each remesh, which calls `go_further()` before each phase. When the
 * search is stopped, the current remesh is measured as optimized so far; the result is the best remesh found.
 *
 * A model can derive from `CGAL::Polygon_mesh_processing::Tolerance_default_visitor` and hide the functions that it
 * replaces.
 *
 * \cgalRefines{VertexLocationOptimizationVisitor}
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Polygon_mesh_processing::Tolerance_default_visitor}
 * \cgalHasModelsEnd
 */
class ToleranceVisitor
{
public:
  /*!
   * is called before each remeshing with the edge length that is passed to the remesher.
   */
  void start_remeshing(double edge_length);

  /*!
   * is called when a remesh has been optimized and measured. `report` is the report that the function would return for this
   * remesh.
   */
  void end_remeshing(const CGAL::Polygon_mesh_processing::Tolerance_report& report);
};
