# Writes a mesh as a scene for the ray tracer Tachyon:
#
#   awk -f mesh_to_scene.awk [-v NAME=VALUE]... MESH
#
# MESH is a polygon mesh, a text file: .vtp as the examples write it, or a triangle mesh as .ply, if need be with normals or
# colors. The variables are
#   azimuth, elevation   of the camera, in degrees; at 0 it looks along the negative z axis, and y is up
#   colors               red, green and blue, between 0 and 255, of the scalars from 0 to `largest`
#   largest              if it is given, the scalars are shown in colors
#   edges                1: with the edges
#   height               of the picture, in pixels

BEGIN {
  pi = atan2(0, -1)
  n_colors = split(colors, color, /[ ,]/) / 3
  n_points = n_faces = n_edges = n_scalars = 0
  if(!height) height = 1000
}

# which array of a .vtp follows; the header of a .ply, and what comes after it
/<DataArray|<PointData|<Points>|<Polys>/ {
  part = /Name="error"/ ? "scalars" : /NumberOfComponents="3"/ ? "points" : /"connectivity"/ ? "faces" : ""
  next
}
/^</ { part = ""; next }
/^element vertex/ { n_ply = $3; next }
/^property .* red$/ { red = n_properties + 1 } # the column
/^property/ { ++n_properties; next }
/^end_header/ { part = "ply"; next }
part == "scalars" { scalar[n_scalars++] = $1; next }
part == "points" { add_point($1, $2, $3); next }
part == "faces" { add_polygon(); next }
part == "ply" && n_points < n_ply {
  if(red) scalar[n_points] = $red / 255 " " $(red + 1) / 255 " " $(red + 2) / 255
  else if(NF >= 6) rotate($4, $5, $6, n_points, normal)
  add_point($1, $2, $3)
  next
}
part == "ply" { $1 = ""; $0 = $0; add_polygon() }

# to what the camera sees: y up, z towards it, and x to the left, as Tachyon has it
function rotate(x, y, z, i, result,    a, e, depth)
{
  a = azimuth * pi / 180
  e = elevation * pi / 180
  depth = x * sin(a) + z * cos(a)
  result[i, 0] = z * sin(a) - x * cos(a)
  result[i, 1] = y * cos(e) - depth * sin(e)
  result[i, 2] = y * sin(e) + depth * cos(e)
}

function add_point(x, y, z,    k)
{
  raw[n_points, 0] = x; raw[n_points, 1] = y; raw[n_points, 2] = z
  rotate(x, y, z, n_points, point)
  for(k = 0; k < 3; ++k) {
    if(!n_points || point[n_points, k] < low[k]) low[k] = point[n_points, k]
    if(!n_points || point[n_points, k] > high[k]) high[k] = point[n_points, k]
  }
  ++n_points
}

# the one in this line; if it has more than three corners it is a fan around its center
function add_polygon(    i, j, k, x, y, z, s)
{
  for(i = 1; i <= NF; ++i) {
    j = i % NF + 1
    edge[n_edges, 0] = $i
    edge[n_edges++, 1] = $j
    if(NF == 3) continue
    x += raw[$i, 0] / NF; y += raw[$i, 1] / NF; z += raw[$i, 2] / NF; s += scalar[$i] / NF
  }
  if(NF == 3) {
    add_face($1, $2, $3)
    return
  }
  scalar[n_points] = s
  add_point(x, y, z)
  for(i = 1; i <= NF; ++i)
    add_face($i, $(i % NF + 1), n_points - 1)
}

function add_face(a, b, c)
{
  # the other way around, since x is mirrored
  corner[n_faces, 0] = a
  corner[n_faces, 1] = c
  corner[n_faces++, 2] = b
}

# the color of a scalar, which in a .ply is one
function color_of(value,    t, i, k, result)
{
  if(red) return value
  if(!largest) return "0.8 0.82 0.86"
  t = value >= largest ? n_colors - 1 : value / largest * (n_colors - 1)
  i = t >= n_colors - 1 ? n_colors - 2 : int(t)
  for(k = 1; k <= 3; ++k)
    result = result " " (color[3 * i + k] + (t - i) * (color[3 * i + 3 + k] - color[3 * i + k])) / 255
  return result
}

