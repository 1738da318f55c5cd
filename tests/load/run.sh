#!/usr/bin/env bash
# The load scenarios, one after the other, each against a talusd of its own; --help says what each is for.
# Results go to out/load. For figures that mean something, nothing else should run on the machine.
set -euo pipefail
cd "$(dirname "$0")/../.."

usage() {
  cat <<'USAGE'
usage: tests/load/run.sh [--short] [SCENARIO...]

  join     a full View of radius 16, cold and hot
  horizon  rings of levels 1 to 6 out to 256 chunks (8 km) beside a near View of radius 8: from nothing to full, cold and
           hot, and on a flight
  hot      64 connections, 16 requests in flight, all cached, with answers of 0.4 and of 4 KiB; beside
           redis-benchmark where it is installed
  groups   1,000 players flying in 50 groups
  alone    300 players flying, each over ground of its own
  loners   the same by LONERS (1000 3000 unless told otherwise), the settings as shipped but for the one address
  storm    1,000 players whose server is killed, and then one that ends, and starts again at once
  idle     10,000 idle connections, and 20 new players among them
  greedy   100 walkers with one greedy client and without, by turns
  slow     100 walkers with four readers at 64 kbit/s and without, by turns
  rates    250 players of one address whom its rate holds at 8,192 chunks/s and, by turns, as many who want just that
           many: what a chunk costs the server
  websocket
           200 players by WebSocket and, by turns, by TCP, over the same cached land: what a message costs the server
  pong     how long a Pong waits behind a View, on links of several speeds
  edits    who digs and builds: 10,000 edits/s of 64 players; 1,000 edits/s of 1,000 players in 50 groups; 64 players
           each of whom waits for its answer, beside a bare echo server
  churn    joining, jumping and being cut off, CHURN_SECONDS long (1800 unless told otherwise)
  siege    the same beside 150 attackers of 4 other addresses
  websocket-siege
           the same, and the attackers come by WebSocket

All of them unless told otherwise. BUILD=DIR: the build to take the programs from (build/release). TLS=1: by TLS, but for pong.

  --short  a few players for a few seconds each, for builds with sanitizers: judges what came and how the server
           ended, not how fast; the first failure ends the run
USAGE
}

failed=""
build="${BUILD:-build/release}"
talusd="$build/server/talusd"
# What the tables of docs/SPEED.md were measured with.
export TALUS_WORLD="${TALUS_WORLD:-core/worlds/classic.toml}"
talus_load="$build/client_sample/load/talus-load"
talus_pong="$build/tests/load/talus-pong"
talus_siege="$build/tests/load/talus-siege"
talus_echo="$build/tests/load/talus-echo"
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
trap 'stop_siege; stop_redis; stop' EXIT
trap 'exit 130' INT TERM

listen=127.0.0.1:0

# start [VARIABLE=value...]: a fresh server.
start() {
  stop
  : >"$out/talusd.log"
  env TALUS_LOG_LEVEL=warning TALUS_LIMITS_CONNECTIONS=20000 TALUS_LIMITS_CONNECTIONS_PER_ADDRESS=20000 \
    TALUS_LIMITS_HANDSHAKES_PER_ADDRESS_PER_SECOND=20000 TALUS_LIMITS_HANDSHAKES_PER_ADDRESS_BURST=20000 \
    TALUS_LIMITS_HANDSHAKES_IN_FLIGHT=20000 "${server_tls[@]}" "$@" \
    "$talusd" --listen "$listen" >"$out/talusd.log" 2>&1 &
  pid=$!
  until address="$(sed -n 's/.*listening on \([^ ]*\).*/\1/p' "$out/talusd.log")" && [[ -n "$address" ]]; do
    kill -0 "$pid" 2>/dev/null || { cat "$out/talusd.log" >&2; exit 1; }
    sleep 0.05
  done
  [[ " $* " != *" TALUS_ADMIN="* ]] || await_address admin 'metrics and health on http'
  [[ " $* " != *" TALUS_HTTP_LISTEN="* ]] || await_address http 'HTTP and WebSocket on https\{0,1\}'
}

# await_address VARIABLE WORDS: the HOST:PORT that the server says after WORDS://.
await_address() {
  local found
  until found="$(sed -n "s/.*$2:\/\/\([^ /]*\).*/\1/p" "$out/talusd.log")" && [[ -n "$found" ]]; do
    kill -0 "$pid" 2>/dev/null || { cat "$out/talusd.log" >&2; exit 1; }
    sleep 0.05
  done
  printf -v "$1" '%s' "$found"
}

