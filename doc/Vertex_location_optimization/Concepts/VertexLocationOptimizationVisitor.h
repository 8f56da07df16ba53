/*!
 * \ingroup PkgVertexLocationOptimizationConcepts
 * \cgalConcept
 *
 * The concept `VertexLocationOptimizationVisitor` describes the visitor of
 * `CGAL::Polygon_mesh_processing::optimize_vertex_locations()`, which is told about the progress and can end the run.
 *
 * Its functions are called from the thread that called `optimize_vertex_locations()`, whatever the concurrency tag.
 * During the run the mesh is as it was before: the points are written at its end.
 *
 * A model can derive from `CGAL::Polygon_mesh_processing::Vertex_location_optimization_default_visitor` and hide the
 * functions that it needs.
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Polygon_mesh_processing::Vertex_location_optimization_default_visitor}
 * \cgalHasModelsEnd
 */
class VertexLocationOptimizationVisitor
{
public:
  /*!
   * is called before each phase; `phase` is the one that starts. If there was an iteration, the last phase of the run is
   * `ENFORCE_GUARANTEE`, also if `go_further()` has ended it.
   */
  void start_phase(CGAL::Polygon_mesh_processing::Vertex_location_optimization_phase phase);

  /*!
   * is called after each iteration. `report` says what has been done so far: the number of iterations, the displacement
   * in the last one, and the number of vertices whose moves have been shortened.
   */
  void end_iteration(const CGAL::Polygon_mesh_processing::Vertex_location_optimization_report& report);

  /*!
   * is called before each phase of an iteration, before `start_phase()`. If it returns `false`, the iterations end: the
   * unfinished one is given up, and what the complete ones have reached is the result, with the same guarantees as that
   * of a full run. `ENFORCE_GUARANTEE` sees to these and is not asked for: it takes as long as several iterations, and
   * longer where many moves have to be shortened.
   */
  bool go_further();
};
