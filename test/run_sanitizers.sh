#!/usr/bin/env bash
# Builds and runs the tests under sanitizers:  bash test/run_sanitizers.sh [TEST...]
#
# All of them, or those that are named, with AddressSanitizer and UndefinedBehaviorSanitizer; those that run in parallel
# with ThreadSanitizer, and with the headers of sanitizers/tbb instead of TBB's. CGAL's checks are on. It takes several
# times as long as test/run.sh.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../cmake/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"

parallel_tests=(parallel)
no_warnings='-Wno-maybe-uninitialized -Wno-unknown-warning-option' # Clang does not know the first

# run_with FLAGS TEST... configures in a directory of the flags' own; without a test it runs all that are no project
run_with()
{
  local flags=$1 names targets=(tests)
  shift
  if [ $# -gt 0 ]; then
    targets=("${@/#/test_}")
  fi
  build_dir=$root/build-${flags//[^a-z]/-}
  # of code with the sanitizers' own checks GCC says falsely that variables may be uninitialized
  configure -DCMAKE_BUILD_TYPE=None \
    -DCMAKE_CXX_FLAGS="-O1 -g1 -fno-omit-frame-pointer -fsanitize=$flags $no_warnings ${extra_flags:-}" \
    -DCGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE=ON
  cmake --build "$build_dir" -j "$jobs" --target "${targets[@]}"
  names=$(IFS='|'; echo "$*")
  ctest --test-dir "$build_dir" -j "$jobs" --timeout 3600 --output-on-failure --no-tests=error \
    -R "^(${names:-.*})\$" -E '^(install|consumer_.*|.*_does_not_compile|compilation_of_.*)$'
}

need_packages "${base_packages[@]}" libopenmesh-dev
need_data
export UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1
export TSAN_OPTIONS=halt_on_error=1:suppressions=$root/test/sanitizers/thread_sanitizer.supp

run_with address,undefined "$@"
extra_flags=-I$root/test/sanitizers run_with thread "${parallel_tests[@]}"