# What a closed loop of requests needs, or a thousand players from one address.
no_session_rates=(TALUS_RATES_SESSION_CHUNKS=0 TALUS_RATES_SESSION_BYTES=0 TALUS_RATES_SESSION_REQUESTS=0)
no_address_rates=(TALUS_RATES_ADDRESS_CHUNKS=0 TALUS_RATES_ADDRESS_BYTES=0 TALUS_RATES_ADDRESS_REQUESTS=0)

# load NAME ARGUMENT...: prints the command without what is always there, then what it printed.
load() {
  local name="$1"
  shift
  rm -f "$out/$name.json"
  printf '\n== %s: talus-load %s\n' "$name" "$*"
  # A server with sanitizers may be far behind at the end; who got all does not wait.
  "$talus_load" --connect "$address" "${client_tls[@]}" --server-pid "$pid" --json "$out/$name.json" --plot "$out/$name.svg" \
    --drain "$(pick 10 300)" "$@" || [[ -z "$short" ]]
}

# expect CONDITION...: what the scenario is to keep to; of a short run only that all came and was right.
expect() {
  expected=(--fail-if 'wrong>0' --fail-if 'unanswered>0')
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

# An edit of a voxel is 104 bytes on the wire, its answer 64.
edits() {
  local near=(--radius 2 --vertical 1 --verify 0) data
  local rates=("${no_session_rates[@]}" "${no_address_rates[@]}" TALUS_RATES_SESSION_VOXELS=0 TALUS_RATES_ADDRESS_VOXELS=0)
  # edit NAME ARGUMENT...: on a store of its own.
  edit() {
    data="$(mktemp -d "$out/edits.XXXXXX")"
    start "${rates[@]}" TALUS_DATA="$data" TALUS_ACCESS_WITHOUT_TOKEN=read,edit
    load "$@" "${near[@]}" "${expected[@]}"
    stop
    rm -rf "$data"
  }
  expect 'edits_missing>0' 'errors>0' 'edit_ack_p99_ms>10'
  edit edits-ack --players "$(pick 64 8)" --edits "$(pick 156.25 20)" --warm-up 2 --duration "$(pick 20 2)"
  expect 'edits_missing>0' 'errors>0' 'edit_arrival_p99_ms>25'
  edit edits-groups --players "$(pick 1000 40)" --edits 1 --edit-group 20 --ramp-up "$(pick 10 1)" --warm-up 3 \
    --duration "$(pick 30 3)"
  expect 'edits_missing>0' 'errors>0'
  printf '\n'
  "$talus_echo" 64 104 "$(pick 10 1)"
  edit edits-closed --players 64 --edit-in-flight 1 --warm-up 2 --duration "$(pick 10 1)"
  "$talus_echo" 64 104 "$(pick 10 1)"
}

# Bytes and server CPU from nothing to full, and on a flight, with a horizon and without. Each cold View on a fresh server.
horizon() {
  expect
  local kind rings stand=(--players 1 --model stand --radius "$(pick 8 3)" --duration 2 --verify 0)
  local fly=(--players 1 --model fly --speed 20 --radius "$(pick 8 3)" --duration "$(pick 60 4)" --verify 0)
  for kind in near horizon; do
    rings=()
    [[ "$kind" == near ]] || rings=(--horizon "$(pick 256 40)")
    start TALUS_ADMIN=127.0.0.1:0
    load "$kind-warm-up" --players 1 --model stand --radius 2 --duration 1 --seed 99  # the program itself, not the ground
    load "$kind-cold" "${stand[@]}" "${rings[@]}" --metrics "$admin" "${expected[@]}"
    load "$kind-hot" "${stand[@]}" "${rings[@]}" --metrics "$admin" "${expected[@]}"
    load "$kind-flight" "${fly[@]}" "${rings[@]}" --seed 2 --metrics "$admin" "${expected[@]}"
  done
  printf '\n%-16s %10s %9s %9s %9s %8s %9s\n' View messages kB full/ms CPU/ms Mbit/s '7Mbit/s:s'
  local name
  for name in near-cold horizon-cold near-hot horizon-hot near-flight horizon-flight; do tell_bytes "$name"; done
}

# tell_bytes NAME: what a View came to in one line. Of one that stands the rate is that until it was full, of one that flies the
# mean; the last figure is how long all bytes take through 7 Mbit/s.
tell_bytes() {
  local full
  full="$(figure "$1" horizon_max_ms)"
  [[ -n "$full" ]] || full="$(figure "$1" full_view_max_ms)"
  awk -v name="$1" -v messages="$(figure "$1" chunk_messages)" -v bytes="$(figure "$1" bytes)" -v full="$full" \
    -v cpu="$(figure "$1" cpu_s)" -v measured="$(figure "$1" measured_s)" 'BEGIN {
      seconds = name ~ /flight/ ? measured : full / 1000
      printf "%-16s %10d %9.0f %9.1f %9.0f %8.2f %9.2f\n",
        name, messages, bytes / 1e3, full, cpu * 1e3, bytes * 8 / 1e6 / seconds, bytes * 8 / 7e6
    }'
}

