# shellcheck shell=bash
# Windows' programs, by mingw: their build, their tests in Wine, and the zip.

build_windows() {
  deps build cross
  aloud "building libraries for Windows" .dev/windows_libraries.sh build/windows-libraries
  build windows -- "$@"
}

windows_name() { printf 'talus-%s-windows-x86_64' "$(package_version)"; }

# For games: libtalus, talus-gen and talus-client.
package_windows() {
  local name
  name="$(windows_name)"
  build_windows talus-gen talus-client talus_c
  mkdir -p out/packages
  rm -rf "out/packages/$name" "out/packages/$name.zip"
  local component
  for component in c_api windows; do
    cmake --install build/windows --strip --component "$component" --prefix "out/packages/$name" >&2
  done
  (cd out/packages && cmake -E tar cf "$name.zip" --format=zip "$name")
  rm -r "out/packages/$name"
}

test_windows() {
  deps build test cross
  build release -DTALUS_TESTS=ON -- talusd talus-client talus-gen talus_fly talus_game
  package_windows
  build_windows talus_fly talus_game
  python3 -B tests/machines/windows.py --zip "out/packages/$(windows_name).zip"
}
