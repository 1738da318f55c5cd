#!/usr/bin/env bash
# debs.sh PACKAGES ARCHITECTURE: as root, installs Debian's packages in a bare Debian 12 of that architecture, has talusd serve
# as its unit and its user do, compiles a C program, and purges them. Another architecture than this machine's runs in an
# emulator. Roots and what apt fetched stay in out/package-tests.
set -euo pipefail
cd "$(dirname "$0")/../.."
source tests/bare_debian.sh
source tests/packages/common.sh
packages="$(realpath "$1")" architecture="$2"
out="$PWD/out/package-tests"
root="$out/root-$architecture"
here="$(dpkg --print-architecture)"
mkdir -p "$out/archives-$architecture"
exec 9>"$out/lock-$architecture"
flock -n 9 || die "another one runs in this folder"
scratch="$(mktemp -d)"
trap 'rm -rf --one-file-system "$root" "$scratch"' EXIT

# in_foreign_root ROOT COMMAND: in_root for arm64. Where the kernel does not know its emulator, it learns it in a namespace of
# users (Linux 6.7), which leaves this machine's own settings alone. A root that is a dash: the command runs here, and may
# make one.
in_foreign_root() {
  # Flag F: opened when it was registered, it also runs where a chroot does not have it.
  if grep -qsx enabled /proc/sys/fs/binfmt_misc/qemu-aarch64 && grep -q '^flags:.*F' /proc/sys/fs/binfmt_misc/qemu-aarch64; then
    if [[ "$1" == - ]]; then bash -c "$2"; else in_root "$1" "$2"; fi
    return
  fi
  local namespace status=0
  mkfifo "$scratch/mapped"
  unshare --user --mount --pid --fork --kill-child bash -euc '
    read -r _ <"$3"
    mount -t binfmt_misc none /proc/sys/fs/binfmt_misc
    cat /usr/lib/binfmt.d/qemu-aarch64.conf >/proc/sys/fs/binfmt_misc/register
    [[ "$1" != - ]] || exec bash -c "$2"
    mount -t proc proc "$1/proc"
    mount --rbind /dev "$1/dev"
    exec chroot "$1" bash -c "$2"' in_foreign_root "$1" "$2" "$scratch/mapped" &
  namespace=$!
  until [[ "$(readlink "/proc/$namespace/ns/user")" != "$(readlink /proc/self/ns/user)" ]]; do sleep 0.01; done
  echo "0 0 65536" >"/proc/$namespace/uid_map"
  echo "0 0 65536" >"/proc/$namespace/gid_map"
  echo >"$scratch/mapped"
  wait "$namespace" || status=$?
  rm "$scratch/mapped"
  return "$status"
}

# within FAILURE COMMAND: in the root. What it prints is in out/package-tests/ARCHITECTURE.log.
log="$out/$architecture.log"
: >"$log"
run=in_root
[[ "$architecture" == "$here" ]] || run=in_foreign_root
environment="export LC_ALL=C DEBIAN_FRONTEND=noninteractive PATH=/usr/sbin:/usr/bin:/sbin:/bin"
within() {
  "${network[@]}" bash -euo pipefail -c "$(declare -f in_root in_foreign_root); scratch='$scratch'; $run \"\$@\"" within "$root" "$environment; $2" \
    >>"$log" 2>&1 || { tail -n 20 "$log" >&2; die "$1; all it said: $log"; }
}
network=()

base="$out/base-$architecture.tar"
if [[ ! -e "$base" ]]; then
  say "making a bare Debian 12 of $architecture"
  if [[ "$architecture" == "$here" ]]; then
    bare_debian "$root" "$log"
  else
    [[ "$architecture" == arm64 ]] || die "'$architecture' is neither $here nor arm64"
    rm -rf --one-file-system "$root"
    in_foreign_root - "mmdebstrap --quiet --mode=root --variant=minbase --architectures=$architecture bookworm '$root'" >"$log" 2>&1 ||
      { tail -n 5 "$log" >&2; die "mmdebstrap failed; all it said: $log"; }
    apt_as_here "$root"
  fi
  tar -C "$root" --one-file-system -cf "$base.new" .
  mv "$base.new" "$base"
