#!/usr/bin/env bash
# Builds and runs the tests:
#
#   bash test/run.sh [--all] [--cgal-of SUITE] [TEST...]
#
# Without TEST, all tests are run; otherwise those named, and the test that each public header compiles. With --all, the
# optional dependency OpenMesh is installed as well. With --cgal-of, the CGAL of another Debian release, such as trixie, is
# used; it is unpacked, not installed. Environment variables:
#   CGAL_DIR        a CGAL other than the system's
#   CGAL_DATA_DIR   CGAL's demo data; by default, it is downloaded to ~/.cache
#   JOBS            the number of compilers that run at once
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../cmake/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"

suite=
while [[ ${1:-} = -* ]]; do
  case $1 in
  --all) base_packages+=(libopenmesh-dev) ;;
  --cgal-of)
    suite=${2:?which Debian?}
    shift
    ;;
  -h | --help)
    print_help "${BASH_SOURCE[0]}"
    exit
    ;;
  *)
    echo "error: $1 is unknown; see --help" >&2
    exit 1
    ;;
  esac
  shift
done

need_packages "${base_packages[@]}"
need_data
if [ -n "$suite" ] && ! need_CGAL_of "$suite"; then
  echo "No tests with the CGAL of Debian's $suite: it cannot be had here."
  exit
fi

targets=(tests)
[ $# = 0 ] || targets=(headers_alone "${@/#/test_}")
# shellcheck disable=SC2119
configure
cmake --build "$build_dir" -j "$jobs" --target "${targets[@]}"
names=$(IFS='|' && echo "$*")
ctest --test-dir "$build_dir" -j "$jobs" --output-on-failure --no-tests=error -R "^(${names:-.*})\$" \
  -E '^(compilation_of_.*|check_build_system)$' # which is done
