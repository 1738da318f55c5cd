#!/usr/bin/env bash
# As root: builds the image of docker/Dockerfile by buildah, on a Debian 12 that debootstrap makes as this machine's apt has
# it, and starts it as the image's own user with the image's own command. No registry is asked. Results go to out/image.
set -euo pipefail
cd "$(dirname "$0")/../.."
source tests/bare_debian.sh

die() { printf 'image: %s\n' "$*" >&2; exit 1; }
say() { printf '\033[1m==> %s\033[0m\n' "$*" >&2; }

((EUID == 0)) || die "needs root, for debootstrap and chroot"
for program in debootstrap buildah curl; do
  command -v "$program" >/dev/null || die "needs $program; ./dev deps containers installs it"
done

out="$PWD/out/image"
mkdir -p "$out"
exec 9>"$out/lock"
flock -n 9 || die "another one runs in this folder"
# A store of its own: what else this machine has built stays as it is, and goes unused.
buildah() { command buildah --root "$out/store" --runroot "$out/run" "$@"; }
container="" started=""
# chroot hides no process: talusd is below the one that was started, and does not end with it.
below() { local child; for child in $(pgrep -P "$1"); do printf '%s\n' "$child"; below "$child"; done; }
finish() {
  [[ -z "$started" ]] || { kill -TERM $(below "$started") "$started" 2>/dev/null; wait "$started" 2>/dev/null; } || true
  [[ -z "$container" ]] || buildah rm "$container" >/dev/null 2>&1 || true
  rm -rf --one-file-system "$out/root"
}
trap finish EXIT

# The base under the name that the Dockerfile asks for, so that the Dockerfile is built as it is.
base=docker.io/library/debian:12-slim
if ! buildah inspect --type image "$base" >/dev/null 2>&1; then
  say "making a bare Debian 12"
  bare_debian "$out/root" "$out/debootstrap.log"
  rm -rf "$out/root/var/cache/apt/archives"/*.deb
  scratch="$(buildah from scratch)"
  buildah add --quiet "$scratch" "$out/root" / >/dev/null
  buildah commit --quiet --rm "$scratch" "$base" >/dev/null
  rm -rf --one-file-system "$out/root"
fi

say "building the image of docker/Dockerfile (log: out/image/build.log)"
buildah bud --isolation chroot --pull-never --layers --format docker --ignorefile docker/Dockerfile.dockerignore \
  -f docker/Dockerfile -t localhost/talus . >"$out/build.log" 2>&1 ||
  { tail -n 20 "$out/build.log" >&2; die "docker/Dockerfile does not build; all it said: $out/build.log"; }

# What the image says of itself: its user, its command, its health check, a word a line.
said() {
  buildah inspect --type image localhost/talus | python3 -c '
import json, sys
config = json.load(sys.stdin)["Docker"]["config"]
for key in sys.argv[1:]:
    value = config[key]["Test"][1:] if key == "Healthcheck" else config[key]
    print(*([value] if isinstance(value, str) else value), sep="\n")' "$@"
}
[[ "$(said User)" == 4780:4780 ]] || die "the image's user is '$(said User)', not 4780:4780"
[[ "$(said StopSignal)" == SIGTERM ]] || die "the image's stop signal is not SIGTERM"
mapfile -t command < <(said Entrypoint Cmd)
mapfile -t health < <(said Healthcheck)

# chroot has the machine's own ports: the image's are moved where this machine has them free. The rest is the image's.
moved=()
for word in "${command[@]}"; do moved+=("${word/0.0.0.0:*/127.0.0.1:0}"); done
moved+=(--listen 127.0.0.1:0)
say "starting it as its user: ${moved[*]}"
container="$(buildah from --pull-never localhost/talus)"
buildah run --isolation chroot "$container" -- "${moved[@]}" >"$out/talusd.log" 2>&1 &
started=$!
until grep -q '^HTTP and WebSocket on' "$out/talusd.log" && grep -q 'listening on' "$out/talusd.log"; do
  kill -0 "$started" 2>/dev/null || { cat "$out/talusd.log" >&2; die "talusd did not start in the image"; }
  sleep 0.1
done
talusd="$(for process in $(below "$started"); do [[ "$(cat "/proc/$process/comm")" != talusd ]] || echo "$process"; done)"
[[ "$(stat -c %u:%g "/proc/$talusd")" == 4780:4780 ]] || die "talusd runs as $(stat -c %u:%g "/proc/$talusd")"
address="$(sed -n 's/.*listening on //p' "$out/talusd.log" | head -n 1)"
admin="$(sed -n 's/.*metrics and health on //p' "$out/talusd.log" | head -n 1)"
web="$(sed -n 's/^HTTP and WebSocket on //p' "$out/talusd.log" | head -n 1)"

say "its health check, its operators' port, the viewer, an edit"
buildah run --isolation chroot "$container" -- "${health[@]/127.0.0.1:4780/$address}" >/dev/null ||
  die "the image's health check fails: ${health[*]}"
[[ "$(curl -sS -o /dev/null -w '%{http_code}' "$admin/-/ready")" == 200 ]] || die "it is not ready"
# No pipes into grep -q: it reads no more than it needs, and what writes to it then fails as well.
[[ "$(curl -sS --fail "$web/")" == *"<html"* ]] || die "it does not serve the viewer"
[[ $'\n'"$(curl -sS --fail "$admin/metrics")"$'\n' == *$'\n'"talus_edits_revision 0"$'\n'* ]] || die "it has no store of edits in its volume"

kill -TERM "$talusd"
wait "$started" || die "talusd ended with $?"
started=""
say "docker/Dockerfile: builds, and runs as its user"
