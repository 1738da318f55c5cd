# shellcheck shell=bash
# ./dev package: what people take who do not compile. Everything goes to out/packages.

package_kinds=(deb portable sdk npm wheel crate arm64 image windows)
package_usual=("${package_kinds[@]:0:6}")
package_programs=(talusd talus-gen talus-client talus-load talus_c talus_local_c talus_viewer)

# package [--uncommitted] [KIND...]
package() {
  local kinds=() uncommitted=0 kind changed
  while (($#)); do
    if [[ "$1" == --uncommitted ]]; then
      uncommitted=1
    elif [[ " ${package_kinds[*]} " == *" $1 "* ]]; then
      kinds+=("$1")
    else
      wrong_use "package: '$1' is not --uncommitted or a kind of package; there are ${package_kinds[*]}"
    fi
    shift
  done
  ((${#kinds[@]})) || kinds=("${package_usual[@]}")
  if ((!uncommitted)) && [[ -e .git ]]; then
    changed="$(git status --porcelain | head -n 1)"
    # --version would name a commit that the package is not.
    [[ -z "$changed" ]] || die "package: '${changed:3}' is not committed; commit it, or package it by --uncommitted"
  fi
  mkdir -p out/packages
  for kind in "${kinds[@]}"; do stage "packaging $kind" "package_$kind"; done
  (cd out/packages && find . -maxdepth 1 -type f ! -name SHA256SUMS -printf '%P\n' | sort | xargs -d '\n' sha256sum >SHA256SUMS &&
    find . -maxdepth 1 -type f -printf '%10s  out/packages/%P\n' | sort -k 2)
}

package_version() { sed -nE 's/^project\(talus VERSION ([0-9.]+).*/\1/p' CMakeLists.txt; }

# built_programs: what the tests of ./dev test ran is what is packaged.
built_programs() {
  deps build test package
  build release -DTALUS_TESTS=ON -- "${package_programs[@]}" "$@"
}

# debs PRESET ARCHITECTURE [cpack option...]
debs() {
  local preset="$1" architecture="$2" made="build/$1/debs"
  shift 2
  rm -rf "$made" out/packages/*_"$architecture".deb
  cpack --config "build/$preset/CPackConfig.cmake" -G DEB -B "$made" "$@" >"build/$preset/cpack.log" 2>&1 ||
    { tail -n 20 "build/$preset/cpack.log" >&2; die "cpack failed; all it said: build/$preset/cpack.log"; }
  mv "$made"/*.deb out/packages/
}

package_deb() {
  built_programs talus_manuals
  debs release "$(dpkg --print-architecture)"
}

# By the cross compiler. What packages of this machine depend on, those of arm64 do: both are of one Debian.
package_arm64() {
  local here package depends=()
  here="$(dpkg --print-architecture)"
  deps aarch machines
  package_deb
  foreign_root arm64
  build aarch64 -DTALUS_MANUALS="$PWD/build/release/manuals" -- "${package_programs[@]}"
  for package in talusd talus-tools libtalus1 libtalus-local1; do
    depends+=(-D "CPACK_DEBIAN_${package^^}_PACKAGE_DEPENDS=$(dpkg-deb -f "out/packages/${package}_$(package_version)_$here.deb" Depends)")
  done
  debs aarch64 arm64 "${depends[@]}"
}

# docker/Dockerfile by buildah, on a Debian 12 that debootstrap makes as this machine's apt has it: no registry is asked. In
# Docker's format, as OCI's has no health check.
package_image() {
  local out="$PWD/out/image" archive base=docker.io/library/debian:12-slim scratch
  ((EUID == 0)) || die "package: the image needs root, for debootstrap and chroot"
  deps containers
  archive="out/packages/talus-image-$(package_version)-linux-$(uname -m).tar"
  rm -rf --one-file-system "$out/root" "$out/context" "$archive.gz"
  # What the repository has, and its commit.
  mkdir -p "$out/context"
  tracked '*' | tar -c --ignore-failed-read -T - | tar -x -C "$out/context"
  [[ ! -e .git ]] || git rev-parse HEAD >"$out/context/.cmake/build_version/commit.txt"
  # What is given away has Debian's newest packages: neither base nor layers of an earlier build.
  ((uncommitted)) || own_buildah rmi --all --force >/dev/null
  # The base under the name that the Dockerfile asks for.
  if ! own_buildah inspect --type image "$base" >/dev/null 2>&1; then
    source tests/bare_debian.sh
    aloud "making a bare Debian 12" bare_debian "$out/root" "$out/debootstrap.log"
    rm -rf "$out/root/var/cache/apt"/{archives/*.deb,*.bin} "$out/root/var/lib/apt/lists"/*
    scratch="$(own_buildah from scratch)"
    own_buildah add --quiet "$scratch" "$out/root" / >/dev/null
    own_buildah commit --quiet --rm "$scratch" "$base" >/dev/null
    rm -rf --one-file-system "$out/root"
  fi
  aloud "building the image" own_buildah bud --isolation chroot --pull-never --layers --format docker \
    --ignorefile docker/Dockerfile.dockerignore -f docker/Dockerfile -t localhost/talus "$out/context"
  own_buildah push --quiet localhost/talus "docker-archive:$archive:talus:$(package_version)"
  gzip "$archive"
}

# own_buildah ...: with a store of its own. What else this machine has built stays as it is, and goes unused.
own_buildah() { buildah --root "$PWD/out/image/store" --runroot "$PWD/out/image/run" "$@"; }

# talusd and the tools with every library that they need, the C library and its loader included. Static they cannot be: not
# all of these libraries can, and a static C library would look up neither hosts nor users.
package_portable() {
  local name folder program library file package component
  name="talus-$(package_version)-linux-$(uname -m)"
  folder="build/portable/$name"
  built_programs
  rm -rf build/portable "out/packages/$name.tar.gz"
  for component in server tools worlds settings; do
    cmake --install build/release --prefix "$folder" --component "$component" --strip >>build/release/install.log
  done
  mkdir -p "$folder/lib/programs" "$folder/lib/loader" "$folder/share/licences"
  for program in talusd talus-gen talus-client talus-load; do
    mv "$folder/bin/$program" "$folder/lib/programs/"
    # Processes are named after it.
    ln -s ../ld-linux-x86-64.so.2 "$folder/lib/loader/$program"
    cat >"$folder/bin/$program" <<SCRIPT
#!/bin/sh
# $program by the loader and the libraries of this folder.
lib="\$(dirname "\$(dirname "\$(readlink -f "\$0")")")/lib"
exec "\$lib/loader/$program" --inhibit-cache --library-path "\$lib" --argv0 "\$0" "\$lib/programs/$program" "\$@"
SCRIPT
    chmod 755 "$folder/bin/$program"
  done
  for library in $(ldd "$folder"/lib/programs/* | sed -nE 's/.*(=> |^\t)(\/[^ ]+) .*/\2/p' | sort -u); do
    cp -L "$library" "$folder/lib/"
    file="$(readlink -f "$library")"
    # Debian's packages still have some in /lib.
    package="$({ dpkg -S "$file" || dpkg -S "${file#/usr}"; } 2>/dev/null | sed 's/:.*//')"
    cp -L "/usr/share/doc/$package/copyright" "$folder/share/licences/$package"
  done
  cp LICENSE "$folder/share/licences/talus"
  cat >"$folder/README" <<TEXT
Talus $(package_version): talusd, talus-gen, talus-client and talus-load for any Linux on x86-64 from 2018 on, with
all libraries that they need. Keep the folder together; link to bin/ from where you like.

    bin/talusd --http 127.0.0.1:4782 --web share/talus/web      # then open http://127.0.0.1:4782/
    bin/talus-gen map --center 0,0 --size 512,512 -o map.png

share/doc/talus has OPERATIONS.md; paths there that begin with /usr/local begin here. Hosts are looked up by /etc/hosts and
DNS: other services that /etc/nsswitch.conf may name are not asked. share/licences has the licences of the libraries.
TEXT
  tar -C build/portable --owner=0 --group=0 --sort=name -czf "out/packages/$name.tar.gz" "$name"
}

# For games: libtalus and the C++ client library, to be linked.
package_sdk() {
  local name component
  name="talus-sdk-$(package_version)-linux-$(uname -m)"
  built_programs
  rm -rf build/sdk-package "out/packages/$name.tar.gz"
  for component in sdk c_api; do
    cmake --install build/release --prefix "build/sdk-package/$name" --component "$component" --strip >>build/release/install.log
  done
  # Beside share/talus/bindings, where the examples look for them.
  cp -r client_sample/c_api/examples "build/sdk-package/$name/share/talus/"
  cp tests/install/consumer/game.cpp "build/sdk-package/$name/share/talus/examples/"
  cp LICENSE "build/sdk-package/$name/"
  cat >"build/sdk-package/$name/README.txt" <<TEXT
Talus $(package_version): libtalus, the client library in C, libtalus-local, worlds without a server in C, and the client library in C++, for games on Debian 12 (x86-64).

include/talus.h documents every function of libtalus. The examples fly around the spawn of a talusd on this machine. In
this folder:

    export PKG_CONFIG_PATH=\$PWD/lib/pkgconfig LD_LIBRARY_PATH=\$PWD/lib
    gcc -std=c99 share/talus/examples/fly.c -o fly \$(pkg-config --cflags --libs talus) && ./fly
    mcs share/talus/examples/Fly.cs share/talus/bindings/Talus*.cs -out:Fly.exe && mono Fly.exe
    luajit share/talus/examples/fly.lua
    python3 share/talus/examples/fly.py

share/talus/examples/single_player.c is a game without a server, by the library that pkg-config calls talus-local.

Rust: unpack the crate, talus-$(package_version).crate, beside this folder; its README.txt goes on.

C++: share/talus/examples/game.cpp, by CMake's find_package(talus) with this folder in CMAKE_PREFIX_PATH.

Python programs want the wheel, talus_client-$(package_version)-py3-none-any.whl, which needs no libtalus; ctypes is for those
without numpy.

At run time libtalus needs libssl3, libhwy1, libxxhash0 and libstdc++6, libtalus-local libpng16-16, libsqlite3-0,
libtomlplusplus3, libxxhash0 and libstdc++6. A game may ship it as libtalus.so with these in
one folder: it searches its own first.
TEXT
  tar -C build/sdk-package --owner=0 --group=0 --sort=name -czf "out/packages/$name.tar.gz" "$name"
}

package_npm() {
  node_tools
  (cd client_sample/web/talus-js && npm ci --ignore-scripts --no-audit --no-fund --loglevel error >&2 &&
    npm pack --silent --pack-destination "$OLDPWD/out/packages" >&2)
}

# It is Python alone: one wheel for every machine. From a copy, as building leaves files beside the source.
package_wheel() {
  deps wheel
  rm -rf build/wheel
  mkdir -p build/wheel
  cp -r client_sample/python build/wheel/source
  /usr/bin/python3 -m venv build/wheel/venv
  aloud "making the wheel" build/wheel/venv/bin/pip wheel --quiet --disable-pip-version-check --no-deps -w out/packages build/wheel/source
}

# From a copy, as cargo writes beside the source. It compiles what it packs, against the libtalus of this build.
package_crate() {
  command -v cargo >/dev/null || deps rust
  built_programs
  rm -rf build/crate out/packages/talus-*.crate
  cmake --install build/release --prefix "$PWD/build/crate/installed" --component c_api >>build/release/install.log
  cp -r client_sample/rust build/crate/source
  cp LICENSE build/crate/source/
  (cd build/crate/source && PKG_CONFIG_PATH="$OLDPWD/build/crate/installed/lib/pkgconfig" \
    cargo package --quiet --offline --allow-dirty --target-dir ../target >&2)
  cp "build/crate/target/package/talus-$(package_version).crate" out/packages/
}
