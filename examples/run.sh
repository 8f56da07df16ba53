#!/usr/bin/env bash
# Builds optimize_remesh, runs it on CGAL's armadillo, and makes a picture of the errors before and after:
#
#   bash examples/run.sh [MESH [EDGE_LENGTH]] [OPTION...]
#
# EDGE_LENGTH is relative to the longest side of the bounding box. The options are those of optimize_remesh, such as
# --least-squares; `optimize_remesh --help` lists them. With --image, the same for optimize_geometry_image_example and a
# geometry image, .gim or .pfm, or that of a mesh with one border, of which every STEP-th row and column is kept:
#
#   bash examples/run.sh --image [IMAGE [STEP]]
#
# Everything is written to examples/output/. Environment variables:
#   AZIMUTH         turns the camera, in degrees
#   CGAL_DIR        a CGAL other than the system's
#   CGAL_DATA_DIR   CGAL's demo data; by default, it is downloaded to ~/.cache
#   JOBS            the number of compilers that run at once
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../cmake/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"
# shellcheck source-path=SCRIPTDIR source=pictures.sh
source "$root/examples/pictures.sh"

kind=remesh program=optimize_remesh default_mesh=armadillo setting=0.012 azimuth=180 prefix=
case ${1:-} in
-h | --help)
  print_help "${BASH_SOURCE[0]}"
  exit
  ;;
--image)
  kind=image program=optimize_geometry_image_example default_mesh=lion-head setting=4 azimuth=0 prefix=image_
  shift
  ;;
esac
input=
if [ $# -gt 0 ] && [[ $1 != -* ]]; then
  input=$1
  shift
fi
if [ -n "$input" ] && [ $# -gt 0 ] && [[ $1 != -* ]]; then
  setting=$1
  shift
fi

need_packages "${base_packages[@]}" "${picture_packages[@]}" || have_packages "${base_packages[@]}"
if [ -z "$input" ]; then
  need_data
  input=$CGAL_DATA_DIR/meshes/$default_mesh.off
fi
echo "Building $program"
quietly configure
quietly cmake --build "$build_dir" -j "$jobs" --target "$program"

output=$(realpath --relative-to=. "$root/examples/output")
mkdir -p "$output"
program=$build_dir/examples/Vertex_location_optimization/$program
if [ $kind = image ]; then
  "$program" "$input" "$setting" "$output/image_" | tee "$output/image_log.txt"
else
  "$program" "$input" --edge-length "$setting" --output "$output/" "$@" | tee "$output/log.txt"
fi

picture=$output/${prefix}errors.png
draw=compare_errors options=()
[ $kind = image ] && draw=compare_images options=(edges=1)
if ! can_make_pictures; then
  echo "no picture: it takes Tachyon and ImageMagick"
elif quietly "$draw" "$output/$prefix" "$picture" azimuth="${AZIMUTH:-$azimuth}" "${options[@]}"; then
  echo "picture: $picture"
else
  echo "no picture: Tachyon or ImageMagick failed"
fi
