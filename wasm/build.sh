#!/bin/sh
# Builds the npm package, build/wasm/package, with Emscripten 3.1.69 (Debian 13) or later. If this system neither has
# nor offers it, the script creates a minimal Debian 13 in build/debian-13 with debootstrap (3 GB), because this
# Emscripten does not install on an older Debian. The Emscripten of Debian 12 lacks std::ranges. The script copies the
# sources into that system and the package out of it. It mounts nothing, so that removing build/ removes nothing else.
set -eu
cd "$(dirname "$0")/.."

packages="cmake emscripten libeigen3-dev make nlohmann-json3-dev"
sources="CMakeLists.txt CMakePresets.json LICENSE cpp licenses wasm"
build='emcmake cmake --preset wasm && cmake --build --preset wasm --parallel "$(nproc)"'
oldest=3.1.69
system=build/debian-13

is_recent() { # whether a version of Emscripten, without the suffix of Debian, is at least $oldest; empty: no
  [ -n "$1" ] && [ "$(printf '%s\n' "$oldest" "$1" | sort -V | head -n 1)" = "$oldest" ]
}

install() {
  [ "$(id -u)" = 0 ] || {
    echo "make wasm needs root to install $* by apt, or Emscripten $oldest or later on the PATH" >&2
    exit 1
  }
  apt-get update -q
  DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "$@"
}

debian_mirror() { # print the mirror from which apt gets Debian's packages; apt reads both formats of source lists
  apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Origin: Debian' 'Label: Debian' | head -n 1
}

in_system() { DEBIAN_FRONTEND=noninteractive LC_ALL=C chroot "$system" "$@"; }

make_system() {
  install debootstrap
  rm -rf "$system"
  mirror=${MIRROR:-$(debian_mirror)}
  [ -n "$mirror" ] || { echo "make wasm found no mirror of Debian in the apt sources; give one as MIRROR=..." >&2; exit 1; }
  debootstrap --variant=minbase --include=ca-certificates trixie "$system" "$mirror"
  cp -L /etc/resolv.conf "$system/etc/"
  cp -L /etc/apt/apt.conf.d/*proxy* "$system/etc/apt/apt.conf.d/" 2>/dev/null || true
  in_system apt-get update -q
  # shellcheck disable=SC2086  # names of packages
  in_system apt-get install -q -y --no-install-recommends $packages
  touch "$system/.ready"
}

build_in_system() {
  inside=$system/viscoroll
  mkdir -p "$inside/build"
  for name in $sources; do rm -rf "${inside:?}/$name"; done
  # shellcheck disable=SC2086  # names of files
  cp -a $sources "$inside/" # with modification times: unchanged files are not compiled again
  cp -a build/headers "$inside/build/"
  in_system sh -c "cd /viscoroll && $build"
  rm -rf build/wasm/package
  mkdir -p build/wasm
  cp -a "$inside/build/wasm/package" build/wasm/
}

found=$(em++ -dumpversion 2>/dev/null || true)
offered=$(apt-cache show emscripten 2>/dev/null | sed -n 's/^Version: \([0-9.]*\).*/\1/p' | head -n 1)
if is_recent "$found"; then
  sh -c "$build"
elif is_recent "$offered"; then
  # shellcheck disable=SC2086  # names of packages
  install $packages
  sh -c "$build"
elif [ "$(id -u)" = 0 ]; then
  [ -e "$system/.ready" ] || make_system
  build_in_system
else
  echo "make wasm needs root to make a Debian 13 in $system, or Emscripten $oldest or later on the PATH" >&2
  exit 1
fi
