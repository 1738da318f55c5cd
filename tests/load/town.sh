#!/usr/bin/env bash
# What it costs to join in a town: a View of radius 16 whose 1,089 columns have four edited chunks each, beside the same View without
# edits, both from a server that has just started and keeps no chunks on disk. Processor time of talusd, by turns. town.sh [TURNS]
# Needs `cmake --build --preset release` and python3 with numpy.
set -euo pipefail
cd "$(dirname "$0")/../.."
turns="${1:-5}"
build="${BUILD:-build/release}"
port="${PORT:-4791}"
out="$PWD/out/town"
rm -rf "$out"
mkdir -p "$out"
server=""
trap '[[ -z "$server" ]] || kill "$server" 2>/dev/null || true' EXIT

{ cat core/worlds/default.toml; printf '\n[[placeable]]\nname = "glass"\ncolour = "#a0c0d0"\n'; } >"$out/town.toml"
cat >"$out/talusd.toml" <<'SETTINGS'
[access]
without_token = "read,edit"
[cache]
disk_bytes = 0
[rates]
session_chunks = 0
session_bytes = 0
session_requests = 0
address_chunks = 0
address_bytes = 0
address_requests = 0
SETTINGS

# start NAME: a server with the data directory of that name.
start() {
  : >"$out/ready"
  "$build/server/talusd" --config "$out/talusd.toml" --world "$out/town.toml" --listen "127.0.0.1:$port" --data "$out/$1" \
    >"$out/ready" 2>>"$out/talusd.log" &
  server=$!
  until grep -q '^listening' "$out/ready"; do kill -0 "$server"; sleep 0.1; done
}
stop() { kill "$server"; wait "$server"; server=""; }
ticks() { sed 's/.*) //' "/proc/$server/stat" | awk '{ print $12 + $13 }'; }

start town
PYTHONPATH=client_sample/python /usr/bin/python3 - "$port" <<'BUILD'
import sys, talus
with talus.connect(f"127.0.0.1:{sys.argv[1]}") as world:
    x, y, z = (v // 32 for v in world.spawn)
    voxels = [(((x + dx) * 32 + 9, (y + dy) * 32 + 9, (z + dz) * 32 + 9), "glass")
              for dx in range(-16, 17) for dz in range(-16, 17) for dy in range(-2, 2)]
    changed = sum(world.edit(voxels[i:i + 64]).changed for i in range(0, len(voxels), 64))
    assert changed == len(voxels), changed
    print(f"{changed} chunks of the town have an edit")
BUILD
stop

for ((turn = 1; turn <= turns; ++turn)); do
  for kind in plain town; do
    start "$kind"
    before="$(ticks)"
    "$build/client_sample/cli/talus-client" --connect "127.0.0.1:$port" fly --seconds 4 --speed 0 --radius 16 --far 0 >"$out/fly.txt"
    printf '%s %s %s\n' "$kind" "$((($(ticks) - before) * 10))" "$(sed -n 's/.*p50 \([0-9.]*\) ms.*p99 \([0-9.]*\) ms.*/\1 \2/p' "$out/fly.txt")" | tee -a "$out/figures"
    stop
  done
done
median() { awk -v kind="$1" '$1 == kind { print $2 }' "$out/figures" | sort -n | awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }'; }
plain="$(median plain)"
town="$(median town)"
printf 'talusd took %s ms of processor time for the plain View and %s ms for the town, in the median: %s times\n' "$plain" "$town" \
  "$(awk -v a="$town" -v b="$plain" 'BEGIN { printf "%.2f", a / b }')"
