#!/usr/bin/env bash
# sdk.sh PACKAGES TALUSD: unpacks the SDK in a new folder, compiles its examples in C (by pkg-config) and in C++ (by CMake),
# and runs them against talusd. As root, for a network of its own: game.cpp takes the port that talusd has by default.
set -euo pipefail
source "$(dirname "$0")/common.sh"
sdk="$(realpath "$(only_one "$1/talus-sdk-*.tar.gz")")" talusd="$(realpath "$2")"
scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
tar -xzf "$sdk" --strip-components=1 --one-top-level=sdk
# Where it was made is nothing to it.
! grep -rIl "$(dirname "$talusd")" sdk || die "it names the folder in which it was built"

export PKG_CONFIG_PATH="$scratch/sdk/lib/pkgconfig"
read -ra flags <<<"$(pkg-config --cflags --libs talus)"
gcc -std=c99 -Wall -Wextra -pedantic -Werror sdk/examples/fly.c -o fly "${flags[@]}"
mkdir game
cp sdk/examples/game.cpp game/
cat >game/CMakeLists.txt <<'CMAKE'
cmake_minimum_required(VERSION 3.25)
project(game LANGUAGES CXX)
find_package(talus REQUIRED)
add_executable(game game.cpp)
target_link_libraries(game PRIVATE talus::client)
CMAKE
cmake -S game -B game/build -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$scratch/sdk" >configure.log || { cat configure.log; die "find_package failed"; }
cmake --build game/build >build.log || { cat build.log; die "game.cpp does not compile"; }

export -f wait_for_line die
own_network bash -euo pipefail -c '
  "$1" >talusd.log 2>&1 &
  server=$!
  wait_for_line talusd.log "listening on" $server
  LD_LIBRARY_PATH=sdk/lib timeout 120 ./fly
  timeout 120 game/build/game
  kill $server
  wait $server' sdk "$talusd" >said
grep -q '^ground at spawn: ' said && grep -qE '^[1-9][0-9]* chunks, [1-9][0-9]* bytes received$' said || { cat said; die "the examples did not run"; }
say "$(basename "$sdk"): C by pkg-config, C++ by CMake"
cat said
