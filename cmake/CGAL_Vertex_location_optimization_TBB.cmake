# Makes CGAL::TBB_support if TBB is wanted and found. It needs find_package(CGAL) before it.
option(CGAL_VERTEX_LOCATION_OPTIMIZATION_WITH_TBB "Use TBB, if it is found, for Parallel_tag" ON)
if(CGAL_VERTEX_LOCATION_OPTIMIZATION_WITH_TBB)
  find_package(TBB QUIET)
  include(CGAL_TBB_support)
endif()