# a triangle with normals n and scalars s; where these differ much, as four, since colors are interpolated between corners
function put_triangle(ax, ay, az, bx, by, bz, cx, cy, cz, n, sa, sb, sc, level,    dx, dy, dz, ex, ey, ez, fx, fy, fz, spread)
{
  spread = largest / 4
  if(largest && (sa - sb > spread || sb - sa > spread || sb - sc > spread || sc - sb > spread || sc - sa > spread ||
                 sa - sc > spread) && (sa < largest || sb < largest || sc < largest) && level < 4) {
    dx = (bx + cx) / 2; dy = (by + cy) / 2; dz = (bz + cz) / 2
    ex = (cx + ax) / 2; ey = (cy + ay) / 2; ez = (cz + az) / 2
    fx = (ax + bx) / 2; fy = (ay + by) / 2; fz = (az + bz) / 2
    put_triangle(ax, ay, az, fx, fy, fz, ex, ey, ez, n, sa, (sa + sb) / 2, (sc + sa) / 2, level + 1)
    put_triangle(bx, by, bz, dx, dy, dz, fx, fy, fz, n, sb, (sb + sc) / 2, (sa + sb) / 2, level + 1)
    put_triangle(cx, cy, cz, ex, ey, ez, dx, dy, dz, n, sc, (sc + sa) / 2, (sb + sc) / 2, level + 1)
    put_triangle(dx, dy, dz, ex, ey, ez, fx, fy, fz, n, (sb + sc) / 2, (sc + sa) / 2, (sa + sb) / 2, level + 1)
    return
  }
  print "VCSTRI V0", ax, ay, az, "V1", bx, by, bz, "V2", cx, cy, cz, n, "C0", color_of(sa), "C1", color_of(sb), "C2", color_of(sc),
        "AMBIENT 0.5 DIFFUSE 0.6 SPECULAR 0 OPACITY 1 VCST"
}

function x_of(i) { return scale * (point[i, 0] - (low[0] + high[0]) / 2) }
function y_of(i) { return scale * (point[i, 1] - (low[1] + high[1]) / 2) }
function z_of(i) { return scale * (point[i, 2] - high[2]) }

END {
  OFMT = CONVFMT = "%.7g"
  size = high[1] - low[1] # as high as the picture, which is at most four times as wide as high
  if(size < (high[0] - low[0]) / 4) size = (high[0] - low[0]) / 4
  if(!size) exit 1
  scale = 1.98 / size
  print "BEGIN_SCENE RESOLUTION", int(height * (high[0] - low[0]) / size) + 20, height
  print "CAMERA PROJECTION ORTHOGRAPHIC ZOOM 0.5 ASPECTRATIO 1 ANTIALIASING 4 RAYDEPTH 2"
  print "CENTER 0 0 1 VIEWDIR 0 0 -1 UPDIR 0 1 0 END_CAMERA BACKGROUND 1 1 1"
  print "DIRECTIONAL_LIGHT DIRECTION -0.4 -0.5 -1 COLOR 1 1 1"
  for(f = 0; f < n_faces; ++f) {
    a = corner[f, 0]; b = corner[f, 1]; c = corner[f, 2]
    ax = x_of(a); ay = y_of(a); az = z_of(a)
    bx = x_of(b); by = y_of(b); bz = z_of(b)
    cx = x_of(c); cy = y_of(c); cz = z_of(c)
    if((a, 0) in normal)
      n = "N0 " normal[a, 0] " " normal[a, 1] " " normal[a, 2] " N1 " normal[b, 0] " " normal[b, 1] " " normal[b, 2] \
          " N2 " normal[c, 0] " " normal[c, 1] " " normal[c, 2]
    else {
      nx = (by - ay) * (cz - az) - (bz - az) * (cy - ay)
      ny = (bz - az) * (cx - ax) - (bx - ax) * (cz - az)
      nz = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
      length_ = sqrt(nx * nx + ny * ny + nz * nz)
      if(!length_) continue
      n = nx / length_ " " ny / length_ " " nz / length_
      n = "N0 " n " N1 " n " N2 " n
    }
    put_triangle(ax, ay, az, bx, by, bz, cx, cy, cz, n, scalar[a], scalar[b], scalar[c], 0)
  }
  for(f = 0; edges && f < n_edges; ++f) {
    i = edge[f, 0]; j = edge[f, 1]
    if(!((j, i) in is_drawn)) {
      is_drawn[i, j]
      print "FCYLINDER BASE", x_of(i), y_of(i), z_of(i), "APEX", x_of(j), y_of(j), z_of(j), "RAD 0.0015",
            "TEXTURE AMBIENT 0.1 DIFFUSE 0 SPECULAR 0 OPACITY 1 COLOR 0 0 0 TEXFUNC 0"
    }
  }
  print "END_SCENE"
}
