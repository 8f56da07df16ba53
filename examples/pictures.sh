# Pictures of meshes, without a display; to be sourced.
#
#   render MESH PICTURE [OPTION...]                 a mesh
#   render_error MESH PICTURE LARGEST [OPTION...]   a mesh with its errors as colors
#   put_side_by_side PICTURE (PART TITLE)...        pictures in a row
#   put_scale_below PICTURE LARGEST [FORMAT]        the scale of the colors
#   compare_errors PREFIX PICTURE [OPTION...]       what optimize_remesh wrote, before and after
#   compare_images PREFIX PICTURE [OPTION...]       what optimize_geometry_image_example wrote, before and after

picture_packages=(f3d xvfb xauth imagemagick fonts-dejavu-core)
font=DejaVu-Sans

# blue, green, yellow, orange, red, as the colors that optimize_remesh writes
colormap=0,0,0,1,0.25,0,0.78,0,0.5,1,1,0,0.75,1,0.55,0,1,1,0,0
colors=('#0000ff' '#00c800' '#ffff00' '#ff8c00' '#ff0000')

# render MESH PICTURE [OPTION...]: the mesh on white, without the margins; the options are those of f3d
render()
{
  local mesh=$1 picture=$2
  shift 2
  xvfb-run -a -s "-screen 0 1600x1600x24" \
    f3d --dry-run --quiet "$mesh" --output "$picture" --bg-color=1,1,1 --resolution=1400,1400 --up=+Y \
        --camera-view-angle=22 --roughness=1 --fxaa "$@"
  convert "$picture" -trim +repage -resize x1000 "$picture"
}

# render_error MESH PICTURE LARGEST [OPTION...]: the scalar "error" of a .vtp in colors, of which LARGEST is red
render_error()
{
  local mesh=$1 picture=$2 largest=$3
  shift 3
  render "$mesh" "$picture" --scalars=error --comp=0 --range=0,"$largest" --colormap=$colormap "$@"
  convert "$picture" -level 0%,75% "$picture"
}

# put_side_by_side PICTURE (PART TITLE)...
put_side_by_side()
{
  local picture=$1 parts=()
  shift
  while [ $# -gt 0 ]; do
    parts+=("(" "$1" -background white -gravity north -splice 0x70 -font "$font" -pointsize 32 -annotate +0+10 "$2"
            -bordercolor white -border 30x10 ")")
    shift 2
  done
  convert "${parts[@]}" +append -resize 1400x "$picture"
}

# put_scale_below PICTURE LARGEST [FORMAT]: with few colors, for a small file, unless the FORMAT is PNG24
put_scale_below()
{
  local format=${3:-PNG8} few=(+dither -colors 160)
  [ "$format" = PNG8 ] || few=()
  convert -size 1x1 "${colors[@]/#/xc:}" +append -filter triangle -resize '750x24!' -gravity center -crop 600x24+0+0 \
    +repage -background white -gravity north -splice 0x10 -extent 1400x80 -font "$font" -pointsize 20 \
    -gravity north -annotate -300+44 0 -annotate +300+44 "$2" -annotate +0+44 "distance to the input" "$1.scale.png"
  # the scale keeps its own colors
  convert \( "$1" "${few[@]}" \) \( "$1.scale.png" +dither -colors 96 \) -append -strip "$format:$1"
  rm "$1.scale.png"
}

# largest_error PREFIX: the error that is red, from PREFIXlog.txt
largest_error() { sed -n 's/.*colors from 0 (blue) to \(.*\) (red).*/\1/p' "$1log.txt"; }

# compare_errors PREFIX PICTURE [OPTION...]: remesh and optimized mesh, which optimize_remesh wrote with `--output PREFIX`
# and told about in PREFIXlog.txt
compare_errors()
{
  local prefix=$1 picture=$2 largest name
  shift 2
  largest=$(largest_error "$prefix")
  for name in remesh optimized; do
    render_error "${prefix}${name}_error.vtp" "${prefix}${name}.png" "$largest" "$@"
  done
  put_side_by_side "$picture" "${prefix}remesh.png" "isotropic_remeshing()" \
                   "${prefix}optimized.png" "and optimize_vertex_locations()"
  put_scale_below "$picture" "$largest"
}

# compare_images PREFIX PICTURE [OPTION...]: the image as a picture, its surface and the optimized one, which
# optimize_geometry_image_example wrote with PREFIX and told about in PREFIXlog.txt
compare_images()
{
  local prefix=$1 picture=$2 largest name
  shift 2
  largest=$(largest_error "$prefix")
  for name in image optimized; do
    render_error "${prefix}${name}_error.vtp" "${prefix}${name}.png" "$largest" "$@"
  done
  convert "${prefix}image.ppm" -filter point -resize 750x750 "${prefix}picture.png"
  put_side_by_side "$picture" "${prefix}picture.png" "the image: x, y, z as red, green, blue" \
                   "${prefix}image.png" "its surface" "${prefix}optimized.png" "after optimize_geometry_image()"
  put_scale_below "$picture" "$largest" PNG24
}
