#!/usr/bin/env bash
# What a chunk by HTTP costs talusd, beside others that answer the same bytes, by turns in one run: processor time of the
# servers a request, from /proc, since a machine is seldom quiet enough for more. Results go to out/proxies-cost.
#
#   hot        by keep-alive: talusd; an epoll loop that always says the same (talus-http-floor); nginx with a static file
#   pipelined  the same, 16 deep
#   misses     Varnish in front of talusd, and in front of nginx with static files, asked for what it does not hold
#
# It fails where talusd's medians are over the marks of docs/SPEED.md.
set -euo pipefail
cd "$(dirname "$0")/../.."
out="$PWD/out/proxies-cost"
. tests/proxies/servers.sh
load="$build/tests/load/talus-http-load"
floor="$build/tests/load/talus-http-floor"
turns="${TURNS:-7}"
requests="${REQUESTS:-100000}"
failed=""

child_of() { cat "/proc/$1/task/$1/children" | awk '{ print $1 }'; }

# ticks PID...: of processor time that they have used.
ticks() {
  local pid sum=0
  for pid in "$@"; do sum=$((sum + $(sed 's/.*) //' "/proc/$pid/stat" | awk '{ print $12 + $13 }'))); done
  echo "$sum"
}

# cost VARIABLE "PID..." REQUESTS PORT CONNECTIONS DEPTH PATHS [FIELD...]: microseconds of the processes' time a request.
cost() {
  local variable="$1" servers="$2" count="$3" before after
  before="$(ticks $servers)"
  "$load" "$4" "$5" "$6" "$count" "${@:7}" >/dev/null
  after="$(ticks $servers)"
  printf -v "$variable" '%s' "$(awk -v ticks=$((after - before)) -v a_second="$(getconf CLK_TCK)" -v n="$count" \
    'BEGIN { printf "%.3f", ticks / a_second / n * 1e6 }')"
}

# judge NAME COLUMN BY MOST: the median of a column of the turns' figures, or of its ratio to column BY, is at most MOST.
judge() {
  awk -v name="$1" -v column="$2" -v by="$3" -v most="$4" '
    { value[NR] = by ? $column / $by : $column }
    END {
      for (i = 2; i <= NR; ++i) for (j = i; j > 1 && value[j - 1] > value[j]; --j) { t = value[j]; value[j] = value[j - 1]; value[j - 1] = t }
      median = value[int((NR + 1) / 2)]
      printf "%s: %.2f (of %d turns %.2f to %.2f), at most %.2f%s\n", name, median, NR, value[1], value[NR], most, (median > most) ? ": FAILED" : ""
      exit (median > most)
    }' "$out/turns" || failed=yes
}

# beside DEPTH: talusd, the floor and nginx by turns.
beside() {
  local turn ours least static
  : >"$out/turns"
  for ((turn = 1; turn <= turns; ++turn)); do
    cost ours "$talusd_pid" "$requests" "$talusd_port" 16 "$1" "$out/one"
    cost least "$floor_pid" "$requests" "$floor_port" 16 "$1" "$out/one"
    cost static "$nginx_pid" "$requests" "$nginx_port" 16 "$1" "$out/one"
    printf 'turn %s: talusd %s us, epoll loop %s us, nginx %s us a request\n' "$turn" "$ours" "$least" "$static"
    echo "$ours $least $static" >>"$out/turns"
  done
}

rm -rf "$out"
mkdir -p "$out"
has nginx
has varnishd
for port in talusd_port admin_port nginx_port floor_port before_talusd before_nginx; do free_port $port; done

start_talusd TALUS_THREADS_IO=1 TALUS_PROXIES=
fingerprint="$(curl -sS --fail "http://127.0.0.1:$talusd_port/v1/world" | sed -n 's/.*"fingerprint": *"\([0-9a-f]*\)".*/\1/p')"
root="/v1/$fingerprint/4/0"
for x in {0..63}; do for z in {0..63}; do echo "$root/$x/0/$z"; done; done >"$out/many"
# All of them as files, and in talusd's cache.
sed "s#.*#url = \"http://127.0.0.1:$talusd_port&\"\noutput = \"$out/files&\"#" "$out/many" >"$out/list"
curl -sS --fail --parallel --parallel-max 16 --create-dirs -K "$out/list" 2>/dev/null
# The one of the median size.
(cd "$out/files" && find . -type f -printf '%s %P\n') | sort -n | awk '{ path[NR] = $2 } END { print "/" path[int(NR / 2)] }' >"$out/one"
curl -sSi --fail "http://127.0.0.1:$talusd_port$(cat "$out/one")" >"$out/answer"
printf 'a chunk of %s bytes, an answer of %s\n' "$(stat -c %s "$out/files$(cat "$out/one")")" "$(stat -c %s "$out/answer")"

cat >"$out/static.conf" <<CONF
server {
  listen 127.0.0.1:$nginx_port;
  root $out/files;
  sendfile on;
  tcp_nodelay on;
  keepalive_requests 1000000000;
  open_file_cache max=10000 inactive=1h;
  open_file_cache_valid 1h;
  default_type application/octet-stream;
  expires max;
}
CONF
start_nginx nginx "$nginx_port" "$out/static.conf"
nginx_pid="$(child_of "${pids[-1]}")"
chmod -R a+rX "$out"
"$floor" "$floor_port" "$out/answer" &
floor_pid=$!
pids+=($floor_pid)
await "$floor_port" $floor_pid floor

printf '\n== hot, by keep-alive on 16 connections\n'
beside 1
judge 'hot: talusd to an epoll loop' 1 2 1.3
judge 'hot: talusd to nginx with a static file' 1 3 1.0
printf '\n== 16 deep pipelined on 16 connections\n'
beside 16
judge 'pipelined: us a request' 1 0 3

printf '\n== misses of Varnish: it and who is behind it\n'
cp docker/varnish/rules.vcl "$out/"
for backend in talusd nginx; do
  port="${backend}_port" before="before_$backend"
  { sed "s#\"4782\"#\"${!port}\"#" docker/varnish/talus.vcl; echo 'sub vcl_hash { hash_data(req.http.X-Turn); }'; } >"$out/$backend.vcl"
  start_varnish "varnish-$backend" "${!before}" "$out/$backend.vcl"
  printf -v "varnish_$backend" '%s' "$(child_of "${pids[-1]}")"
done
: >"$out/turns"
for ((turn = 1; turn <= turns; ++turn)); do
  cost ours "$varnish_talusd $talusd_pid" 4096 "$before_talusd" 16 1 "$out/many" "X-Turn: $turn"
  cost static "$varnish_nginx $nginx_pid" 4096 "$before_nginx" 16 1 "$out/many" "X-Turn: $turn"
  printf 'turn %s: before talusd %s us, before nginx %s us a miss\n' "$turn" "$ours" "$static"
  echo "$ours $static" >>"$out/turns"
done
judge 'misses: processor time before talusd to that before nginx' 1 2 1.43
[[ -z "$failed" ]]