hot() {
  hot_beside hot 450 2
  [[ -n "$short" ]] || hot_beside hot-4k 4096 8 TALUS_WORLD=tests/load/rough.toml
}

# hot_beside NAME BYTES WARM-UP-SECONDS [VARIABLE=value...]: talusd and, by turns, redis with answers of BYTES, as many
# connections and the same depth. What a machine does at one moment it does not do at another, so turns are compared.
hot_beside() {
  local name="$1" bytes="$2" warm_up="$3" clients=(--players "$(pick 64 8)" --in-flight 16 --verify 0)
  shift 3
  start "${no_session_rates[@]}" "${no_address_rates[@]}" "$@"
  load "$name-warm-up" "${clients[@]}" --duration "$warm_up"
  local why=""
  [[ -z "${TLS:-}" ]] || why="redis here speaks plain TCP: no reference"
  has redis-server redis-cli redis-benchmark || why="redis is not installed: no reference"
  if [[ -n "$short$why" ]]; then
    load "$name" "${clients[@]}" --duration "$(pick 10 3)"
    [[ -n "$short" ]] || echo "$why"
    return
  fi
  start_redis "$bytes"
  : >"$out/$name-turns"
  local turn ours theirs
  for turn in 1 2 3 4 5; do
    load "$name" "${clients[@]}" --duration 5
    ours="$(figure "$name" cpu_s_per_million)"
    theirs="$(redis_turn "$bytes")"
    [[ -n "$ours" && -n "$theirs" ]] || { echo "$name: turn $turn gave no figure" >&2; exit 1; }
    printf 'turn %s: talusd %.2f, redis %.2f CPU s a million (GETs of %s bytes)\n' "$turn" "$ours" "$theirs" "$bytes"
    echo "$ours $theirs" >>"$out/$name-turns"
  done
  stop_redis
  medians "$name" talusd redis 'CPU s a million' 0
}

# figure NAME KEY: what the last run of that name came to.
figure() { sed -n "/^ *\"$2\":/{s/^[^:]*: *\([0-9.e+-]*\).*/\1/p;q}" "$out/$1.json"; }

# medians NAME FIRST SECOND UNIT MOST: of the turns' two figures and of their ratios. False where that is above MOST, if
# not 0.
medians() {
  awk -v first="$2" -v second="$3" -v unit="$4" -v most="$5" '
    { ratio[NR] = $1 / $2; one[NR] = $1; other[NR] = $2 }
    function median(of, i, j, t) {
      for (i = 2; i <= NR; ++i) for (j = i; j > 1 && of[j - 1] > of[j]; --j) { t = of[j]; of[j] = of[j - 1]; of[j - 1] = t }
      return of[int((NR + 1) / 2)]
    }
    END {
      printf "medians of %d turns: %s %.2f, %s %.2f %s; of their ratios: %.2f\n",
        NR, first, median(one), second, median(other), unit, median(ratio)
      if (most > 0 && median(ratio) > most) { print "failed: their ratio is above " most; exit 1 }
    }' "$out/$1-turns"
}

has() {
  local program
  for program in "$@"; do command -v "$program" >/dev/null || return 1; done
}

siege_pid=""

stop_siege() {
  [[ -n "$siege_pid" ]] || return 0
  kill "$siege_pid" 2>/dev/null || true
  wait "$siege_pid" 2>/dev/null || true
  siege_pid=""
}

