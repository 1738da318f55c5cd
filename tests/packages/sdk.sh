#!/usr/bin/env bash
# sdk.sh PACKAGES TALUSD: unpacks the SDK in a new folder, compiles its examples in C (by pkg-config), in C++ (by CMake) and in C#
# (with Mono), and runs them against talusd, and those for Python and LuaJIT. As root, for a network of its own: game.cpp takes the
# port that talusd has by default.
set -euo pipefail
source "$(dirname "$0")/common.sh"
sdk="$(realpath "$(only_one "$1/talus-sdk-*.tar.gz")")" talusd="$(realpath "$2")"
tests="$(realpath "$(dirname "$0")/../bindings")"
command -v mcs >/dev/null || die "needs Mono's C# compiler; ./dev deps bindings installs it"
scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
tar -xzf "$sdk" --strip-components=1 --one-top-level=sdk
# Where it was made is nothing to it.
! grep -rIl "$(dirname "$talusd")" sdk || die "it names the folder in which it was built"
examples=sdk/share/talus/examples bindings=sdk/share/talus/bindings

export PKG_CONFIG_PATH="$scratch/sdk/lib/pkgconfig"
read -ra flags <<<"$(pkg-config --cflags --libs talus)"
gcc -std=c99 -Wall -Wextra -pedantic -Werror $examples/fly.c -o fly "${flags[@]}"
read -ra local_flags <<<"$(pkg-config --cflags --libs talus-local)"
gcc -std=c99 -Wall -Wextra -pedantic -Werror $examples/single_player.c -o single_player "${local_flags[@]}"
LD_LIBRARY_PATH=sdk/lib ./single_player game.talus
mcs -langversion:7 -warnaserror $examples/Fly.cs $bindings/Talus*.cs -out:Fly.exe
said="$(mono Fly.exe 2>&1)" && die "Fly.exe ran without libtalus"
[[ "$said" == "libtalus is not found: copy libtalus.so "* && "$said" != *$'\n'* ]] || die "without libtalus Fly.exe said: $said"
mcs -langversion:7 -warnaserror "$tests/Dig.cs" $bindings/Talus*.cs -out:Dig.exe
mcs -langversion:7 -warnaserror "$tests/Fields.cs" $bindings/Talus*.cs -out:Fields.exe
mono --debug Fields.exe || die "a class in C# has other values than its struct"
mcs -langversion:7 -warnaserror "$tests/Owners.cs" $bindings/Talus*.cs -out:Owners.exe
mkdir counting
gcc -shared -fPIC -Wall -Wextra -Werror "$tests/owners.c" -o counting/libtalus.so -Wl,--no-as-needed "${flags[@]}"
mkdir game
cp $examples/game.cpp game/
cat >game/CMakeLists.txt <<'CMAKE'
cmake_minimum_required(VERSION 3.25)
project(game LANGUAGES CXX)
find_package(talus REQUIRED)
add_executable(game game.cpp)
target_link_libraries(game PRIVATE talus::client)
CMAKE
cmake -S game -B game/build -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$scratch/sdk" >configure.log || { cat configure.log; die "find_package failed"; }
cmake --build game/build >build.log || { cat build.log; die "game.cpp does not compile"; }

# C# and cffi lay structs out as C does.
python3 -B "$tests/layout.py" c >layout.c
gcc layout.c -o layout "${flags[@]}"
python3 -B "$tests/layout.py" csharp >Layout.cs
mcs -unsafe -warnaserror Layout.cs $bindings/Talus.cs -out:Layout.exe
cmp <(./layout) <(mono Layout.exe) || die "C# lays out otherwise than C"
python3 -B "$tests/layout.py" cffi >layout.py
cmp <(./layout) <(/usr/bin/python3 layout.py $bindings/talus.cdef.h) || die "cffi lays out otherwise than C"

export -f wait_for_line die end
own_network bash -euo pipefail -c '
  export LD_LIBRARY_PATH=sdk/lib
  TALUS_ACCESS_WITHOUT_TOKEN=read,edit "$1" --data data >talusd.log 2>&1 &
  server=$!
  trap "end $server" EXIT
  wait_for_line talusd.log "listening on" $server
  timeout 120 ./fly | tee said
  cmp <(cat said said said said) <(cd sdk && sed -n "s/^    //p" README.txt | timeout 300 bash -euo pipefail) ||
    die "what README.txt says does not work: C, C#, LuaJIT, Python"
  PYTHONPATH=$3 timeout 120 python3 -B "$2/dig.py" 4780 >dug
  cmp dug <(timeout 120 mono Dig.exe 4780) || die "C# digs otherwise than Python"
  LD_LIBRARY_PATH=counting:sdk/lib timeout 120 mono --debug Owners.exe 4780 || die "C# leaks, or frees twice"
  timeout 120 game/build/game | tee -a said
  trap - EXIT
  kill $server
  wait $server' sdk "$talusd" "$tests" $bindings
grep -q '^ground at spawn: ' said && grep -qE '^[1-9][0-9]* chunks, [1-9][0-9]* bytes received$' said || die "the examples did not run"
say "$(basename "$sdk"): C by pkg-config, C++ by CMake, C# with Mono, Python, LuaJIT"
