# shellcheck shell=bash disable=SC2034 # used by those that source it
# What test/run.sh, examples/run.sh and others have in common; to be sourced.
#
#   need_packages NAME...   installs the Debian packages that are missing
#   have_packages NAME...   whether none is missing
#   need_data               sets CGAL_DATA_DIR to CGAL's demo data, which it gets if need be
#   need_CGAL_of SUITE      sets CGAL_DIR to the CGAL of another Debian, which it gets if need be, or fails
#   configure [ARGUMENT...] runs CMake for a Release build in $build_dir
#   print_help SCRIPT       prints the comment with which a script begins
#
# In the environment: CGAL_DIR chooses another CGAL than the system's; each CGAL has a build directory of its own.
# CGAL_DATA_DIR is where CGAL's demo data are, JOBS how many compilers run at once.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=${BUILD_DIR:-$root/build${CGAL_DIR:+${CGAL_DIR//\//-}}}
jobs=${JOBS:-$(nproc)}
cache=${XDG_CACHE_HOME:-${HOME:-$root/build}/.cache}/CGAL_Vertex_location_optimization # shared by all clones

# what all parts of the package are built with
base_packages=(g++ cmake make libcgal-dev libtbb-dev libeigen3-dev libboost-program-options-dev)

print_help() { sed -n '/^#!/d; /^#/!q; s/^# \{0,1\}//p' "$1"; }

# quietly COMMAND...: what it prints goes to a file, of which the end is shown if it fails
quietly()
{
  local log=$build_dir/setup.log
  mkdir -p "$build_dir"
  "$@" > "$log" 2>&1 < /dev/null && return
  tail -n 20 "$log" >&2
  echo "error: this failed, see $log: $*" >&2
  return 1
}

as_root() { if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi; }

# sudo may ask for a password on a terminal only
can_be_root() { [ "$(id -u)" = 0 ] || sudo -n true 2> /dev/null || { [ -t 0 ] && sudo -v 2> /dev/null; }; }

missing_packages()
{
  local name
  command -v dpkg-query > /dev/null || return 0 # not a Debian: CMake tells what is missing
  for name in "$@"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$name" 2> /dev/null)" = installed ] || echo "$name"
  done
}

have_packages() { [ -z "$(missing_packages "$@")" ]; }

need_packages()
{
  local missing
  mapfile -t missing < <(missing_packages "$@")
  [ ${#missing[@]} = 0 ] && return
  if ! can_be_root; then
    echo "Packages are missing. Ask an administrator for:" >&2
    echo "  apt-get install --no-install-recommends ${missing[*]}" >&2
    return 1
  fi
  as_root apt-get update > /dev/null 2>&1 < /dev/null || true # the installation tells whether it matters
  echo "Installing ${missing[*]}"
  LC_ALL=C apt-get install --assume-no --no-install-recommends -o Debug::NoLocking=1 "${missing[@]}" 2> /dev/null |
    sed -n 's/^.* upgraded, \([0-9]*\) newly installed.*/  with what they need: \1 packages/p
            s/^Need to get \(.*\) of archives\./  to download: \1/p
            s/^After this operation, \(.*\) of additional.*/  on disk: \1/p' || true # "no" is an error of apt-get
  quietly as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"
}

# unpack DIRECTORY PACKAGE [OPTION...]: a package that is not installed; the options are those of apt-get
unpack()
{
  local directory=$1 package=$2 partial=$1.$$
  shift 2
  mkdir -p "$partial"
  (cd "$partial" && apt-get download -q "$@" "$package" && dpkg -x "$package"_*.deb . && rm "$package"_*.deb) &&
    mv -T "$partial" "$directory"
}

need_data()
{
  local archive=/usr/share/doc/libcgal-dev/data.tar.gz partial=$cache/partial.$$
  [ -z "${CGAL_DATA_DIR:-}" ] || return 0
  export CGAL_DATA_DIR=$cache/data
  [ ! -d "$CGAL_DATA_DIR" ] || return 0
  mkdir -p "$partial"
  if [ ! -f "$archive" ]; then
    # unpacked rather than installed: an installation may leave out /usr/share/doc
    echo "Getting CGAL's demo data, 24 MB, for $CGAL_DATA_DIR"
    apt-cache show libcgal-demo > /dev/null 2>&1 || quietly as_root apt-get update
    quietly unpack "$partial/demo" libcgal-demo
    archive=$partial/demo$archive
  fi
  tar -xzf "$archive" -C "$partial"
  mv -T "$partial/data" "$CGAL_DATA_DIR"
  rm -r "$partial"
}

need_CGAL_of()
{
  local suite=$1 directory=$cache/CGAL-$1 mirror keys=/usr/share/keyrings/debian-archive-keyring.gpg apt apt_options
  if [ ! -d "$directory" ]; then
    # the mirror that the system uses
    # shellcheck disable=SC1091,SC2016
    mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Component: main' \
               "Release: $(. /etc/os-release && echo "${VERSION_CODENAME:-}")" 2> /dev/null | head -n 1)
    [ -n "$mirror" ] || return
    apt=$(mktemp -d)
    mkdir -p "$apt/lists/partial" "$apt/cache/archives/partial"
    echo "deb [signed-by=$keys] $mirror $suite main" > "$apt/sources.list"
    apt_options=(-o Dir::State="$apt" -o Dir::State::status=/var/lib/dpkg/status -o Dir::Cache="$apt/cache"
                 -o Dir::Etc::sourcelist="$apt/sources.list" -o Dir::Etc::sourceparts=/dev/null)
    mkdir -p "$cache"
    apt-get -q "${apt_options[@]}" update > "$apt/log" 2>&1 < /dev/null &&
      unpack "$directory" libcgal-dev "${apt_options[@]}" > "$apt/log" 2>&1 < /dev/null
    rm -r "$apt"
  fi
  CGAL_DIR=$(dirname "$(find "$directory" -name CGALConfig.cmake 2> /dev/null | head -n 1)")
  [ -f "$CGAL_DIR/CGALConfig.cmake" ] || return
  export CGAL_DIR
  build_dir=$root/build-CGAL-$suite
}

configure()
{
  cmake -S "$root" -B "$build_dir" -DCMAKE_BUILD_TYPE=Release ${CGAL_DATA_DIR:+-DCGAL_DATA_DIR="$CGAL_DATA_DIR"} "$@"
}
