# Makes the target CGAL::Vertex_location_optimization of the headers in the source tree. It needs find_package(CGAL) before it.
include_guard(GLOBAL)
include(${CMAKE_CURRENT_LIST_DIR}/CGAL_Vertex_location_optimization_dependencies.cmake)
include(GNUInstallDirs)

add_library(CGAL_Vertex_location_optimization INTERFACE)
add_library(CGAL::Vertex_location_optimization ALIAS CGAL_Vertex_location_optimization)
set_target_properties(CGAL_Vertex_location_optimization PROPERTIES EXPORT_NAME Vertex_location_optimization)
# parameters_interface.h takes the place of CGAL's: where they are installed it has a directory of its own
set(VLO_INSTALL_FIRST_INCLUDEDIR ${CMAKE_INSTALL_INCLUDEDIR}/CGAL_Vertex_location_optimization)
get_filename_component(VLO_SOURCE_DIR ${CMAKE_CURRENT_LIST_DIR} DIRECTORY)
target_include_directories(CGAL_Vertex_location_optimization INTERFACE
  $<BUILD_INTERFACE:${VLO_SOURCE_DIR}/include>
  $<INSTALL_INTERFACE:${VLO_INSTALL_FIRST_INCLUDEDIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_link_libraries(CGAL_Vertex_location_optimization INTERFACE
  CGAL::CGAL $<TARGET_NAME_IF_EXISTS:CGAL::Eigen3_support> $<TARGET_NAME_IF_EXISTS:CGAL::TBB_support>)
target_compile_features(CGAL_Vertex_location_optimization INTERFACE cxx_std_17)
