/*!
 * \ingroup PkgVertexLocationOptimizationConcepts
 * \cgalConcept
 *
 * The concept `VertexLocationOptimizationVisitor` describes the visitor of
 * `CGAL::Polygon_mesh_processing::optimize_vertex_locations()`, which is notified of the progress and can stop the run.
 *
 * Its functions are called from the thread that called `optimize_vertex_locations()`, whatever the concurrency tag.
 * The mesh does not change during the run, as the points are written at the end.
 *
 * A model can derive from `CGAL::Polygon_mesh_processing::Vertex_location_optimization_default_visitor` and hide the
 * functions that it replaces.
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
   * `ENFORCE_GUARANTEE`, even if `go_further()` has ended the run. With `LEAST_SQUARES`, there may be further attempts with
   * smaller weights of the regularity: each goes through its own phases and counts its iterations from the first.
   */
  void start_phase(CGAL::Polygon_mesh_processing::Vertex_location_optimization_phase phase);

  /*!
   * is called after each iteration. `report` says what has been done so far: the number of iterations, the displacement
   * in the last one, and the number of vertices whose moves have been shortened.
   */
  void end_iteration(const CGAL::Polygon_mesh_processing::Vertex_location_optimization_report& report);

  /*!
   * is called before each phase of an iteration, before `start_phase()`, and before a further attempt. If it returns
   * `false`, the iterations end: the unfinished one is discarded, and the result is that of the complete ones, with the same
   * guarantees as after a full run. It is not called before `ENFORCE_GUARANTEE`, which cannot be skipped; this phase takes
   * as long as several iterations, or longer if many moves have to be shortened.
   */
  bool go_further();
};
