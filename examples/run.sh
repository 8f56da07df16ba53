#!/usr/bin/env bash
# Builds optimize_remesh, runs it on CGAL's armadillo, and makes a picture of the errors before and after:
#
#   bash examples/run.sh [MESH [EDGE_LENGTH]]
#
# or does so with optimize_geometry_image_example and a geometry image, .gim or .pfm, or that of a mesh with one border, of
# which each STEP-th row and column is kept:
#
#   bash examples/run.sh --image [IMAGE [STEP]]
#
# EDGE_LENGTH is relative to the longest side of the bounding box. Everything is written to examples/output/.
# AZIMUTH in the environment turns the camera, in degrees.
# With another CGAL than the system's:  CGAL_DIR=/path/to/CGAL bash examples/run.sh
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"
source "$root/examples/pictures.sh"

need_packages "${base_packages[@]}" "${picture_packages[@]}"
need_data

is_image=
if [ "${1:-}" = --image ]; then
  is_image=yes
  shift
fi
input=$(realpath "${1:-$CGAL_DATA_DIR/meshes/$([ $is_image ] && echo lion-head || echo armadillo).off}")
setting=${2:-$([ $is_image ] && echo 4 || echo 0.012)}
cd "$root"
output=examples/output
programs=$build_dir/examples/Vertex_location_optimization

configure
mkdir -p "$output"
if [ $is_image ]; then
  cmake --build "$build_dir" -j "$jobs" --target optimize_geometry_image_example
  "$programs/optimize_geometry_image_example" "$input" "$setting" "$output/image_" | tee "$output/image_log.txt"
  compare_images "$output/image_" "$output/image_errors.png" --edges --camera-azimuth-angle="${AZIMUTH:-0}"
  echo "picture: $output/image_errors.png"
else
  cmake --build "$build_dir" -j "$jobs" --target optimize_remesh
  "$programs/optimize_remesh" "$input" --edge-length "$setting" --output "$output/" | tee "$output/log.txt"
  compare_errors "$output/" "$output/errors.png" --camera-azimuth-angle="${AZIMUTH:-180}"
  echo "picture: $output/errors.png"
fi
