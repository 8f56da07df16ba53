# The targets
#   format        formats the code as .clang-format says
#   format-check  fails where it is not formatted so
#   tidy          runs clang-tidy, with .clang-tidy, over the headers and some tests, which instantiate them
# where clang-format and clang-tidy are installed.

file(GLOB_RECURSE style_files CONFIGURE_DEPENDS
  ${PROJECT_SOURCE_DIR}/include/*.h
  ${PROJECT_SOURCE_DIR}/test/*.h ${PROJECT_SOURCE_DIR}/test/*.cpp
  ${PROJECT_SOURCE_DIR}/examples/*.h ${PROJECT_SOURCE_DIR}/examples/*.cpp
  ${PROJECT_SOURCE_DIR}/benchmark/*.h ${PROJECT_SOURCE_DIR}/benchmark/*.cpp)

find_program(CLANG_FORMAT NAMES clang-format clang-format-14)
if(CLANG_FORMAT)
  add_custom_target(format COMMAND ${CLANG_FORMAT} -i ${style_files} VERBATIM)
  add_custom_target(format-check COMMAND ${CLANG_FORMAT} --dry-run --Werror ${style_files} VERBATIM)
else()
  message(STATUS "clang-format is not installed: there are no targets format and format-check.")
endif()

find_program(CLANG_TIDY NAMES clang-tidy clang-tidy-14)
if(CLANG_TIDY AND CGAL_VERTEX_LOCATION_OPTIMIZATION_TESTS)
  add_custom_target(tidy)
  foreach(topic IN ITEMS named_parameters optimize_vertex_normals) # a target each, so that they can run at the same time
    # CMake leaves out the standard where it is the compiler's default, which clang's may not be
    add_custom_target(tidy_${topic} VERBATIM
      COMMAND ${CLANG_TIDY} -p ${PROJECT_BINARY_DIR} --quiet --extra-arg=-std=c++17 --extra-arg=-Wno-unknown-warning-option
              ${PROJECT_SOURCE_DIR}/test/Vertex_location_optimization/test_${topic}.cpp)
    add_dependencies(tidy tidy_${topic})
  endforeach()
else()
  message(STATUS "clang-tidy is not installed, or there are no tests: there is no target tidy.")
endif()
