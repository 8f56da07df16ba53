# shellcheck shell=bash disable=SC2034,SC2054,SC2154
# Pictures of meshes, by the ray tracer Tachyon and ImageMagick; to be sourced after cmake/setup.sh.
#
#   can_make_pictures                                     whether both are there
#   render MESH PICTURE [NAME=VALUE...]                   a mesh, with variables of mesh_to_scene.awk
#   put_side_by_side PICTURE (PART TITLE)...              pictures in a row
#   put_scale_below PICTURE LARGEST UNIT [FORMAT]         the scale of the colors; PNG8, a small file, or PNG24
#   compare_errors PREFIX PICTURE [NAME=VALUE...]         what optimize_remesh wrote, before and after; $remesher made the
#                                                         remesh, unless it was isotropic_remeshing()
#   compare_images PREFIX PICTURE [NAME=VALUE...]         what optimize_geometry_image_example wrote, before and after

picture_packages=(tachyon-bin-nox imagemagick fonts-dejavu-core)
font=DejaVu-Sans

# viridis, at regular distances, as the colors of mesh_output.h
viridis=(68,1,84 71,44,122 59,81,139 44,113,142 33,144,141 39,173,129 92,200,99 170,220,50 253,231,37)

can_make_pictures()
{
  command -v tachyon > /dev/null && { command -v magick || command -v convert; } > /dev/null
}

# ImageMagick 7, or 6
image_magick()
{
  if command -v magick > /dev/null; then magick "$@"; else convert "$@"; fi
}

render()
{
  local mesh=$1 picture=$2 value variables=()
  shift 2
  for value in "$@"; do
    variables+=(-v "$value")
  done
  LC_ALL=C awk -v colors="${viridis[*]}" "${variables[@]}" -f "$root/examples/mesh_to_scene.awk" "$mesh" > "$picture.scene" &&
    tachyon "$picture.scene" -mediumshade -format PPM -o "$picture.ppm" > "$picture.log" &&
    image_magick "$picture.ppm" "$picture" &&
    rm "$picture.scene" "$picture.ppm" "$picture.log"
}

put_side_by_side()
{
  local picture=$1 parts=() width=$((2800 / ($# - 1)))
  shift
  while [ $# -gt 0 ]; do
    parts+=("(" "$1" -resize "$((width - 24))x900" -background white -gravity north -extent "${width}x"
            -splice 0x56 -font "$font" -pointsize 25 -annotate +0+12 "$2" ")")
    shift 2
  done
  image_magick "${parts[@]}" -background white -gravity north +append "$picture"
}

# The arrow says that larger values have the last color, too. The colors fit into a palette: 80 of the scale, 150 of the
# picture unless the FORMAT has no palette, and some greys.
put_scale_below()
{
  local picture=$1 largest=$2 unit=$3 format=${4:-PNG8} few=(+dither -colors 150) stops=("${viridis[@]/#/xc:rgb(}")
  [ "$format" = PNG8 ] || few=()
  image_magick -size 1x1 "${stops[@]/%/)}" +append -filter triangle -resize '90x1!' -gravity center -crop 80x1+0+0 +repage \
    -scale '640x26!' -background white -gravity west -extent 668x26 +antialias -fill "rgb(${viridis[-1]})" \
    -draw 'polygon 640,0 667,13 640,25' -gravity center -extent 1400x50 "$picture.scale.png" &&
    image_magick -size 1400x76 xc:white -font "$font" -pointsize 23 -gravity north -annotate -334+0 0 \
      -annotate +306+0 "$largest" -annotate +0+38 "$unit" -colors 12 "$picture.text.png" &&
    image_magick "(" "$picture" "${few[@]}" ")" "$picture.scale.png" "$picture.text.png" -append -strip "$format:$picture" &&
    rm "$picture.scale.png" "$picture.text.png"
}

# render_errors PREFIX NAME [NAME=VALUE...]: PREFIXNAME_error.vtp in the colors of which PREFIXlog.txt tells
render_errors()
{
  local prefix=$1 name=$2
  shift 2
  render "$prefix${name}_error.vtp" "$prefix$name.png" largest="$(scale_of "$prefix" 1)" "$@"
}

# scale_of PREFIX WHICH: what is yellow, 1: in the unit of the coordinates, 2: in 1/10000 of the longest side
scale_of() { sed -n "s/.*(violet) to \([^ ]*\) (yellow), \([^ ]*\)\/10000 .*/\\$2/p" "$1log.txt"; }

# mean_error PREFIX COLUMN: what the log says, before (1) and after (2)
mean_error() { awk -v column="$2" '$1 == "mean" && $2 == "error" { print $(2 + column); exit }' "$1log.txt"; }

scale_unit="distance to the input, in 1/10000 of the longest side of its bounding box"

compare_errors()
{
  local prefix=$1 picture=$2 remesher=${remesher:-isotropic_remeshing()}
  shift 2
  render_errors "$prefix" remesh "$@" && render_errors "$prefix" optimized "$@" &&
    put_side_by_side "$picture" "${prefix}remesh.png" "$remesher: mean error $(mean_error "$prefix" 1)" \
      "${prefix}optimized.png" "optimize_vertex_locations(): $(mean_error "$prefix" 2)" &&
    put_scale_below "$picture" "$(scale_of "$prefix" 2)" "$scale_unit"
}

compare_images()
{
  local prefix=$1 picture=$2
  shift 2
  image_magick "${prefix}image.ppm" -filter point -resize 900x900 "${prefix}picture.png" &&
    render_errors "$prefix" image "$@" && render_errors "$prefix" optimized "$@" &&
    put_side_by_side "$picture" "${prefix}picture.png" "image: x, y, z as colors" \
      "${prefix}image.png" "its surface" "${prefix}optimized.png" "optimize_geometry_image()" &&
    put_scale_below "$picture" "$(scale_of "$prefix" 2)" "$scale_unit" PNG24
}
