#!/usr/bin/env bash
# image.sh PACKAGES: as root, loads the image into a store of its own, and starts it as the image's own user with the image's own
# command.
set -euo pipefail
source "$(dirname "$0")/common.sh"
if [[ "$1" != --inside ]]; then
  out="$(mktemp -d)"
  inside=""
  # Everything inside ends with its first process: whichever step fails, no talusd, no buildah and no mount is left.
  trap '[[ -z "$inside" ]] || { pkill -KILL -P "$inside"; wait "$inside"; } 2>/dev/null || true; rm -rf --one-file-system "$out"' EXIT
  unshare --mount --pid --fork --kill-child --mount-proc "$0" --inside "$out" "$1" &
  inside=$!
  wait "$inside"
  inside=""
  exit
fi
out="$2"
archive="$(realpath "$(only_one "$3/talus-image-*.tar.gz")")"
commit="$(git -C "$(dirname "$0")" rev-parse HEAD 2>/dev/null || true)"
for program in buildah curl pgrep python3; do
  command -v "$program" >/dev/null || die "needs $program; ./dev deps containers installs it"
done
export TMPDIR="$out"
buildah() { command buildah --root "$out/store" --runroot "$out/run" "$@"; }
# chroot hides no process: talusd is below the one that was started, and does not end with it.
below() { local child; for child in $(pgrep -P "$1"); do printf '%s\n' "$child"; below "$child"; done; }
zcat "$archive" >"$out/image.tar"  # which docker load and podman load do themselves
image="$(buildah pull --quiet "docker-archive:$out/image.tar")"

# What the image says of itself: its user, its command, its health check, a word a line.
said() {
  buildah inspect --type image "$image" | python3 -c '
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
container="$(buildah from --pull-never "$image")"
buildah run --isolation chroot --env TALUS_ACCESS_WITHOUT_TOKEN=read,edit "$container" -- "${moved[@]}" >"$out/talusd.log" 2>&1 &
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

version="$(buildah run --isolation chroot "$container" -- talusd --version)"
[[ "$version" == *"(${commit:0:8})"* ]] || die "talusd --version: $version"

say "its health check, its operators' port, the viewer, an edit"
buildah run --isolation chroot "$container" -- "${health[@]/127.0.0.1:4780/$address}" >/dev/null ||
  die "the image's health check fails: ${health[*]}"
[[ "$(curl -sS -o /dev/null -w '%{http_code}' "$admin/-/ready")" == 200 ]] || die "it is not ready"
# No pipes into grep -q: it reads no more than it needs, and what writes to it then fails as well.
[[ "$(curl -sS --fail "$web/")" == *"<html"* ]] || die "it does not serve the viewer"
buildah run --isolation chroot "$container" -- talus-client --connect "$address" edit --material planks -- 3,35,3 ||
  die "its volume takes no edit"
[[ $'\n'"$(curl -sS --fail "$admin/metrics")"$'\n' == *$'\n'"talus_edits_revision 1"$'\n'* ]] || die "its edit is not stored"

kill -TERM "$talusd"
wait "$started" || die "talusd ended with $?"
say "$(basename "$archive"): runs as its user"
