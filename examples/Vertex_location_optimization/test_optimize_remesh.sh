#!/usr/bin/env bash
# Tests how the program answers files and options that it cannot work with:
#
#   test_optimize_remesh.sh PROGRAM
#
# One line on standard error, a non-zero exit and no file; on good input the files, complete.
set -u
program=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit
failures=0

fail()
{
  echo "failed: $*"
  failures=$((failures + 1))
}

# check_refused [--says PATTERN] ARGUMENT...
check_refused()
{
  local pattern=.
  if [ "${1:-}" = --says ]; then
    pattern=$2
    shift 2
  fi
  if "$program" "$@" -o out_ > stdout 2> stderr; then
    fail "accepted: $*"
  elif [ "$(wc -l < stderr)" != 1 ]; then
    fail "no single line: $*"
    cat stderr
  elif ! grep -q -- "$pattern" stderr; then
    fail "$* does not say: $pattern"
    cat stderr
  elif compgen -G 'out_*' > written; then
    fail "left files: $*"
  fi
}

triangle='OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n'
printf '%b' "$triangle" > triangle.off
: > empty.off
echo garbage > garbage.off
printf 'OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n' > quadrangle.off
printf 'OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n' > points.off
printf 'OFF\n3 1 0\n0 0 0\n0 0 0\n0 0 0\n3 0 1 2\n' > one_point.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\nnan 1 0\n3 0 1 2\n' > nan.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n1e999 1 0\n3 0 1 2\n' > infinite.off
printf 'OFF\n300 1 0\n0 0 0\n1 0 0\n' > truncated.off

printf 'OFF BINARY\n\0\0\0\003\0\0\0\001\0\0\0\0' > binary.off
cp triangle.off triangle.xyz
printf 'v 0 0 0\nv 1 0 0\nv nan 1 0\nf 1 2 3\n' > nan.obj
printf 'OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n' > fewer_faces.off

check_refused --says 'there is no such file' missing.off
check_refused --says 'it is no file' .
check_refused --says 'its extension is none of' triangle.xyz
check_refused --says 'it is empty' empty.off
check_refused --says 'it does not begin with OFF' garbage.off
check_refused --says 'a binary OFF file' binary.off
check_refused --says 'not all triangles; --triangulate makes' quadrangle.off
check_refused --says 'it has no face' points.off
check_refused --says 'all its points are the same' one_point.off
for file in nan.off infinite.off nan.obj; do
  check_refused --says 'a coordinate is not finite' $file
done
for file in truncated.off fewer_faces.off; do
  check_refused --says 'it is truncated' $file
done
check_refused
check_refused --says 'garbage.off: it does not begin' triangle.off --remesh garbage.off
check_refused triangle.off --edge-length 0
check_refused triangle.off --edge-length -1
check_refused triangle.off --edge-length much
check_refused triangle.off --edge-length 5
check_refused triangle.off --reference round
check_refused triangle.off --format xyz
check_refused triangle.off --regularity-weight -1
check_refused triangle.off --simplify 0
check_refused triangle.off --simplify -5
check_refused triangle.off --simplify 3 --edge-length 0.1
check_refused triangle.off --simplify 3 --tolerance 1%
check_refused triangle.off --no-such-option
for tolerance in 0 -1 nan inf much 1mm % '' 1e999; do
  check_refused triangle.off "--tolerance=$tolerance"
done
check_refused triangle.off --tolerance 1% --edge-length 0.1
check_refused triangle.off --tolerance 1% --remesh triangle.off
check_refused triangle.off --tolerance 1% --tolerated-error median
check_refused one_point.off --tolerance 1%
check_refused triangle.off triangle.off

if "$program" triangle.off -o missing_folder/ > stdout 2> stderr || [ "$(wc -l < stderr)" != 1 ]; then
  fail "a folder that is missing"
fi

"$program" triangle.off --edge-length 0.3 -o good_ > stdout 2> stderr || fail "good input"
[ -s stderr ] && fail "standard error is no terminal and got something"
for file in remesh.off remesh_error.ply remesh_error.vtp optimized.off optimized_error.ply optimized_error.vtp; do
  [ -s "good_$file" ] || fail "good_$file is missing"
done
"$program" triangle.off --remesh quadrangle.off -o quads_ > stdout 2> stderr || fail "a remesh of quads"
grep -q '^4 ' quads_optimized.off || fail "no quads"
"$program" triangle.off --edge-length 0.3 --least-squares --regularity-weight 0.2 -o least_squares_ > stdout 2> stderr ||
  fail "least squares"

"$program" quadrangle.off --triangulate --edge-length 0.3 -o triangulated_ > stdout 2> stderr || fail "--triangulate"
grep -q '^4 ' triangulated_remesh.off && fail "quads are left"

# three faces at an edge: two vertices are copies of its ends
printf 'OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n3 0 1 2\n3 1 0 3\n3 0 1 4\n' > three_at_edge.off
"$program" three_at_edge.off --edge-length 0.3 -o copies_ > stdout 2> stderr || fail "a mesh that is not manifold"
grep -q 'vertices were duplicated to make the mesh manifold' stdout || fail "it does not say that vertices were duplicated"

# a disk that is full leaves what was there: here it is a limit on the size of a file, in blocks of 1 KB
cp good_optimized.off before.off
if (ulimit -f 4 && trap '' XFSZ && exec "$program" triangle.off --edge-length 0.05 -o good_ > stdout 2> stderr); then
  fail "a full disk is not noticed"
fi
grep -q 'cannot be written' stderr || fail "a full disk: $(cat stderr)"
cmp -s before.off good_optimized.off || fail "a full disk changed a file"