redis_port=4791
redis_pid=""

# start_redis BYTES: a redis of this run's own, with 1,024 values of so many.
start_redis() {
  redis-server --port $redis_port --save '' --appendonly no >/dev/null 2>&1 &
  redis_pid=$!
  until timeout 2 redis-cli -p $redis_port info server 2>/dev/null | grep -q "^process_id:$redis_pid[^0-9]"; do
    kill -0 "$redis_pid" 2>/dev/null || { echo "redis-server did not start at port $redis_port; is it taken?" >&2; exit 1; }
    sleep 0.05
  done
  timeout 120 redis-benchmark -p $redis_port -t set -n 20000 -r 1024 -d "$1" -q >/dev/null
}

stop_redis() {
  [[ -n "$redis_pid" ]] || return 0
  kill "$redis_pid" 2>/dev/null || true
  wait "$redis_pid" 2>/dev/null || true
  redis_pid=""
}

# redis_turn BYTES: CPU seconds of the server alone, a million GETs; nothing where it failed.
redis_turn() {
  local count=1500000 before after
  before="$(redis_ticks)" || return 0
  timeout 120 redis-benchmark -p $redis_port -t get -n $count -r 1024 -d "$1" -c 64 -P 16 -q >/dev/null || return 0
  after="$(redis_ticks)" || return 0
  awk -v ticks=$((after - before)) -v a_second="$(getconf CLK_TCK)" -v n=$count \
    'BEGIN { printf "%.3f\n", ticks / a_second / n * 1e6 }'
}

redis_ticks() { awk '{ print $14 + $15 }' "/proc/$redis_pid/stat"; }

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

