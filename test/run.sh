#!/usr/bin/env bash
# Builds and runs the tests:  bash test/run.sh
# With another CGAL than the system's:  CGAL_DIR=/path/to/CGAL bash test/run.sh
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"

need_packages "${base_packages[@]}"
need_data
configure
cmake --build "$build_dir" -j "$jobs" --target tests
ctest --test-dir "$build_dir" -j "$jobs" --output-on-failure
