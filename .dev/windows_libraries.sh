#!/usr/bin/env bash
# windows_libraries.sh FOLDER: OpenSSL, libpng and zstd for Windows, static, in FOLDER, built by mingw from Debian's source
# packages with Debian's patches: of the versions that this machine's own programs link, or, if the mirror lacks the sources of
# such a version, of the newest before it. Libraries that are there already are kept until this machine's version changes.
set -euo pipefail
: "${1:?usage: windows_libraries.sh FOLDER}"
mkdir -p "$1/source/apt/lists/partial" "$1/source/apt/archives/partial"
into="$(cd "$1" && pwd)"
jobs="${JOBS:-$(nproc)}"
toolchain="$(cd "$(dirname "$0")/../.cmake" && pwd)/cross.cmake"
prefix=x86_64-w64-mingw32
launcher="${CMAKE_C_COMPILER_LAUNCHER:-}"

# apt for sources alone, from this machine's mirrors, with lists of its own.
apt_options=(-q -o "Dir::Etc::SourceList=$into/source/apt/sources.list" -o Dir::Etc::SourceParts=- -o "Dir::State::Lists=$into/source/apt/lists"
  -o "Dir::Cache=$into/source/apt" -o APT::Sandbox::User=root)

list_sources() {
  local list="$into/source/apt/sources.list" key=/usr/share/keyrings/debian-archive-keyring.gpg
  [[ ! -s "$list" ]] || return 0
  # shellcheck disable=SC2016 # apt's own variables
  apt-get indextargets --format "deb-src [signed-by=$key] \$(REPO_URI) \$(RELEASE) \$(COMPONENT)" 'Created-By: Packages' 'Origin: Debian' |
    sort -u >"$list"
  [[ -s "$list" ]] || { echo "apt has no lists of Debian's packages; apt-get update fetches them" >&2; return 1; }
  apt-get "${apt_options[@]}" update || { rm "$list"; return 1; }
}

# unpack SOURCE VERSION FOLDER: sets `unpacked` to the version whose patched sources are in FOLDER afterwards.
unpack() {
  local version
  list_sources
  cd "$into/source"
  for version in "$2" $(apt-cache "${apt_options[@]}" showsrc "$1" | sed -n 's/^Version: //p' | sort -Vru); do
    dpkg --compare-versions "$version" le "$2" || continue
    apt-get "${apt_options[@]}" source --download-only "$1=$version" || continue
    dpkg-source --no-check -x "$1_${version#*:}.dsc" "$3"
    unpacked="$version"
    return
  done
  echo "the mirror has no sources of $1 $2 or older" >&2
  return 1
}

build_openssl() {
  mkdir "$2"
  cd "$2"
  # It reads no configuration: that could be in a folder which any user may create (CVE-2019-1552).
  CC="$launcher $prefix-gcc-posix" AR="$prefix-ar" RANLIB="$prefix-ranlib" WINDRES="$prefix-windres" "$1/Configure" mingw64 \
    --prefix="$into" --libdir=lib --openssldir="C:/Program Files/Common Files/SSL" \
    no-shared no-tests no-module no-engine no-legacy no-autoload-config
  make -s -j "$jobs" build_libs
  make -s install_dev
}

# by_cmake SOURCES BUILD OPTION...
by_cmake() {
  cmake -G Ninja -S "$1" -B "$2" -DCMAKE_TOOLCHAIN_FILE="$toolchain" -DTALUS_TARGET=windows -DTALUS_ROOT="$into" \
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$into" -DCMAKE_INSTALL_LIBDIR=lib "${@:3}"
  cmake --build "$2" -j "$jobs"
  cmake --install "$2"
}

build_libpng1.6() { by_cmake "$1" "$2" -DPNG_SHARED=OFF -DPNG_TESTS=OFF -DPNG_EXECUTABLES=OFF; }

build_libzstd() { by_cmake "$1/build/cmake" "$2" -DZSTD_BUILD_PROGRAMS=OFF -DZSTD_BUILD_SHARED=OFF -DZSTD_LEGACY_SUPPORT=OFF; }

make_library() {
  unpack "$1" "$2" "$into/source/$1"
  "build_$1" "$into/source/$1" "$into/source/build-$1"
  printf '%s %s\n' "$2" "$unpacked" >"$into/$1.version"
}

for package in libssl-dev libpng-dev libzstd-dev; do
  read -r source version < <(dpkg-query -W -f '${source:Package} ${source:Version}\n' "$package")
  if [[ "$(cut -d ' ' -f 1 "$into/$source.version" 2>/dev/null)" != "$version" ]]; then
    rm -rf "$into/source/$source" "$into/source/build-$source"
    printf 'building %s for Windows\n' "$source"
    # By itself: errexit holds in no function that is part of a condition.
    set +e
    (set -e; make_library "$source" "$version") >"$into/$source.log" 2>&1
    status=$?
    set -e
    if ((status)); then
      tail -n 40 "$into/$source.log" >&2
      printf '%s cannot be built for Windows; all that was printed is in %s\n' "$source" "$into/$source.log" >&2
      exit 1
    fi
    rm -rf "$into/source/$source" "$into/source/build-$source"
  fi
  read -r _ unpacked <"$into/$source.version"
  [[ "$unpacked" == "$version" ]] || printf '%s for Windows is %s: the mirror has no sources of %s\n' "$source" "$unpacked" "$version"
done
