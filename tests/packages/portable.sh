#!/usr/bin/env bash
# portable.sh PACKAGES: as root, starts the programs of the archive in a root that has BusyBox and no other program or library,
# as Alpine has no glibc.
set -euo pipefail
source "$(dirname "$0")/common.sh"
archive="$(realpath "$(only_one "$1/talus-[0-9]*-linux-*.tar.gz")")"
commit="$(git -C "$(dirname "$0")" rev-parse HEAD 2>/dev/null || true)"
scratch="$(mktemp -d)"
trap 'rm -rf --one-file-system "$scratch"' EXIT
mkdir -p "$scratch"/{bin,etc,proc,dev,tmp,opt,data}
cp "$(command -v /bin/busybox)" "$scratch/bin/"
! ldd "$scratch/bin/busybox" >/dev/null 2>&1 || die "/bin/busybox is not that of busybox-static"
for applet in $("$scratch/bin/busybox" --list); do [[ -e "$scratch/bin/$applet" ]] || ln -s busybox "$scratch/bin/$applet"; done
printf 'root:x:0:0::/:/bin/sh\ntalus:x:4780:4780::/:/bin/false\n' >"$scratch/etc/passwd"
printf 'root:x:0:\ntalus:x:4780:\n' >"$scratch/etc/group"
printf '127.0.0.1 localhost this-host\n' >"$scratch/etc/hosts"
tar -xzf "$archive" -C "$scratch/opt" --strip-components=1 --one-top-level=talus

cat >"$scratch/use.sh" <<'SCRIPT'
set -eu
ln -s /opt/talus/bin/* /bin/
cd /tmp
for program in talusd talus-gen talus-client talus-load; do $program --version; done
# Its own user, found by name; a host, found by name.
TALUS_USER=talus talusd --data /data/store --http 127.0.0.1:4782 --web /opt/talus/share/talus/web \
  --world /opt/talus/share/talus/worlds/mesas.toml >talusd.log 2>&1 &
until grep -q 'listening on' talusd.log && grep -q '^HTTP and' talusd.log; do
  kill -0 $! || { cat talusd.log; exit 1; }
  sleep 0.05
done
server="$(pidof talusd)"
[ "$(stat -c %U /proc/$server)" = talus ] || { echo "talusd runs as $(stat -c %U /proc/$server)"; exit 1; }
talus-client --connect this-host:4780 get 0 0 0 --timeout 60
wget -q -O - http://localhost:4782/ | grep -q '<html' || { echo "no viewer"; exit 1; }
talus-gen map --center 0,0 --size 64,64 -o map.png
[ -s map.png ]
kill $server
wait
tail -n 1 talusd.log
SCRIPT
chmod 755 "$scratch"
chmod 777 "$scratch/data"
unshare --net --mount --pid --fork --kill-child bash -c 'ip link set lo up && mount -t proc proc "$1/proc" &&
  mount --bind /dev "$1/dev" && exec /usr/sbin/chroot "$1" /bin/env -i PATH=/bin /bin/sh /use.sh' portable "$scratch" >"$scratch/said" 2>&1 ||
  { cat "$scratch/said"; die "it does not run without the libraries of this machine"; }
[[ -z "$commit" ]] || [[ "$(head -n 1 "$scratch/said")" == "talusd "*"(${commit:0:8})"* ]] || { cat "$scratch/said"; die "--version names another commit than ${commit:0:8}"; }
say "$(basename "$archive"): without a library of this machine"
cat "$scratch/said"
