# shellcheck shell=bash
# Windows' programs, by mingw: their build, their tests in Wine, and the zip.

build_windows() {
  deps build cross
  aloud "building libraries for Windows" .dev/windows_libraries.sh build/windows-libraries
  build windows -- "$@"
}

# package_windows: out/packages/talus-VERSION-windows-x86_64.zip, whose path it prints.
package_windows() {
  local name
  name="talus-$(sed -nE 's/^project\(talus VERSION ([0-9.]+).*/\1/p' CMakeLists.txt)-windows-x86_64"
  build_windows talus-gen talus-client talus_c
  mkdir -p out/packages
  rm -rf "out/packages/$name" "out/packages/$name.zip"
  local component
  for component in c_api windows; do
    cmake --install build/windows --strip --component "$component" --prefix "out/packages/$name" >&2
  done
  (cd out/packages && cmake -E tar cf "$name.zip" --format=zip "$name")
  rm -r "out/packages/$name"
  printf '%s\n' "out/packages/$name.zip"
}

test_windows() {
  local zip
  deps build test cross
  build release -DTALUS_TESTS=ON -- talusd talus-client talus-gen talus_fly talus_game
  zip="$(package_windows)"
  build_windows talus_fly talus_game
  python3 -B tests/machines/windows.py --zip "$zip"
}
