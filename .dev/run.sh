# shellcheck shell=bash
# ./dev demo, ./dev run and ./dev cluster.

# check_address VARIABLE: refuses a value that is not HOST:PORT.
check_address() {
  local value="${!1:-}"
  [[ -z "$value" ]] || { [[ "$value" =~ ^(\[[0-9a-fA-F:.]+\]|[^]:[]+):([0-9]{1,5})$ ]] && ((10#${BASH_REMATCH[2]} <= 65535)); } ||
    wrong_use "run: $1: '$value' is not HOST:PORT"
}

# taken HOST:PORT: returns true if something listens there.
taken() { (exec 8<>"/dev/tcp/${1%:*}/${1##*:}") 2>/dev/null; }

demo() {
  (($# <= 1)) || wrong_use "demo: '$2' is not an argument; it takes a port"
  local port="${1:-8080}"
  [[ "$port" =~ ^[1-9][0-9]{0,4}$ ]] && ((port <= 65535)) || wrong_use "demo: '$port' is not a port from 1 to 65535"
  command -v python3 >/dev/null || die "demo: python3 serves the files, and is not there: apt-get install python3"
  ! taken "127.0.0.1:$port" || die "demo: something listens at 127.0.0.1:$port already; ./dev demo PORT takes another port"
  mkdir -p out
  say "the viewer, until Ctrl-C: http://127.0.0.1:$port/"
  exec python3 -m http.server --bind 127.0.0.1 --directory client_sample/web/viewer/dist "$port" >out/demo.log 2>&1
}

build_programs() {
  say "building release: talusd talus-client talus_viewer"
  configure release -DTALUS_TESTS=OFF -DTALUS_BENCH=OFF -DTALUS_QUICK=ON -DTALUS_WARNINGS_AS_ERRORS=OFF
  compile release talusd talus-client talus_viewer
}

run() {
  (($# <= 1)) || wrong_use "run: '$2' is not an argument; it takes the seconds of the flight"
  local seconds="${1:-8}"
  [[ "$seconds" =~ ^[1-9][0-9]{0,3}$ ]] || wrong_use "run: '$seconds' is not a number of seconds from 1 to 9999"
  [[ -z "${TALUS_HTTP:-}" ]] || wrong_use "run: TALUS_HTTP is not a setting; TALUS_HTTP_LISTEN=HOST:PORT gives the address of HTTP"
  [[ -z "${TALUS_WORLD:-}" || -f "$TALUS_WORLD" ]] || wrong_use "run: TALUS_WORLD: $TALUS_WORLD is not a file"
  check_address TALUS_LISTEN
  check_address TALUS_HTTP_LISTEN
  local listen="${TALUS_LISTEN:-127.0.0.1:4780}" http="${TALUS_HTTP_LISTEN:-}"
  mkdir -p out
  # The log and the pictures are one run's. The server holds the lock as long as it runs.
  exec 9>out/run.lock
  flock -n 9 || die "another ./dev run runs in this folder; end it first"
  ! taken "$listen" || die "run: $listen is in use; TALUS_LISTEN=127.0.0.1:0 ./dev run takes any free port"
  if [[ -z "$http" ]]; then
    http=127.0.0.1:4782
    if taken "$http"; then
      say "port 4782 is in use: HTTP gets another one"
      http=127.0.0.1:0
    fi
  elif taken "$http"; then
    die "run: $http is in use; TALUS_HTTP_LISTEN=127.0.0.1:0 ./dev run takes any free port"
  fi

  local began packages compiled cpu_before cpu_after
  began="$(now_ms)"
  deps build
  packages="$(now_ms)"
  cpu_ms cpu_before
  build_programs 9>&-
  cpu_ms cpu_after
  compiled="$(now_ms)"
  say "starting talusd (log: out/talusd.log)"
  : >out/talusd.log
  local flags=()
  [[ -f build/release/web/index.html ]] && flags=(--web build/release/web)
  TALUS_LISTEN="$listen" TALUS_HTTP_LISTEN="$http" TALUS_PUBLISH="${TALUS_PUBLISH:-public}" build/release/server/talusd "${flags[@]}" >out/talusd.log 2>&1 &
  local server=$!
  trap 'trap - EXIT; kill -TERM $(jobs -p) 2>/dev/null || true; wait; exit 0' INT TERM
  trap 'kill -TERM $(jobs -p) 2>/dev/null || true' EXIT
  local address="" web=""
  until address="$(sed -n 's/.*listening on \([^ ]*\).*/\1/p' out/talusd.log | head -n 1)" && [[ -n "$address" ]] &&
    web="$(sed -n 's/^HTTP and WebSocket on //p' out/talusd.log)" && [[ -n "$web" ]]; do
    kill -0 $server 2>/dev/null || { cat out/talusd.log >&2; die "talusd did not start"; }
    sleep 0.05
  done
  address="${address/0.0.0.0/127.0.0.1}"
  web="${web/0.0.0.0/127.0.0.1}"
  local walk="the world over HTTP: $web/v1/world"
  ((!${#flags[@]})) || walk="walk through the world in a browser: $web/"
  say "$walk"
  say "flying over its world for $seconds seconds"
  # Beside the shell, so that a signal to it alone is not kept waiting.
  aloud "flying" build/release/client_sample/cli/talus-client --connect "$address" fly --seconds "$seconds" --speed 15 \
    -o out/map.png --view out/view.png 9>&- &
  wait $!
  printf 'first picture after %d s: packages %d s, compiling %d s (%d s of processor time), flight %d s\n' \
    $((($(now_ms) - began + 500) / 1000)) $(((packages - began + 500) / 1000)) $(((compiled - packages + 500) / 1000)) \
    $(((cpu_after - cpu_before + 500) / 1000)) $((($(now_ms) - compiled + 500) / 1000)) >&2
  say "what the client saw: $PWD/out/view.png"
  say "the map of the chunks along its path (line: the flight; circle: its end; hatched: not asked for): $PWD/out/map.png"
  say "the server listens on $address; connect with: build/release/client_sample/cli/talus-client --connect $address map -o m.png"
  say "$walk"
  say "Ctrl-C stops it"
  wait $server
}

cluster() {
  docker/cluster/local.sh --check "$@"
  deps build cluster
  build_programs
  exec docker/cluster/local.sh "$@"
}
