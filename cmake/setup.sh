# What test/run.sh and examples/run.sh have in common; to be sourced.
#
#   need_packages NAME...   installs the Debian packages that are missing
#   need_data               sets CGAL_DATA_DIR to CGAL's demo data, which it unpacks if need be
#   configure [ARGUMENT...] runs CMake for a Release build in $build_dir
#
# CGAL_DIR in the environment chooses another CGAL than the system's; each CGAL has a build directory of its own.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=${BUILD_DIR:-$root/build${CGAL_DIR:+${CGAL_DIR//\//-}}}
jobs=${JOBS:-$(nproc)}

# what all parts of the package are built with
base_packages=(g++ cmake make libcgal-dev libtbb-dev libeigen3-dev libboost-program-options-dev libopenmesh-dev)

as_root()
{
  if [ "$(id -u)" = 0 ]; then
    "$@"
  elif command -v sudo > /dev/null; then
    sudo "$@"
  else
    echo "error: this needs root or sudo: $*" >&2
    return 1
  fi
}

is_installed() { [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2> /dev/null)" = installed ]; }

need_packages()
{
  local name missing=()
  command -v dpkg-query > /dev/null || return 0 # not a Debian: CMake tells what is missing
  for name in "$@"; do
    is_installed "$name" || missing+=("$name")
  done
  [ ${#missing[@]} = 0 ] && return 0
  as_root apt-get update
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"
}

need_data()
{
  local archive=usr/share/doc/libcgal-dev/data.tar.gz directory=$root/build-data
  if [ ! -d "${CGAL_DATA_DIR:-$directory/data}/meshes" ]; then
    mkdir -p "$directory"
    if [ -f "/$archive" ]; then
      tar -xzf "/$archive" -C "$directory"
    else
      # unpacked rather than installed: an installation may leave out /usr/share/doc
      echo "Getting CGAL's demo data"
      (
        cd "$directory"
        apt-cache show libcgal-demo > /dev/null 2>&1 || as_root apt-get update
        apt-get download libcgal-demo
        dpkg -x libcgal-demo_*.deb .
        tar -xzf "$archive"
        rm -rf libcgal-demo_*.deb usr
      )
    fi
    CGAL_DATA_DIR=$directory/data
  fi
  export CGAL_DATA_DIR=${CGAL_DATA_DIR:-$directory/data}
}

configure() { cmake -S "$root" -B "$build_dir" -DCMAKE_BUILD_TYPE=Release -DCGAL_DATA_DIR="$CGAL_DATA_DIR" "$@"; }
