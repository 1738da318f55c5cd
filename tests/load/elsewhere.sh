#!/usr/bin/env bash
# What edits elsewhere cost those who look at land without any: the instructions that talusd executes for a View of radius 16 (RADIUS), by
# callgrind, with 1,000,000 edited voxels in 20,000 chunks 100 km off and with an empty store, by turns. elsewhere.sh [TURNS]
# Needs `cmake --build --preset release`, valgrind, and python3 with numpy.
set -euo pipefail
cd "$(dirname "$0")/../.."
turns="${1:-2}"
radius="${RADIUS:-16}"
build="${BUILD:-build/release}"
port="${PORT:-4793}"
out="$PWD/out/elsewhere"
rm -rf "$out"
mkdir -p "$out"
server=""
trap '[[ -z "$server" ]] || kill "$server" 2>/dev/null || true' EXIT

cat >"$out/talusd.toml" <<'SETTINGS'
[access]
without_token = "read,edit"
[cache]
disk_bytes = 0
[generation]
patch_tiles = 4
[threads]
generator = 1
io = 1
[limits]
write_timeout_ms = 600000
idle_timeout_ms = 600000
[rates]
session_chunks = 0
session_bytes = 0
session_requests = 0
session_voxels = 0
address_chunks = 0
address_bytes = 0
address_requests = 0
address_voxels = 0
SETTINGS

# start NAME [COMMAND...]: a server with the data directory of that name, by the command.
start() {
  local name="$1"
  shift
  : >"$out/ready"
  TALUS_INSTRUCTION_SET=avx2 "$@" "$build/server/talusd" --config "$out/talusd.toml" --world core/worlds/classic.toml \
    --listen "127.0.0.1:$port" --data "$out/$name" >"$out/ready" 2>>"$out/talusd.log" &
  server=$!
  until grep -q '^listening' "$out/ready"; do kill -0 "$server"; sleep 0.1; done
}
stop() { kill "$server"; wait "$server"; server=""; }

start edited
PYTHONPATH=client_sample/python /usr/bin/python3 - "$port" <<'BUILD'
import sys, talus
with talus.connect(f"127.0.0.1:{sys.argv[1]}") as world:
    changed, chunks = 0, [(3_200_000 + n % 40 * 32, n // 8_000 * 32 + 64, n // 40 % 200 * 32) for n in range(20_000)]
    for first in range(0, len(chunks), 40):
        voxels = [((x + i % 32, y + i // 32 * 9, z + i * 7 % 32), 1 + i % 2) for x, y, z in chunks[first:first + 40] for i in range(50)]
        changed += world.edit(voxels).changed
    print(f"{changed} voxels are edited")
BUILD
stop

for ((turn = 1; turn <= turns; ++turn)); do
  for kind in empty edited; do
    start "$kind" valgrind --tool=callgrind --instr-atstart=no --callgrind-out-file=/dev/null
    callgrind_control --instr=on "$server" >/dev/null 2>&1
    "$build/client_sample/cli/talus-client" --connect "127.0.0.1:$port" fly --seconds 60 --speed 0 --radius "$radius" --far 0 >"$out/fly.txt"
    callgrind_control --instr=off "$server" >/dev/null 2>&1
    stop
    printf '%s %s, %s\n' "$kind" "$(sed -n 's/.*Collected : *//p' "$out/talusd.log" | tail -n 1)" "$(head -n 1 "$out/fly.txt")" |
      tee -a "$out/figures"
  done
done
mean() { awk -v kind="$1" '$1 == kind { all += $2 + 0; ++n } END { printf "%.0f", all / n }' "$out/figures"; }
printf 'with edits elsewhere %s times the instructions\n' "$(awk -v a="$(mean edited)" -v b="$(mean empty)" 'BEGIN { printf "%.4f", a / b }')"
