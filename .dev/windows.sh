# shellcheck shell=bash
# Windows' programs, by mingw: their build, their tests in Wine, and the zip.

windows_name() { printf 'talus-%s-windows-x86_64' "$(package_version)"; }

# For games: libtalus, talus-gen and talus-client.
package_windows() {
  local name component
  name="$(windows_name)"
  deps build cross
  aloud "building libraries for Windows" .dev/windows_libraries.sh build/windows-libraries
  build windows -- talus-gen talus-client talus_c
  mkdir -p out/packages
  rm -rf "out/packages/$name" "out/packages/$name.zip"
  for component in c_api windows; do
    cmake --install build/windows --strip --component "$component" --prefix "out/packages/$name" >&2
  done
  cat >"out/packages/$name/README.txt" <<TEXT
Talus $(package_version): libtalus for games, talus-gen and talus-client, for Windows 10 of 2019 and later (64 bits).

    bin\talus-gen map --center 0,0 --size 512,512 -o map.png
    bin\talus-client --connect HOST:4780 map --size 512,512 -o map.png

include\talus.h documents every function of libtalus; share\talus has bindings for C#, LuaJIT, Python and Rust.
share\talus\examples has one program in four languages: fly.c, Fly.cs, fly.lua, fly.py.

    gcc -I include share\talus\examples\fly.c lib\libtalus.dll.a -o bin\fly.exe
    csc /platform:x64 /out:bin\fly_cs.exe share\talus\examples\Fly.cs share\talus\bindings\Talus*.cs
    copy bin\talus.dll share\talus\examples
    luajit share\talus\examples\fly.lua
    python share\talus\examples\fly.py

Visual C++ makes its import library by  lib /def:lib\talus.def /machine:x64 /out:talus.lib
The Rust crate finds the folder lib by TALUS_LIB_DIR. Python programs want the wheel; ctypes is for those without numpy.
Put bin\talus.dll beside your game: it needs no DLL but Windows' own. licences has the licences of the libraries inside.
TEXT
  (cd out/packages && cmake -E tar cf "$name.zip" --format=zip "$name")
  rm -r "out/packages/$name"
}

test_windows() {
  deps build test cross
  build release -DTALUS_TESTS=ON -- talusd talus-client talus-gen talus_fly talus_game
  package_windows
  python3 -B tests/machines/windows.py "out/packages/$(windows_name).zip"
}
