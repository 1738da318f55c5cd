#!/usr/bin/env bash
# How long a stranger waits for the first picture: makes a bare Debian 12 in out/first_picture, fills its apt cache, and
# runs ./dev run 5 of a fresh clone there under a clock. The clone is of HEAD: what is not committed is not measured.
set -euo pipefail
cd "$(dirname "$0")/../.."
source tests/bare_debian.sh

die() { printf 'first-picture: %s\n' "$*" >&2; exit 1; }
say() { printf '\033[1m==> %s\033[0m\n' "$*" >&2; }

((EUID == 0)) || die "needs root, for chroot and mounts of its own; try: sudo ./dev first-picture"
for program in debootstrap unshare git; do
  command -v "$program" >/dev/null || die "needs $program; ./dev deps image installs debootstrap"
done
unshare --mount true 2>/dev/null || die "this machine lets nobody mount, not even root; run it outside the container"

out="$PWD/out/first_picture"
root="$out/root"
mkdir -p "$out/packages"
exec 9>"$out/lock"
flock -n 9 || die "another one runs in this folder"
# Mounts are in a namespace that ends with its process: what is left is plain files.
trap 'rm -rf --one-file-system "$root"' EXIT
rm -rf --one-file-system "$root"

say "making a bare Debian 12"
bare_debian "$root" "$out/debootstrap.log" --cache-dir="$out/packages"
[[ ! -d /etc/apt/auth.conf.d ]] || cp -r /etc/apt/auth.conf.d "$root/etc/apt/"
cp "$out/packages"/*.deb "$root/var/cache/apt/archives/" 2>/dev/null || true

say "filling its apt cache"
git clone -q --no-hardlinks . "$root/talus"
in_root "$root" 'apt-get update -qq && cd /talus &&
  apt-get install -d -y -qq --no-install-recommends $(sed -n "s/^build: //p" docker/packages.txt) >/dev/null' ||
  die "the new root could not fetch packages"
cp "$root"/var/cache/apt/archives/*.deb "$out/packages/"
packages="$(in_root "$root" 'cd /talus && apt-get install -s --no-install-recommends $(sed -n "s/^build: //p" docker/packages.txt)' | grep -c '^Inst')"

say "./dev run 5, with $packages packages to install, on $(nproc) cores at a load of $(cut -d ' ' -f 1 /proc/loadavg)"
# When the reader ends, its namespace and the server in it do.
in_root "$root" 'cd /talus && while IFS= read -r line; do
    printf "%s\n" "$line"
    [[ "$line" != *"Ctrl-C stops it"* ]] || exit 0
  done < <(TALUS_LISTEN=127.0.0.1:0 ./dev run 5 2>&1)
  exit 1' >"$out/run.log" 2>&1 ||
  { tail -n 20 "$out/run.log" >&2; die "./dev run failed; all it said: $out/run.log"; }
cp "$root/talus/out/view.png" "$root/talus/out/map.png" "$out/"
say "what the client saw: $out/view.png"
grep '^first picture after' "$out/run.log"
