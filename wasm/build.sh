#!/bin/sh
# Makes the npm package, build/wasm/package, by the Emscripten of Debian 13: that of this system where it has one, else
# that of a bare Debian 13 under build/debian-13, which debootstrap makes there (3 GB), for it does not install on an older
# one. The compiler of Debian 12 has no std::ranges. The sources are copied into the other system and the package out of
# it: nothing is mounted, so that whoever removes build removes nothing else.
set -eu
cd "$(dirname "$0")/.."

packages="cmake emscripten libeigen3-dev make nlohmann-json3-dev"
sources="CMakeLists.txt CMakePresets.json LICENSE cpp licenses wasm"
build='emcmake cmake --preset wasm && cmake --build --preset wasm --parallel "$(nproc)"'
oldest=3.1.69
system=build/debian-13

is_recent() { # [of a version of Emscripten, which Debian writes with more behind it]
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

debian_mirror() { # print the mirror that apt takes Debian's packages from: apt reads both formats of its sources
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
  cp -a $sources "$inside/" # with their times: what is compiled and has not changed stays
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
