#!/usr/bin/env bash
# A world that is dug and built in, flown through, cut off and started again, for as long as is asked: soak.sh [MINUTES] [SEED].
# Needs `cmake --build --preset release`. Each round is a minute, and the last begins before MINUTES are
# over: builders and flyers by talus-load, and a kill -9 every one to three seconds (KILLS=0: none). Then a model outside of the server,
# talus-edits-model, lays all edits that were acknowledged since the first round over generated chunks, and each chunk that was ever
# edited must have its content hash and revision at the server. After a SIGTERM `talusd store verify` must find the store sound, and
# `talusd store stat` say the model's revision, voxels, chunks and hash of all edits.
# It fails, too, where a builder misses an edit that was acknowledged, or memory or the disk take more than MEMORY_MB and DISK_MB.
# Between rounds it waits while a file out/soak/pause is there.
set -euo pipefail
cd "$(dirname "$0")/../.."
minutes="${1:-60}"
seed="${2:-$RANDOM}"
build="${BUILD:-build/release}"
port="${PORT:-4790}"
talusd="$build/server/talusd"
load="$build/client_sample/load/talus-load"
model="$build/tests/load/talus-edits-model"
memory_mb="${MEMORY_MB:-1024}"
disk_mb="${DISK_MB:-512}"
out="${OUT:-$PWD/out/soak}"
rm -rf "$out"
mkdir -p "$out"
RANDOM="$seed"
server=""
trap '[[ -z "$server" ]] || kill -9 "$server" 2>/dev/null || true' EXIT

start() {
  : >"$out/ready"  # what the server before has said
  "$talusd" --config "$out/talusd.toml" --listen "127.0.0.1:$port" --data "$out/data" >"$out/ready" 2>>"$out/talusd.log" &
  server=$!
  until grep -q '^listening' "$out/ready"; do
    kill -0 "$server" 2>/dev/null || { tail -n 3 "$out/talusd.log" >&2; exit 1; }
    sleep 0.1
  done
}
# Megabytes at most, since the server started.
peak() { awk '/^VmHWM/ { printf "%d", $2 / 1024 }' "/proc/$server/status"; }

cat >"$out/talusd.toml" <<'SETTINGS'
[access]
without_token = "read,edit"
[limits]
connections_per_address = 1000
memory_bytes = 1073741824
[cache]
disk_bytes = 67108864
[rates]
session_requests = 0
address_requests = 0
address_chunks = 0
address_bytes = 0
address_voxels = 0
SETTINGS

fail() { printf '%s\n' "$1" >&2; exit 1; }

printf 'seed %s\n\n| minute | kills so far | edits acknowledged | missing | revision | edited chunks as the model has them | hash of all edits |' "$seed"
printf ' peak memory, MB | on disk, MB |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n'
kills=0
for ((minute = 1; SECONDS < minutes * 60; ++minute)); do
  while [[ -e "$out/pause" ]]; do sleep 1; done
  began="$SECONDS"
  start
  "$load" --connect "127.0.0.1:$port" --players 24 --edits 10 --edit-group 6 --radius 4 --duration 50 --seed "$((seed + minute))" \
    --json "$out/builders.json" --edits-file "$out/edits" >"$out/builders.txt" 2>&1 &
  builders=$!
  "$load" --connect "127.0.0.1:$port" --players 12 --radius 6 --duration 50 --seed "$((seed + minute))" >"$out/flyers.txt" 2>&1 &
  flyers=$!
  sleep 5  # who finds no server at the very first gives up
  most=0
  while kill -0 "$builders" 2>/dev/null; do
    sleep "$((1 + RANDOM % 3))"
    now="$(peak)"
    most="$((now > most ? now : most))"
    # At the end it stays up, so that all can be looked at.
    ((SECONDS - began < 40 && ${KILLS:-1} != 0)) || continue
    kill -9 "$server"
    wait "$server" 2>/dev/null || true
    kills="$((kills + 1))"
    start
  done
  wait "$builders" || { cat "$out/builders.txt" >&2; exit 1; }
  wait "$flyers" || { cat "$out/flyers.txt" >&2; exit 1; }
  "$model" "$out/edits" 127.0.0.1 "$port" >"$out/model.txt" || exit 1
  kill "$server"
  wait "$server" || { printf 'talusd ended with %s\n' "$?" >&2; exit 1; }
  server=""
  "$talusd" store verify --data "$out/data" >"$out/verify.txt" || { cat "$out/verify.txt" >&2; exit 1; }
  "$talusd" store stat --json --data "$out/data" >"$out/stat.json"
  read -r compared chunks voxels revision hash <"$out/model.txt"
  stored="$(jq -r '"\(.levels[0].chunks) \(.levels[0].voxels) \(.revision) \(.hash)"' "$out/stat.json")"
  [[ "$stored" == "$chunks $voxels $revision $hash" ]] || fail "the store has $stored, the model $chunks $voxels $revision $hash"
  disk="$(du -sm "$out/data" | cut -f1)"
  printf '| %s | %s | %s | %s | %s | %s | %s | %s | %s |\n' "$minute" "$kills" "$(jq .roles.build.edits.acknowledged "$out/builders.json")" \
    "$(jq .roles.build.edits.missing "$out/builders.json")" "$revision" "$compared" "$hash" "$most" "$disk"
  ((most <= memory_mb)) || fail "memory: $most MB"
  ((disk <= disk_mb)) || fail "on disk: $disk MB"
done
