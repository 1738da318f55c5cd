#!/usr/bin/env bash
# The load scenarios, one after the other, each against a talusd of its own; README.md says what each is for.
# Results go to out/load. For figures that mean something, nothing else should run on the machine.
set -euo pipefail
cd "$(dirname "$0")/../.."

usage() {
  cat <<'USAGE'
usage: tests/load/run.sh [--short] [SCENARIO...]

  join     a full View of radius 16, cold and hot
  hot      64 connections, 16 requests in flight, all cached, with answers of 0.4 and of 4 KiB; beside
           redis-benchmark where it is installed
  groups   1,000 players flying in 50 groups
  alone    300 players flying, each over ground of its own
  idle     10,000 idle connections, and 20 new players among them
  greedy   100 walkers without and with one greedy client
  slow     100 walkers without and with four readers at 64 kbit/s
  pong     how long a Pong waits behind a View, on links of several speeds
  churn    joining, jumping and being cut off, CHURN_SECONDS long (1800 unless told otherwise)

All of them unless told otherwise. BUILD=DIR: the build to take the programs from (build/release). TLS=1: by TLS, but for pong.

  --short  a few players for a few seconds each, for builds with sanitizers: judges what came and how the server
           ended, not how fast; the first failure ends the run
USAGE
}

build="${BUILD:-build/release}"
talusd="$build/server/talusd"
talus_load="$build/client_sample/load/talus-load"
talus_pong="$build/tests/load/talus-pong"
out=out/load
pid=""
short=""

# pick LONG SHORT
pick() { if [[ -n "$short" ]]; then echo "$2"; else echo "$1"; fi; }
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
  local server="$pid" status=0
  pid=""
  kill -TERM "$server" 2>/dev/null || true
  wait "$server" 2>/dev/null || status=$?
  [[ -z "$short" || $status == 0 ]] || { cat "$out/talusd.log" >&2; echo "talusd ended with $status" >&2; exit 1; }
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

# What a closed loop of requests needs, or a thousand players from one address.
no_session_rates=(TALUS_RATES_SESSION_CHUNKS=0 TALUS_RATES_SESSION_BYTES=0 TALUS_RATES_SESSION_REQUESTS=0)
no_address_rates=(TALUS_RATES_ADDRESS_CHUNKS=0 TALUS_RATES_ADDRESS_BYTES=0 TALUS_RATES_ADDRESS_REQUESTS=0)

# load NAME ARGUMENT...: prints the command without what is always there, then what it printed.
load() {
  local name="$1"
  shift
  printf '\n== %s: talus-load %s\n' "$name" "$*"
  # A server with sanitizers may be far behind at the end; who got all does not wait.
  "$talus_load" --connect "$address" "${client_tls[@]}" --server-pid "$pid" --json "$out/$name.json" --plot "$out/$name.svg" \
    --drain "$(pick 10 300)" "$@" || [[ -z "$short" ]]
}

# expect CONDITION...: what the scenario is to keep to; of a short run only that nothing came that was wrong.
expect() {
  expected=(--fail-if 'wrong>0')
  local condition
  [[ -n "$short" ]] || for condition in "$@"; do expected+=(--fail-if "$condition"); done
}

join() {
  local view=(--players 1 --model stand --radius "$(pick 16 6)" --vertical "$(pick 8 3)" --duration 2 --verify 0)
  start
  load join-warm-up --players 1 --model stand --radius 2 --duration 1 --seed 99  # the program itself, not the ground
  load join-cold "${view[@]}"
  load join-hot "${view[@]}"
}

hot() {
  hot_over hot 2
  [[ -z "$short" ]] || return 0
  hot_over hot-4k 8 TALUS_WORLD=tests/load/rough.toml
  if command -v redis-server redis-benchmark >/dev/null; then redis; else echo "redis-server is not installed: no reference"; fi
}

# hot_over NAME WARM-UP-SECONDS [VARIABLE=value...]
hot_over() {
  local name="$1" warm_up="$2" clients=(--players "$(pick 64 8)" --in-flight 16 --verify 0)
  shift 2
  start "${no_session_rates[@]}" "${no_address_rates[@]}" "$@"
  load "$name-warm-up" "${clients[@]}" --duration "$warm_up"
  load "$name" "${clients[@]}" --duration "$(pick 10 3)"
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
  expect 'p99_ms>50' 'late_over_one_step>0'
  start "${no_address_rates[@]}"
  load groups --players "$(pick 1000 20)" --groups "$(pick 50 4)" --model fly --speed 20 --radius "$(pick 8 4)" \
    --ramp-up "$(pick 30 2)" --warm-up "$(pick 10 1)" --duration "$(pick 60 5)" --verify "$(pick 0.2 5)" "${expected[@]}"
}

alone() {
  expect 'p99_ms>50' 'late_over_one_step>0'
  start "${no_address_rates[@]}"
  load alone --players "$(pick 300 8)" --model fly --speed 20 --radius "$(pick 8 4)" --ramp-up "$(pick 60 2)" \
    --warm-up "$(pick 10 1)" --duration "$(pick 60 5)" --verify "$(pick 0.2 5)" "${expected[@]}"
}

idle() {
  expect 'idle_bytes_each>16384' 'first_chunk_max_ms>20'
  start
  load idle --idle "$(pick 10000 500)" --players "$(pick 20 4)" --model stand --radius 4 --ramp-up "$(pick 10 2)" \
    --duration "$(pick 15 4)" "${expected[@]}"
}

walkers() {
  players=(--players "$(pick 100 10)" --model walk --radius "$(pick 8 4)" --ramp-up "$(pick 10 2)" --warm-up "$(pick 5 1)" --duration "$(pick 30 5)")
  start
  load walkers "${players[@]}"
}

greedy() {
  expect
  walkers
  start
  load greedy "${players[@]}" --greedy 1 --compare "$out/walkers.json" "${expected[@]}"
}

slow() {
  expect
  walkers
  start
  load slow "${players[@]}" --slow 4 --slow-rate 64 --compare "$out/walkers.json" "${expected[@]}"
}

pong() {
  [[ -z "${TLS:-}" ]] || { printf '\n== pong: left out: talus-pong speaks plain TCP alone\n'; return 0; }
  start
  local kilobits
  for kilobits in 1000 10000 0; do
    printf '\n== pong: talus-pong PORT %s 24\n' "$kilobits"
    "$talus_pong" "${address##*:}" "$kilobits" 24
  done
}

churn() {
  expect 'errors>0' 'files_left>0' 'resident_growth_percent>5'
  start "${no_address_rates[@]}" TALUS_CACHE_CHUNK_BYTES=33554432 TALUS_CACHE_PATCH_BYTES=33554432  # full before the measured time begins
  load churn --players "$(pick 100 10)" --model walk=50,fly=25,teleport=25 --groups "$(pick 20 4)" --churn "$(pick 10 2)" \
    --radius "$(pick 6 4)" --ramp-up "$(pick 10 1)" --warm-up "$(pick 60 1)" --duration "${CHURN_SECONDS:-$(pick 1800 10)}" \
    --verify 5 "${expected[@]}"
}

scenarios=(join hot groups alone idle greedy slow pong churn)
if [[ "${1:-}" == --short ]]; then
  short=yes
  shift
fi
for scenario in "$@"; do
  [[ " ${scenarios[*]} " == *" $scenario "* ]] || { usage >&2; exit 2; }
done
mkdir -p "$out"
[[ -z "${TLS:-}" ]] || make_certificate
for scenario in "${@:-${scenarios[@]}}"; do "$scenario"; done
