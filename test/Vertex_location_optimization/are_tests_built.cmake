# Fails, and says what to do, if no test is built.
file(GLOB tests ${TEST_DIR}/test_*)
list(FILTER tests EXCLUDE REGEX "\\.cpp$")
if(NOT tests)
  message(FATAL_ERROR "No test is built. First run: cmake --build ${BUILD_DIR} --target tests")
endif()
