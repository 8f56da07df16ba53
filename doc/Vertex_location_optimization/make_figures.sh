#!/usr/bin/env bash
# Makes the pictures in doc/Vertex_location_optimization/fig/ with the examples, and the plots with the benchmarks, which
# takes half an hour:
#
#   bash doc/Vertex_location_optimization/make_figures.sh [pictures|plots [DIRECTORY]]
#
# The plot of Lucy in benchmark/ is made, too, if there is a lucy.off in DIRECTORY.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../../cmake/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../../cmake/setup.sh"
# shellcheck source-path=SCRIPTDIR source=../../examples/pictures.sh
source "$root/examples/pictures.sh"
what=${1:-all}

need_packages "${base_packages[@]}" "${picture_packages[@]}" gnuplot-nox
need_data

figures=$root/doc/Vertex_location_optimization/fig
examples=$build_dir/examples/Vertex_location_optimization
work=$build_dir/figures
mkdir -p "$figures" "$work"

# shellcheck disable=SC2119
configure

# draw_errors NAME MODEL "OPTIONS" [NAME=VALUE...]: the errors before and after, as errors_NAME.png; OPTIONS are those of
# optimize_remesh, the others are variables of mesh_to_scene.awk
draw_errors()
{
  local name=$1 model=$2 options=$3
  shift 3
  # shellcheck disable=SC2086  # the options are several words
  "$examples/optimize_remesh" "$CGAL_DATA_DIR/meshes/$model.off" $options --output "$work/${name}_" | tee "$work/${name}_log.txt"
  compare_errors "$work/${name}_" "$figures/errors_$name.png" "$@"
}

# draw_normals MODEL EDGE_LENGTH [NAME=VALUE...]: a coarse remesh with its own and with optimized normals
draw_normals()
{
  local model=$1 edge_length=$2 kind
  shift 2
  "$examples/optimize_vertex_normals_example" "$CGAL_DATA_DIR/meshes/$model.off" "$edge_length" "$work/${model}_"
  for kind in input face own optimized; do
    render "$work/${model}_${kind}_normals.ply" "$work/$kind.png" "$@"
  done
  put_side_by_side "$figures/normals_$model.png" "$work/face.png" "normals of the faces" \
    "$work/own.png" "own vertex normals" "$work/optimized.png" "optimized normals" "$work/input.png" "input"
  image_magick "$figures/normals_$model.png" +dither -colors 128 "PNG8:$figures/normals_$model.png"
}

# draw_colors MODEL EDGE_LENGTH [NAME=VALUE...]: a coarse remesh with sampled and with optimized colors
draw_colors()
{
  local model=$1 edge_length=$2 kind
  shift 2
  "$examples/optimize_attributes_example" "$CGAL_DATA_DIR/meshes/$model.off" "$edge_length" "$work/${model}_"
  for kind in input sampled optimized; do
    render "$work/${model}_${kind}_colors.ply" "$work/$kind.png" "$@"
  done
  put_side_by_side "$figures/colors_$model.png" "$work/sampled.png" "colors at the closest points" \
    "$work/optimized.png" "optimized colors" "$work/input.png" "input"
  image_magick "$figures/colors_$model.png" +dither -colors 160 "PNG8:$figures/colors_$model.png"
}

# draw_quads MODEL [NAME=VALUE...]: coarse quads of a subdivision surface, before and after
draw_quads()
{
  local model=$1
  shift
  "$examples/optimize_quads_example" "$CGAL_DATA_DIR/meshes/$model.off" "$work/quads_"
  "$examples/optimize_remesh" "$work/quads_surface.off" --remesh "$work/quads_quads.off" --output "$work/quads_" |
    tee "$work/quads_log.txt"
  remesher="coarse quads" compare_errors "$work/quads_" "$figures/errors_quads.png" edges=1 "$@"
}

number_of_vertices() { sed -n 2p "$1" | cut -d ' ' -f 1; }

