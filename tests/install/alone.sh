#!/usr/bin/env bash
# alone.sh: as root, builds the preset sdk in a bare Debian 12 that has the packages of ./dev deps sdk and no others, and programs in
# C and C++ by what it installs; then the same without TLS and OpenSSL. What was printed stays in out/sdk-alone.log.
set -euo pipefail
cd "$(dirname "$0")/../.."
die() { printf 'alone: %s\n' "$*" >&2; exit 1; }
source tests/bare_debian.sh
((EUID == 0)) || die "needs root, for a root of its own"
mkdir -p out
root="$PWD/out/sdk-alone" log="$PWD/out/sdk-alone.log"
trap 'rm -rf --one-file-system "$root"' EXIT
bare_debian "$root" "$log"
packages="$(awk '$1 == "sdk:" { $1 = ""; print }' docker/packages.txt)"
version="$(sed -nE 's/^project\(talus VERSION ([0-9]+\.[0-9]+).*/\1/p' CMakeLists.txt)"
mkdir "$root/talus"
tar --exclude=./build --exclude=./out --exclude=./.git --exclude=node_modules -c . | tar -C "$root/talus" -x

in_root "$root" "set -euo pipefail
export LC_ALL=C DEBIAN_FRONTEND=noninteractive PATH=/usr/sbin:/usr/bin:/sbin:/bin PKG_CONFIG_PATH=/opt/talus/lib/pkgconfig LD_LIBRARY_PATH=/opt/talus/lib
apt-get update -qq
apt-get install -y -q --no-install-recommends $packages
cd /talus
use() {
  rm -rf build /opt/talus
  cmake --preset sdk \"\$@\"
  cmake --build --preset sdk -j ${JOBS:-$(nproc)}
  cmake --install build/sdk --prefix /opt/talus
  cmake -S tests/install/consumer -B build/consumer -G Ninja -DCMAKE_PREFIX_PATH=/opt/talus -DTALUS_WANTED=$version
  cmake --build build/consumer
  build/consumer/consumer
  gcc client_sample/c_api/examples/fly.c -o build/fly \$(pkg-config --cflags --libs talus)
  ! build/fly 127.0.0.1 1 2>build/said || exit 1
  grep -x '127.0.0.1:1: no server answers there: Connection refused' build/said
}
use
apt-get purge -y -q libssl-dev
use -DTALUS_TLS=OFF
test -s build/sdk/client_sample/c_api/libtalus.so
! readelf -d build/sdk/client_sample/c_api/libtalus.so | grep -E 'ssl|crypto'" >>"$log" 2>&1 ||
  { tail -n 20 "$log" >&2; die "it failed; all it said: $log"; }
printf 'the client libraries were built alone, with and without TLS\n'
