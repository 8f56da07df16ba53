#!/usr/bin/env bash
# Builds optimize_remesh, runs it on CGAL's armadillo, and makes a picture of the errors before and after:
#
#   bash examples/run.sh [MESH [EDGE_LENGTH]]
#
# EDGE_LENGTH is relative to the longest side of the bounding box. Everything is written to examples/output/.
# AZIMUTH in the environment turns the camera, in degrees.
# With another CGAL than the system's:  CGAL_DIR=/path/to/CGAL bash examples/run.sh
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"
source "$root/examples/pictures.sh"

need_packages "${base_packages[@]}" "${picture_packages[@]}"
need_data

input=$(realpath "${1:-$CGAL_DATA_DIR/meshes/armadillo.off}")
edge_length=${2:-0.012}
cd "$root"
output=examples/output

configure
cmake --build "$build_dir" -j "$jobs" --target optimize_remesh

mkdir -p "$output"
"$build_dir/examples/Vertex_location_optimization/optimize_remesh" "$input" --edge-length "$edge_length" \
  --output "$output/" | tee "$output/log.txt"

compare_errors "$output/" "$output/errors.png" --camera-azimuth-angle="${AZIMUTH:-180}"
echo "picture: $output/errors.png"
