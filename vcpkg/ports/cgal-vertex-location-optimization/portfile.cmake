# Of the source tree that the port is in, for vcpkg's option --overlay-ports=vcpkg/ports. In a registry
# vcpkg_from_github(OUT_SOURCE_PATH SOURCE_PATH ...) takes the place of this line.
get_filename_component(SOURCE_PATH "${CURRENT_PORT_DIR}/../../.." ABSOLUTE)

set(VCPKG_BUILD_TYPE release) # it is header-only
vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS -DCGAL_VERTEX_LOCATION_OPTIMIZATION_TESTS=OFF -DCGAL_VERTEX_LOCATION_OPTIMIZATION_EXAMPLES=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME CGAL_Vertex_location_optimization
                         CONFIG_PATH share/cmake/CGAL_Vertex_location_optimization)
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/lib")
file(INSTALL "${CURRENT_PORT_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