fi
rm -rf --one-file-system "$root"
mkdir -p "$root/packages"
tar -C "$root" -xpf "$base"
cp "$out/archives-$architecture"/*.deb "$root/var/cache/apt/archives/" 2>/dev/null || true
for package in talusd talus-tools libtalus1 libtalus-local1 libtalus-dev; do
  cp "$(only_one "$packages/${package}_*_$architecture.deb")" "$root/packages/"
done

say "installing on $architecture what talusd and talus-tools depend on, and nothing more"
install="apt-get install -y -q --no-install-recommends"
within "apt does not install them" "apt-get update -qq && $install /packages/talusd_*.deb /packages/talus-tools_*.deb"
cp "$root"/var/cache/apt/archives/*.deb "$out/archives-$architecture/" 2>/dev/null || true
# Also without systemd the unit is enabled, for when there is one.
[[ -L "$root/etc/systemd/system/multi-user.target.wants/talusd.service" ]] || die "talusd.service is not enabled"
for page in man8/talusd.8 man1/talus-gen.1 man1/talus-client.1 man1/talus-load.1; do
  [[ "$(zcat "$root/usr/share/man/$page.gz")" == *".SH NAME"*".SH "* ]] || die "$page is no manual page"
done

say "a C program by libtalus-dev and pkg-config"
cp client_sample/c_api/examples/{fly,single_player}.c "$root/packages/"
compile="-std=c99 -Wall -Wextra -pedantic -Werror"
if [[ "$architecture" == "$here" ]]; then
  within "fly.c does not compile" "$install gcc libc6-dev pkg-config /packages/libtalus{1,-local1,-dev}_*.deb &&
    gcc $compile /packages/fly.c -o /packages/fly \$(pkg-config --cflags --libs talus) &&
    gcc $compile /packages/single_player.c -o /packages/single_player \$(pkg-config --cflags --libs talus-local) &&
    /packages/single_player /packages/game.talus"
  say "the unit, as systemd sees it"
  within "systemd finds fault with talusd.service" "$install systemd && systemd-analyze verify /lib/systemd/system/talusd.service &&
    systemd-analyze security --offline=true --threshold=15 talusd.service"
  grep 'Overall exposure level' "$log" >&2
else
  within "apt does not install them" "$install /packages/libtalus{1,-local1,-dev}_*.deb"
  # Compiled here: a compiler in an emulator takes minutes.
  read -ra flags <<<"$(PKG_CONFIG_LIBDIR="$root/usr/lib/pkgconfig" pkg-config --cflags --libs talus)"
  # shellcheck disable=SC2086
  aarch64-linux-gnu-gcc $compile client_sample/c_api/examples/fly.c -o "$root/packages/fly" "${flags[@]}" \
    -Wl,--unresolved-symbols=ignore-in-shared-libs || die "fly.c does not compile"
fi

say "talusd serves as its unit has it, a client connects"
commit="$(git rev-parse HEAD 2>/dev/null || true)"
cat >"$root/packages/use.sh" <<'SCRIPT'
set -euo pipefail
for program in talusd talus-gen talus-client talus-load; do
  said="$("$program" --version)"
  [[ "$said" == *"(${commit:0:8})"* ]] || { echo "$program --version: $said"; exit 1; }
done
# The commands of the unit, as its user, with its directory.
unit="$(sed -e ':a' -e '/\\$/N; s/\\\n//; ta' /lib/systemd/system/talusd.service)"
# field NAME: its words.
field() { sed -n "s/^$1=//p" <<<"$unit"; }
[[ "$(field User)" == talus && "$(field StateDirectory)" == talus && "$(stat -c '%U %a' /var/lib/talus)" == "talus 750" ]]
as_user=(setpriv --reuid="$(field User)" --regid="$(field User)" --init-groups --no-new-privs --inh-caps=-all)
umask "$(field UMask)"
"${as_user[@]}" $(field ExecStartPre)
: >/tmp/talusd.log
TALUS_ACCESS_WITHOUT_TOKEN=read,edit "${as_user[@]}" $(field ExecStart) >/tmp/talusd.log 2>&1 &
server=$!
until grep -q 'listening on' /tmp/talusd.log && grep -q '^HTTP and' /tmp/talusd.log; do
  kill -0 $server || { cat /tmp/talusd.log; exit 1; }
  sleep 0.05
done
[[ "$(stat -c %U /proc/$server)" == talus ]] || { echo "talusd runs as $(stat -c %U /proc/$server)"; exit 1; }
talus-client --connect localhost:4780 get 0 0 0 --timeout 120
talus-client --connect localhost:4780 edit --material planks -- 3,35,3
exec 8<>/dev/tcp/127.0.0.1/4782
printf 'GET / HTTP/1.0\r\nHost: localhost\r\n\r\n' >&8
page="$(tr -d '\0' <&8)"
[[ "$page" == "HTTP/1."*" 200"*"<html"* ]] || { echo "no viewer: ${page:0:200}"; exit 1; }
[[ ! -x /packages/fly ]] || /packages/fly
talus-gen map --center 0,0 --size 64,64 -o /tmp/map.png
[[ -s /tmp/map.png ]]
kill $server
wait $server
[[ -n "$(ls -A /var/lib/talus)" ]]
SCRIPT
network=(own_network)
export -f own_network
within "they do not work as installed" "commit=$commit bash /packages/use.sh"
network=()
sed -n '/^ground at spawn/,/^talusd /p' "$log"

say "what a purge leaves: data, and its user"
rm -f "$root/packages"/{use.sh,fly,fly.c,single_player,single_player.c,game.talus}
within "apt does not purge them" "apt-get purge -y -q talusd talus-tools libtalus1 libtalus-local1 libtalus-dev"
left="$(cd "$root" && find . -xdev \( -path ./packages -o -path ./var/lib/talus -o -path ./var/cache/apt -o -path ./proc -o -path ./dev -o -path ./tmp \) -prune -o -iname '*talus*' -print)"
[[ -z "$left" ]] || die "a purge leaves $left"
[[ -n "$(ls -A "$root/var/lib/talus")" ]] || die "a purge leaves no data"
grep -q '^talus:' "$root/etc/passwd" || die "a purge leaves data without their user"
rm -rf "$root/var/lib/talus"
within "apt does not install talusd again, and purge it" "$install /packages/talusd_*.deb && apt-get purge -y -q talusd"
[[ ! -e "$root/var/lib/talus" && ! -e "$root/etc/talus" ]] || die "a purge leaves empty directories"
! grep -q '^talus:' "$root/etc/passwd" || die "a purge leaves a user without data"
say "Debian's packages for $architecture: installed, used and purged"
