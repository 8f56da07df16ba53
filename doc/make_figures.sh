#!/usr/bin/env bash
# Makes the figures of the manual from what the example optimize_remesh writes:
#   bash doc/make_figures.sh OPTIMIZE_REMESH MESHES
# where OPTIMIZE_REMESH is the built example and MESHES the directory of CGAL's meshes.
# Needs f3d, xvfb-run and ImageMagick.
set -euo pipefail

optimize_remesh=$1
meshes=$2
figures=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/Vertex_location_optimization/fig
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# white is no error, dark red the largest
colormap=0,1,1,1,0.25,1,0.85,0.5,0.5,0.99,0.55,0.24,0.75,0.84,0.19,0.15,1,0.5,0,0.15

# figure NAME MESH LARGEST_ERROR "CAMERA" [OPTION OF OPTIMIZE_REMESH]...: fig/NAME.png, the remesh beside the result
figure()
{
  local name=$1 mesh=$2 largest=$3 camera=$4
  shift 4
  "$optimize_remesh" "$meshes/$mesh" --output "$work/" "$@"
  local which
  for which in remesh optimized; do
    # shellcheck disable=SC2086  # the options of the camera are several words
    xvfb-run -a f3d "$work/${which}_error.vtp" --output="$work/$which.png" --resolution=1000,1000 --edges \
      --scalars=error --range="0,$largest" --colormap="$colormap" --roughness=1 --bg-color=1,1,1 $camera
  done
  convert "$work/remesh.png" "$work/optimized.png" -gamma 1.3 -trim -bordercolor white -border 15 -gravity center +append \
    -resize 1000x -colors 128 -strip "PNG8:$figures/$name.png"
}

figure bunny bunny00.off 0.005 "--camera-view-angle=22" --edge-length 0.05
figure fandisk fandisk.off 0.0008 "--camera-azimuth-angle=30 --camera-elevation-angle=20 --camera-view-angle=27" \
  --edge-length 0.04 --crease-angle 40 --relax-constraints --reference flat
convert "$figures/bunny.png" -resize 420x -colors 64 -strip "PNG8:$figures/vertex_location_optimization.png"
