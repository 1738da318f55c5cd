#!/usr/bin/env bash
# The load scenarios, one after the other, each against a talusd of its own; README.md says what each is for.
# Results go to out/load. For figures that mean something, nothing else should run on the machine.
set -euo pipefail
cd "$(dirname "$0")/../.."

usage() {
  cat <<'USAGE'
usage: tests/load/run.sh [SCENARIO...]

  join     a full View of radius 16, cold and hot
  hot      64 connections, 16 requests in flight, all cached; beside redis-benchmark where it is installed
  groups   1,000 players flying in 50 groups
  alone    300 players flying, each over ground of its own
  idle     10,000 idle connections, and 20 new players among them
  greedy   100 walkers without and with one greedy client
  slow     100 walkers without and with four readers at 64 kbit/s
  churn    joining, jumping and being cut off, CHURN_SECONDS long (1800 unless told otherwise)

All of them unless told otherwise. BUILD=DIR: the build to take the programs from (build/release). TLS=1: by TLS.
USAGE
}

build="${BUILD:-build/release}"
talusd="$build/server/talusd"
talus_load="$build/client_sample/load/talus-load"
out=out/load
pid=""
server_tls=()
client_tls=()

# A certificate of this run's own, which the harness trusts.
make_certificate() {
  openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:P-256 -nodes -days 2 -subj /CN=localhost \
    -addext subjectAltName=DNS:localhost,IP:127.0.0.1 -keyout "$out/key.pem" -out "$out/certificate.pem" 2>/dev/null
  server_tls=(TALUS_TLS_CERTIFICATE="$out/certificate.pem" TALUS_TLS_KEY="$out/key.pem")
  client_tls=(--ca "$out/certificate.pem")
}

stop() {
  [[ -n "$pid" ]] || return 0
  kill -TERM "$pid" 2>/dev/null || true
  wait "$pid" 2>/dev/null || true
  pid=""
}
trap stop EXIT

# start [VARIABLE=value...]: a fresh server.
start() {
  stop
  : >"$out/talusd.log"
  env TALUS_LOG_LEVEL=warning TALUS_LIMITS_CONNECTIONS=20000 TALUS_LIMITS_CONNECTIONS_PER_ADDRESS=20000 \
    TALUS_LIMITS_HANDSHAKES_PER_ADDRESS_PER_SECOND=20000 TALUS_LIMITS_HANDSHAKES_PER_ADDRESS_BURST=20000 \
    TALUS_LIMITS_HANDSHAKES_UNDER_WAY=20000 "${server_tls[@]}" "$@" \
    "$talusd" --listen 127.0.0.1:0 >"$out/talusd.log" 2>&1 &
  pid=$!
  until address="$(sed -n 's/.*listening on \([^ ]*\).*/\1/p' "$out/talusd.log")" && [[ -n "$address" ]]; do
    kill -0 "$pid" 2>/dev/null || { cat "$out/talusd.log" >&2; exit 1; }
    sleep 0.05
  done
}

# load NAME ARGUMENT...: prints the command without what is always there, then what it printed.
load() {
  local name="$1"
  shift
  printf '\n== %s: talus-load %s\n' "$name" "$*"
  "$talus_load" --connect "$address" "${client_tls[@]}" --server-pid "$pid" --json "$out/$name.json" --plot "$out/$name.svg" "$@" || true
}

join() {
  local view=(--players 1 --model stand --radius 16 --vertical 8 --duration 2 --verify 0)
  start
  load join-warm-up --players 1 --model stand --radius 2 --duration 1 --seed 99  # the program itself, not the ground
  load join-cold "${view[@]}"
  load join-hot "${view[@]}"
}

hot() {
  local clients=(--players 64 --in-flight 16 --verify 0)
  start
  load hot-warm-up "${clients[@]}" --duration 2
  load hot "${clients[@]}" --duration 10
  if command -v redis-server redis-benchmark >/dev/null; then redis; else echo "redis-server is not installed: no reference"; fi
}

# The same depth and as many connections, with answers of 4 KiB and of what talusd's have; CPU seconds of the
# server alone.
redis() {
  local port=4791 redis_pid before after size count=2000000
  redis-server --port $port --save '' --appendonly no >/dev/null 2>&1 &
  redis_pid=$!
  until redis-cli -p $port ping >/dev/null 2>&1; do sleep 0.05; done
  cpu() { awk '{ print ($14 + $15) / 100 }' "/proc/$redis_pid/stat"; }
  printf '\n== redis: GET, 64 connections, 16 in flight\n'
  for size in 4096 390; do
    redis-benchmark -p $port -t set -n 20000 -r 1024 -d $size -q >/dev/null
    before="$(cpu)"
    redis-benchmark -p $port -t get -n $count -r 1024 -d $size -c 64 -P 16 -q | tr '\r' '\n' | grep 'requests per second'
    after="$(cpu)"
    awk -v a="$before" -v b="$after" -v n=$count -v s=$size \
      'BEGIN { printf "redis: %.2f CPU s a million GETs of %d bytes\n", (b - a) / n * 1e6, s }'
  done
  kill "$redis_pid"
  wait "$redis_pid" 2>/dev/null || true
}

groups() {
  start
  load groups --players 1000 --groups 50 --model fly --speed 20 --radius 8 --ramp-up 30 --warm-up 10 --duration 60 --verify 0.2 \
    --fail-if 'p99_ms>50' --fail-if 'late_over_one_step>0' --fail-if 'wrong>0'
}

alone() {
  start
  load alone --players 300 --model fly --speed 20 --radius 8 --ramp-up 60 --warm-up 10 --duration 60 --verify 0.2 \
    --fail-if 'p99_ms>50' --fail-if 'late_over_one_step>0' --fail-if 'wrong>0'
}

idle() {
  start
  load idle --idle 10000 --players 20 --model stand --radius 4 --ramp-up 10 --duration 15 \
    --fail-if 'idle_bytes_each>16384' --fail-if 'first_chunk_max_ms>20' --fail-if 'wrong>0'
}

greedy() {
  local walkers=(--players 100 --model walk --ramp-up 10 --warm-up 5 --duration 30)
  start
  load walkers "${walkers[@]}"
  start
  load greedy "${walkers[@]}" --greedy 1 --compare "$out/walkers.json" --fail-if 'wrong>0'
}

slow() {
  local walkers=(--players 100 --model walk --ramp-up 10 --warm-up 5 --duration 30)
  start
  load walkers "${walkers[@]}"
  start
  load slow "${walkers[@]}" --slow 4 --slow-rate 64 --compare "$out/walkers.json" --fail-if 'wrong>0'
}

churn() {
  start TALUS_CACHE_CHUNK_BYTES=33554432 TALUS_CACHE_PATCH_BYTES=33554432  # full before the measured time begins
  load churn --players 100 --model walk=50,fly=25,teleport=25 --groups 20 --churn 10 --radius 6 --ramp-up 10 --warm-up 60 \
    --duration "${CHURN_SECONDS:-1800}" --verify 5 \
    --fail-if 'wrong>0' --fail-if 'errors>0' --fail-if 'files_left>0' --fail-if 'resident_growth_percent>5'
}

scenarios=(join hot groups alone idle greedy slow churn)
for scenario in "$@"; do
  [[ " ${scenarios[*]} " == *" $scenario "* ]] || { usage >&2; exit 2; }
done
mkdir -p "$out"
[[ -z "${TLS:-}" ]] || make_certificate
for scenario in "${@:-${scenarios[@]}}"; do "$scenario"; done
