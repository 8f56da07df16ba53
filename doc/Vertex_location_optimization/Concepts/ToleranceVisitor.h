/*!
 * \ingroup PkgVertexLocationOptimizationConcepts
 * \cgalConcept
 *
 * The concept `ToleranceVisitor` describes the visitor of
 * `CGAL::Polygon_mesh_processing::remesh_within_tolerance()`, which is notified of each remeshing and can stop the search.
 *
 * It is also the visitor of the optimizations of the remeshes, which call `go_further()` before each phase. When a search is
 * stopped, the current remesh is measured with the result of its iterations so far; the best remesh found is the result.
 *
 * A model can derive from `CGAL::Polygon_mesh_processing::Tolerance_default_visitor` and hide the functions that it needs.
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
   * is called before each remeshing with the edge length that the remesher will be given.
   */
  void start_remeshing(double edge_length);

  /*!
   * is called when a remesh has been optimized and measured. `report` is what the result would be if it were this one.
   */
  void end_remeshing(const CGAL::Polygon_mesh_processing::Tolerance_report& report);
};
