# The figure of the reference surface of a part: awk -f make_reference_figure.awk > fig/reference_of_part.svg
#
# The profile is a plane, a fillet of four steps, and a plane. The curve over a chord is the cubic of the PN triangles; at
# a seam the normal is that of the plane, or the average of the two facets.


# the exact point with the parameter t in [0, 1] of chord i
function exact(i, t, xy,    a)
{
  if(i == 0 || i == steps + 1)
  {
    xy[0] = px[i] + t * (px[i + 1] - px[i])
    xy[1] = py[i] + t * (py[i + 1] - py[i])
    return
  }
  a = (i - 1 + t) * pi / 2 / steps
  xy[0] = length_of_plane + radius * sin(a)
  xy[1] = radius - radius * cos(a)
}

# the point of the cubic over chord i, whose normals turn by turn[i] and turn[i + 1] from the x-axis
function cubic(i, t, xy,    dx, dy, k, n0x, n0y, n1x, n1y, b0, b1, s)
{
  dx = px[i + 1] - px[i]
  dy = py[i + 1] - py[i]
  n0x = -sin(turn[i]); n0y = cos(turn[i])
  n1x = -sin(turn[i + 1]); n1y = cos(turn[i + 1])
  b0 = -(dx * n0x + dy * n0y) / 3
  b1 = (dx * n1x + dy * n1y) / 3
  s = 1 - t
  xy[0] = px[i] + t * dx + 3 * s * s * t * b0 * n0x + 3 * s * t * t * b1 * n1x
  xy[1] = py[i] + t * dy + 3 * s * s * t * b0 * n0y + 3 * s * t * t * b1 * n1y
}

function put(xy, is_first)
{
  printf "%s%.2f %.2f", is_first ? "M" : " L", 20 + scale * xy[0], y0 - scale * xy[1]
}

function draw(kind, style,    i, k, p, q)
{
  printf "<path fill='none' %s d='", style
  for(i = 0; i <= steps + 1; ++i)
    for(k = (i == 0 ? 0 : 1); k <= 16; ++k)
    {
      exact(i, k / 16, q)
      if(kind == "exact") { p[0] = q[0]; p[1] = q[1] }
      else if(kind == "flat") { p[0] = px[i] + k / 16 * (px[i + 1] - px[i]); p[1] = py[i] + k / 16 * (py[i + 1] - py[i]) }
      else cubic(i, k / 16, p)
      p[0] = q[0] + exaggeration * (p[0] - q[0])
      p[1] = q[1] + exaggeration * (p[1] - q[1])
      put(p, i == 0 && k == 0)
    }
  print "'/>"
}

function panel(title, kind, top)
{
  y0 = top + 190
  printf "<text x='20' y='%d' font-family='sans-serif' font-size='14'>%s</text>\n", top + 16, title
  draw("exact", "stroke='#bbbbbb' stroke-width='4'")
  draw(kind, "stroke='#21918c' stroke-width='1.5'")
  for(i = 1; i <= steps + 1; ++i)
    printf "<circle cx='%.2f' cy='%.2f' r='2.5' fill='#440154'/>\n", 20 + scale * px[i], y0 - scale * py[i]
}

BEGIN {
  pi = atan2(0, -1)
  steps = 4; radius = 1; length_of_plane = 4; scale = 30; exaggeration = 3
  px[0] = 0; py[0] = 0
  for(i = 0; i <= steps; ++i)
  {
    px[i + 1] = length_of_plane + radius * sin(i * pi / 2 / steps)
    py[i + 1] = radius - radius * cos(i * pi / 2 / steps)
  }
  px[steps + 2] = length_of_plane + radius
  py[steps + 2] = radius + length_of_plane
  print "<svg xmlns='http://www.w3.org/2000/svg' width='640' height='230' viewBox='0 0 640 230'>"
  print "<rect width='640' height='230' fill='white'/>"
  for(i = 1; i <= steps + 1; ++i) turn[i] = (i - 1) * pi / 2 / steps
  turn[0] = 0; turn[steps + 2] = pi / 2
  panel("flat", "flat", 0)
  print "<g transform='translate(210, 0)'>"
  # averaged: the seams turn by half of the half step, the free ends are those of the planes
  turn[1] = pi / 2 / steps / 4; turn[steps + 1] = pi / 2 - turn[1]
  panel("averaged by angles", "cubic", 0)
  print "</g><g transform='translate(420, 0)'>"
  turn[1] = 0; turn[steps + 1] = pi / 2
  panel("PN_triangle_surface", "cubic", 0)
  print "</g>"
  print "</svg>"
}