# draw_tolerance MODEL EDGE_LENGTH LARGEST [NAME=VALUE...]: what is within a tolerance of 1% of the longest side: what the
# remesher alone makes of a short enough edge length, and what remesh_within_tolerance() finds
draw_tolerance()
{
  local model=$1 edge_length=$2 largest=$3
  shift 3
  "$examples/optimize_remesh" "$CGAL_DATA_DIR/meshes/$model.off" --edge-length "$edge_length" --reference flat \
    --largest-color "$largest" --output "$work/alone_" | tee "$work/alone_log.txt"
  "$examples/optimize_remesh" "$CGAL_DATA_DIR/meshes/$model.off" --tolerance 1% --reference flat \
    --largest-color "$largest" --output "$work/within_" | tee "$work/within_log.txt"
  render "$work/alone_remesh_error.vtp" "$work/alone.png" largest="$largest" "$@"
  render "$work/within_optimized_error.vtp" "$work/within.png" largest="$largest" "$@"
  put_side_by_side "$figures/tolerance_$model.png" \
    "$work/alone.png" "isotropic_remeshing(): $(number_of_vertices "$work/alone_remesh.off") vertices" \
    "$work/within.png" "remesh_within_tolerance(): $(number_of_vertices "$work/within_optimized.off") vertices"
  put_scale_below "$figures/tolerance_$model.png" "$(scale_of "$work/alone_" 2)" "$scale_unit"
}

draw_pictures()
{
  cmake --build "$build_dir" -j "$jobs" --target optimize_remesh optimize_vertex_normals_example optimize_attributes_example \
    optimize_geometry_image_example optimize_quads_example
  draw_errors armadillo armadillo "--edge-length 0.012" azimuth=180
  draw_errors refined_elephant refined_elephant "--edge-length 0.025"
  draw_errors bunny00 bunny00 "--edge-length 0.05" edges=1
  draw_errors fandisk fandisk "--edge-length 0.04 --least-squares --reference flat" edges=1 azimuth=30 elevation=20
  remesher="edge_collapse()" draw_errors simplified armadillo "--simplify 2000 --least-squares --reference flat" \
    edges=1 azimuth=180
  draw_tolerance hand 0.016 0.005 edges=1
  draw_quads double-torus-example elevation=20
  draw_normals armadillo 2.7 azimuth=180
  draw_colors bunny00 0.03
  "$examples/optimize_geometry_image_example" "$CGAL_DATA_DIR/meshes/lion-head.off" 4 "$work/image_" | tee "$work/image_log.txt"
  compare_images "$work/image_" "$figures/geometry_image.png" edges=1
  image_magick "$figures/geometry_image.png" -resize 1100x +dither -posterize 32 -strip "PNG24:$figures/geometry_image.png"

  awk -f "$root/doc/Vertex_location_optimization/make_reference_figure.awk" > "$figures/reference_of_part.svg"

  # the package's picture in the overview of CGAL, without titles and scale
  put_side_by_side "$work/overview.png" "$work/bunny00_remesh.png" "" "$work/bunny00_optimized.png" ""
  image_magick "$work/overview.png" +repage -gravity north -chop 0x56 -resize 420x +dither -colors 64 -strip \
    "PNG8:$figures/vertex_location_optimization.png"
}

# draw_curves DIRECTORY NAME Y_LABEL [CSV...]: NAME.svg in the directory, from NAME.csv or from others
draw_curves()
{
  local directory=$1 name=$2 label=$3
  shift 3
  [ $# -gt 0 ] || set -- "$name"
  (cd "$work" && gnuplot -c "$root/benchmark/Vertex_location_optimization/plot_curves.gp" \
    "$directory/$name.svg" "$label" "${@/%/.csv}")
}

draw_plots()
{
  local benchmarks=$build_dir/benchmark/Vertex_location_optimization
  cmake --build "$build_dir" -j "$jobs" --target quality performance
  # the errors of remeshes with more and more vertices: the whole benchmark, which takes a quarter of an hour
  (cd "$work" && "$benchmarks/quality" "$@")
  draw_curves "$figures" error_by_vertices_armadillo "mean error, in 1/10000 of the size"
  draw_curves "$figures" trade_off_armadillo ""
  [ $# = 0 ] || draw_curves "$root/benchmark" error_by_vertices_lucy "mean error, in 1/10000 of the size"
  # the growth of the time, which takes some ten minutes
  "$benchmarks/performance" --sections growth --growth "$work/growth"
  draw_curves "$figures" growth seconds growth_with_remesh growth_with_reference
}

[ "$what" = plots ] || draw_pictures
[ "$what" = pictures ] || draw_plots ${2:+"$(realpath "$2")"}
