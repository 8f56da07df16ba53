# Makes CGAL::Eigen3_support if Eigen is found, and CGAL::TBB_support if TBB is wanted and found. It needs
# find_package(CGAL) before it.
find_package(Eigen3 3.1.0 QUIET)
include(CGAL_Eigen3_support)

option(CGAL_VERTEX_LOCATION_OPTIMIZATION_WITH_TBB "Use TBB, if it is found, for Parallel_tag" ON)
if(CGAL_VERTEX_LOCATION_OPTIMIZATION_WITH_TBB)
  find_package(TBB QUIET)
  include(CGAL_TBB_support)
endif()