# judge NAME KEY MOST...: a line for each figure of the last run of that name that is above MOST. Nothing is judged where the
# harness was late: then the machine was too busy for any figure.
judge() {
  local name="$1" late value
  shift
  [[ -z "$short" ]] || return 0
  late="$(figure "$name" harness_late_p99_ms)"
  if awk -v late="${late:-1e9}" 'BEGIN { exit late <= 10 }'; then
    echo "void: the harness was ${late:-?} ms late"
    return 0
  fi
  while [[ $# -gt 0 ]]; do
    value="$(figure "$name" "$1")"
    if awk -v value="${value:-1e99}" -v most="$2" 'BEGIN { exit value <= most }'; then
      echo "failed: $1 is ${value:-not measured}, not $2 at most"
      failed=yes
    fi
    shift 2
  done
}

# tell NAME: the figures of a crowd of loners in one line.
tell() {
  printf '%s: p50 %s ms, p99 %s ms, late %s; %s us of server CPU a Chunk message; %s chunks generated for each sent, ' \
    "$1" "$(figure "$1" p50_ms)" "$(figure "$1" p99_ms)" "$(figure "$1" late_over_one_step)" \
    "$(figure "$1" cpu_s_per_million_messages)" "$(figure "$1" generated_per_sent)"
  printf '%s patches for each that is new; %s Chunk messages/s; two nearest rings p50 %s ms, p99 %s ms; ' \
    "$(figure "$1" patches_per_new)" "$(figure "$1" chunk_messages_per_s)" "$(figure "$1" near_p50_ms)" \
    "$(figure "$1" near_p99_ms)"
  printf 'without any chunk %s ms at most\n' "$(figure "$1" longest_without_ms)"
}

# Nothing shared. All settings are those shipped, but for what one address may do: it stands for that many players.
loners() {
  expect
  local count
  for count in $(pick "${LONERS:-1000 3000}" 8); do
    start "${no_address_rates[@]}" TALUS_ADMIN=127.0.0.1:0
    load "loners-$count" --players "$count" --model fly --speed 20 --radius "$(pick 8 4)" --ramp-up "$(pick $((count / 20)) 2)" \
      --warm-up "$(pick 10 1)" --duration "$(pick "${LONER_SECONDS:-30}" 5)" --verify "$(pick 0.2 5)" \
      --metrics "$admin" --patch-tiles 4 "${expected[@]}" || failed=yes
    tell "loners-$count"
    if ((count <= 1000)); then
      judge "loners-$count" p99_ms 50 late_over_one_step 0 cpu_s_per_million_messages 20 generated_per_sent 1.15 patches_per_new 1.1
    else
      judge "loners-$count" near_p99_ms 500 longest_without_ms 2000
    fi
  done
}

now_ms() { date +%s%3N; }

storm() {
  storm_after KILL
  storm_after TERM
}

# storm_after SIGNAL: the server gets it while its players fly, and starts again at the same port. The time that is judged
# begins when it listens again, or when the players may come back as it told them.
storm_after() {
  local name="storm-$1" players harness began down told=0
  players="$(pick 1000 10)"
  start "${no_address_rates[@]}"
  expect
  (load "$name" --players "$players" --model fly --speed 20 --radius "$(pick 8 4)" --ramp-up "$(pick 30 2)" \
    --duration "$(pick 75 12)" --verify "$(pick 0.2 5)" "${expected[@]}") &
  harness=$!
  sleep "$(pick 50 5)"  # all have joined, and been served
  listen="$address"
  began="$(now_ms)"
  kill "-$1" "$pid"
  wait "$pid" 2>/dev/null || true
  pid=""
  [[ "$1" != TERM ]] || told=5000  # as GoAway says
  start "${no_address_rates[@]}"
  down=$(($(now_ms) - began))
  listen=127.0.0.1:0
  wait "$harness" || failed=yes
  ((down > told)) || down=$told
  printf '%s: %s of %s came back; two nearest rings after the loss p50 %s ms, p99 %s ms, max %s ms, of which %s ms away\n' "$name" \
    "$(figure "$name" reconnects)" "$players" "$(figure "$name" return_p50_ms)" "$(figure "$name" return_p99_ms)" \
    "$(figure "$name" return_max_ms)" "$down"
  judge "$name" return_max_ms $((3000 + down))
}

idle() {
  expect 'idle_bytes_each>16384' 'first_chunk_max_ms>20'
  start
  load idle --idle "$(pick 10000 500)" --players "$(pick 20 4)" --model stand --radius 4 --ramp-up "$(pick 10 2)" \
    --duration "$(pick 15 4)" "${expected[@]}"
}

# beside_walkers NAME MOST ARGUMENT...: 100 walkers with what the arguments add and, by turns, without. Their p99 with it is
# to be at most MOST times that without.
beside_walkers() {
  local name="$1" most="$2" turn with without
  shift 2
  local players=(--players "$(pick 100 10)" --model walk --radius "$(pick 8 4)" --ramp-up "$(pick 5 2)"
    --warm-up "$(pick 5 1)" --duration "$(pick 20 5)")
  expect
  : >"$out/$name-turns"
  for ((turn = 1; turn <= $(pick 5 1); ++turn)); do
    start
    load walkers "${players[@]}" "${expected[@]}"
    start
    load "$name" "${players[@]}" "$@" --compare "$out/walkers.json" "${expected[@]}"
    with="$(figure "$name" p99_ms)" without="$(figure walkers p99_ms)"
    [[ -n "$with" && -n "$without" ]] || { echo "$name: turn $turn gave no figure" >&2; exit 1; }
    printf 'turn %s: p99 %s ms with, %s without\n' "$turn" "$with" "$without"
    echo "$with $without" >>"$out/$name-turns"
  done
  [[ -n "$short" ]] || medians "$name" with without 'ms p99' "$most" || failed=yes
}

greedy() { beside_walkers greedy 1.5 --greedy 1; }

slow() { beside_walkers slow 1.5 --slow 4 --slow-rate 64; }

# 250 players fly together over ground that is cached after the first. At speed 26 they want some 8,000 Chunks a second; at 30
# some 10,000, more than the rate gives.
rates() {
  local turn held free
  local players=(--players "$(pick 250 20)" --groups 1 --model fly --radius "$(pick 8 4)" --ramp-up 1 --warm-up "$(pick 5 1)"
    --duration "$(pick 10 5)" --verify 0)
  expect
  : >"$out/rates-turns"
  for ((turn = 1; turn <= $(pick 5 1); ++turn)); do
    start "${no_session_rates[@]}" "${no_address_rates[@]}" TALUS_RATES_ADDRESS_CHUNKS="$(pick 8192 200)" TALUS_RATES_BURST_MS=1000
    load rates-held "${players[@]}" --speed 30 "${expected[@]}"
    start "${no_session_rates[@]}" "${no_address_rates[@]}"
    load rates-free "${players[@]}" --speed 26 "${expected[@]}"
    held="$(figure rates-held cpu_s_per_million_messages)" free="$(figure rates-free cpu_s_per_million_messages)"
    [[ -n "$held" && -n "$free" ]] || { echo "rates: turn $turn gave no figure" >&2; exit 1; }
    printf 'turn %s: %.2f us of server CPU a Chunk message where the rate holds (%.0f/s), %.2f without (%.0f/s)\n' "$turn" "$held" \
      "$(figure rates-held chunk_messages_per_s)" "$free" "$(figure rates-free chunk_messages_per_s)"
    echo "$held $free" >>"$out/rates-turns"
  done
  [[ -n "$short" ]] || medians rates held free 'us a Chunk message' 3 || failed=yes
}

# On one server, after a run that leaves its land cached.
websocket() {
  local turn by players=(--players "$(pick 200 10)" --groups 4 --model fly --radius "$(pick 8 4)" --ramp-up 1 --warm-up "$(pick 5 1)"
    --duration "$(pick 10 4)" --verify "$(pick 0 20)")
  expect
  start "${no_session_rates[@]}" "${no_address_rates[@]}" TALUS_HTTP_LISTEN=127.0.0.1:0
  load websocket-warm-up "${players[@]}" "${expected[@]}"
  : >"$out/websocket-turns"
  for ((turn = 1; turn <= $(pick 5 1); ++turn)); do
    load by-websocket --websocket --connect "$http" "${players[@]}" "${expected[@]}"
    load by-tcp "${players[@]}" "${expected[@]}"
    for by in websocket tcp; do
      [[ -n "$(figure "by-$by" cpu_s_per_million_messages)" ]] || { echo "websocket: turn $turn gave no figure" >&2; exit 1; }
    done
    echo "$(figure by-websocket cpu_s_per_million_messages) $(figure by-tcp cpu_s_per_million_messages)" >>"$out/websocket-turns"
    echo "turn $turn: $(tail -n 1 "$out/websocket-turns") us of server CPU a Chunk message by WebSocket and by TCP"
  done
  [[ -n "$short" ]] || medians websocket WebSocket TCP 'us a Chunk message' 1.3 || failed=yes
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

churn() { churn_as churn 5; }

# The attackers outlast the players, and are told to end.
siege() {
  [[ -z "${TLS:-}" ]] || { printf '\n== siege: left out: talus-siege speaks plain TCP alone\n'; return 0; }
  churn_as siege 10
}
websocket-siege() {
  [[ -z "${TLS:-}" ]] || { printf '\n== websocket-siege: left out: talus-siege speaks no TLS\n'; return 0; }
  churn_as websocket-siege 10
}

# churn_as NAME PERCENT: resident memory may grow by so much.
churn_as() {
  expect 'errors>0' "resident_growth_percent>$2"
  [[ "$1" == *siege ]] || expected+=(--fail-if 'files_left>0')  # attackers are still there at the end
  # The caches are full before the measured time begins.
  local settings=(TALUS_CACHE_CHUNK_BYTES=33554432 TALUS_CACHE_PATCH_BYTES=33554432)
  if [[ "$1" == *siege ]]; then
    # With the rates as shipped: they are there for attackers.
    start "${settings[@]}" TALUS_HTTP_LISTEN=127.0.0.1:0
    local attacked=("${address##*:}" 86400)
    [[ "$1" == siege ]] || attacked=("${http##*:}" 86400 websocket)
    "$talus_siege" "${attacked[@]}" >"$out/siege.txt" &
    siege_pid=$!
  else
    start "${no_address_rates[@]}" "${settings[@]}"
  fi
  load "$1" --from-addresses 10 --players "$(pick 100 10)" --model walk=50,fly=25,teleport=25 --groups "$(pick 20 4)" --churn "$(pick 10 2)" \
    --radius "$(pick 6 4)" --ramp-up "$(pick 10 1)" --warm-up "$(pick 60 1)" --duration "${CHURN_SECONDS:-$(pick 1800 10)}" \
    --verify 5 "${expected[@]}"
  [[ -z "$siege_pid" ]] || { stop_siege; cat "$out/siege.txt"; }
}

scenarios=(join horizon hot groups alone loners storm idle greedy slow rates websocket pong edits churn siege websocket-siege)
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
[[ -z "$failed" ]]