grep -q 'measured densely' stdout && fail "it measures without being asked"
"$program" least_squares_remesh.off --simplify 6 --measure --relaxation-steps 2 -o simple_ > stdout 2> stderr ||
  fail "simplification"
[ "$(sed -n 2p simple_remesh.off | cut -d ' ' -f 1)" = 6 ] || fail "not simplified to 6 vertices"
grep -q '^  measured densely' stdout && grep -q '^  maximum from the input ' stdout || fail "nothing is measured"
grep -q '^vertices moved: ' stdout || fail "it does not say how many vertices moved"

printf 'OFF\n6 8 0\n1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n3 0 2 4\n3 2 1 4\n3 1 3 4\n3 3 0 4\n' > octahedron.off
printf '3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n' >> octahedron.off
"$program" octahedron.off --edge-length 0.2 --sharpness-angle 180 --least-squares --both-directions --preserve-volume \
  -o closed_ > stdout 2> stderr || fail "both directions and the volume"
grep -q '^volume: ' stdout || fail "it does not say what became of the volume"
awk '/^  mean error from the input / && $7 <= $6 { found = 1 } END { exit !found }' stdout || fail "the error from the input"

# a tolerance: a square keeps its corners
printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n' > square.off
"$program" square.off --tolerance 1% -o within_ > stdout 2> stderr || fail "a tolerance in percent"
grep -q '^within the tolerance: ' stdout || fail "no report of the tolerance"
grep -q ' within$' stdout || fail "no table of the attempts"
[ -s stderr ] && fail "standard error is no terminal and got something about a tolerance"
for corner in '0 0 0' '1 0 0' '1 1 0' '0 1 0'; do
  grep -qx "$corner" within_optimized.off || fail "the corner $corner is lost"
done
for file in optimized.off optimized_error.ply optimized_error.vtp; do
  [ -s "within_$file" ] || fail "within_$file is missing"
done
"$program" square.off --tolerance 0.01 --tolerated-error mean --reference pn -o within_ > stdout 2> stderr ||
  fail "a tolerance as a length"

# volume_of FILE: what the triangles of a closed mesh enclose
volume_of()
{
  awk 'NF == 3 && NR > 1 && vertices && n < vertices { for(i = 1; i <= 3; ++i) x[n, i] = $i; ++n; next }
       NF == 3 && !vertices { vertices = $1; n = 0; next }
       NF >= 4 && $1 == 3 {
         for(i = 1; i <= 3; ++i) {
           j = i % 3 + 1
           k = j % 3 + 1
           v += x[$2, i] * (x[$3, j] * x[$4, k] - x[$3, k] * x[$4, j])
         }
       }
       END { printf "%.9g\n", v / 6 }' "$1"
}

# a tolerance with a guarantee for both directions and the volume, which is 4 / 3
"$program" octahedron.off --tolerance 3% --reference flat --sharpness-angle 180 --both-directions --preserve-volume \
  -o volume_ > stdout 2> stderr || fail "a tolerance, both directions and the volume"
grep -q '^within the tolerance: ' stdout || fail "not within the tolerance with the volume"
volume_of volume_optimized.off | awk '{ exit !(($1 - 4 / 3)^2 < 1e-12) }' ||
  fail "the volume within a tolerance: $(volume_of volume_optimized.off)"

# the input's attributes: colors and normals of a square, and the texture coordinates of a square
# whose halves are apart in the texture
cat > colors.ply <<'END'
ply
format ascii 1.0
element vertex 4
property double x
property double y
property double z
property double nx
property double ny
property double nz
property uchar red
property uchar green
property uchar blue
element face 2
property list uchar int vertex_indices
end_header
0 0 0 0 0 1 10 40 200
1 0 0 0 0 1 10 40 200
1 1 0 0 0 1 10 40 200
0 1 0 0 0 1 10 40 200
3 0 1 2
3 0 2 3
END
"$program" colors.ply --edge-length 0.3 --format off -o colored_ > stdout 2> stderr || fail "a mesh with colors"
head -n 1 colored_optimized.off | grep -q 'NC\|CN' || fail "no colors and normals in $(head -n 1 colored_optimized.off)"
sed -n '3,$p' colored_optimized.off | awk 'NF >= 9 && !(/ 10 40 200/ && $6 == 1) { exit 1 }' || fail "other colors or normals"
"$program" colors.ply --edge-length 0.3 -o colored_ > stdout 2> stderr && grep -aq 'property uchar red' colored_optimized.ply ||
  fail "no colors in the format of the input"

printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 0.4 0\nvt 0.4 0.4\nvt 0.6 0.6\nvt 1 1\nvt 0.6 1\n' > texture.obj
printf 'f 1/1 2/2 3/3\nf 1/4 3/5 4/6\n' >> texture.obj
"$program" texture.obj --edge-length 0.2 -o textured_ > stdout 2> stderr || fail "a mesh with texture coordinates"
grep -q '^f [0-9]*/[0-9]* ' textured_optimized.obj || fail "no texture coordinates"
awk '$1 == "vt" && !(($2 < 0.41 && $3 < 0.41) || ($2 > 0.59 && $3 > 0.59)) { exit 1 }' textured_optimized.obj ||
  fail "texture coordinates between the parts of the texture"
sed 's#/9#/#; s#/6#/600#' texture.obj > broken.obj
"$program" broken.obj --edge-length 0.2 -o broken_ > stdout 2> stderr || fail "texture coordinates that are missing"
grep -q '^vt' broken_optimized.obj && fail "texture coordinates that the input does not have"

compgen -G '*.partial*' > written && fail "an incomplete file is left"
"$program" --help | grep -q -- --edge-length || fail "--help"

echo "$failures failures"
[ "$failures" = 0 ]
