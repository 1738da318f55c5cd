#!/usr/bin/env bash
# A cluster on this machine, of the files that ship: docker/nats, docker/haproxy, docker/varnish, changed in their addresses
# and folders alone. All of it listens on 127.0.0.1 and lives in a scratch directory. ./dev cluster builds and runs it.
set -euo pipefail
cd "$(dirname "$0")/../.."

usage() {
  cat <<'USAGE'
usage: ./dev cluster [--servers N] [--nats N] [--port P] [--world FILE] [--keep]

Starts nats-servers with their log of edits, talusd, HAProxy and Varnish on 127.0.0.1, says where they are, and ends them all
on Ctrl-C. Whoever connects may edit.

  --servers N    talusd, 1 to 9 (3 unless told otherwise)
  --nats N       nats-servers: 1, 3 or 5 (3)
  --port P       players connect to port P (4780); all others are above it, up to P + 69, and those of places
                 from P + 100 to P + 163
  --world FILE   the world's spec (the world built into talusd)
  --keep         leaves the scratch directory, with its logs, behind
USAGE
}
# What is said goes to descriptor 3: while all runs, standard error has only the shell's own words about children that were killed.
exec 3>&2
say() { printf '\033[1m==> %s\033[0m\n' "$*" >&3; }
die() { printf 'cluster: %s\n' "$*" >&3; exit 1; }
wrong_use() { printf 'cluster: %s\n' "$*" >&2; exit 2; }

servers=3 nats=3 port=4780 keep=0 check=0 world=""
while (($#)); do
  case "$1" in
    -h | --help) usage; exit 0 ;;
    --servers | --nats | --port | --world)
      (($# > 1)) || wrong_use "$1 wants a value; --help lists them"
      printf -v "${1#--}" '%s' "$2"
      shift
      ;;
    --keep) keep=1 ;;
    --check) check=1 ;;  # of ./dev, before it compiles
    *) wrong_use "'$1' is not one of --servers, --nats, --port, --world, --keep, --help" ;;
  esac
  shift
done
[[ "$servers" =~ ^[1-9]$ ]] || wrong_use "--servers: '$servers' is not 1 to 9"
[[ "$nats" =~ ^[135]$ ]] || wrong_use "--nats: '$nats' is not 1, 3 or 5"
[[ "$port" =~ ^[1-9][0-9]{0,4}$ ]] && ((port <= 65372)) || wrong_use "--port: '$port' is not 1 to 65372"
[[ -z "$world" || -f "$world" ]] || wrong_use "--world: $world is no file"
((!check)) || exit 0

PATH="$PATH:/usr/sbin"
build="$(realpath -m "${BUILD:-build/release}")"
talusd="$build/server/talusd"
talus_client="$build/client_sample/cli/talus-client"
[[ -x "$talusd" ]] || die "$talusd is not there; ./dev cluster builds it"
for program in nats-server haproxy varnishd curl openssl; do
  command -v "$program" >/dev/null || die "$program is not installed; ./dev deps cluster"
done

# Ports: players; HTTP by Varnish, HTTP by HAProxy, HAProxy's page; three for each nats-server and each talusd.
web=$((port + 2)) balancer=$((port + 3)) stats=$((port + 4))
nats_port() { echo $((port + 10 + 3 * $1 + $2)); }     # clients, routes, operators
server_port() { echo $((port + 40 + 3 * $1 + $2)); }   # players, operators, HTTP
# HAProxy comes from an address of its own, so that talusd knows it from players who go to a server themselves.
proxy=127.0.0.9

taken() { (: <"/dev/tcp/127.0.0.1/$1") 2>/dev/null; }
want_free() { ! taken "$1" || die "port $1, for $2, is taken: ss -ltnp names who has it; --port moves all of them"; }
want_free "$port" players
want_free "$web" HTTP
want_free "$balancer" "HAProxy's HTTP"
want_free "$stats" "HAProxy's page"
for ((i = 0; i < nats; ++i)); do for j in 0 1 2; do want_free "$(nats_port $i $j)" "nats-$i"; done; done
for ((i = 0; i < servers; ++i)); do for j in 0 1 2; do want_free "$(server_port $i $j)" "talus-$i"; done; done

scratch="$(mktemp -d "${TMPDIR:-/tmp}/talus-cluster.XXXXXX")"
chmod 700 "$scratch"
declare -A name_of=()   # by process

# end NAME...: those whose names begin so, all at once.
end() {
  local process prefix those=()
  for process in "${!name_of[@]}"; do
    for prefix in "$@"; do [[ "${name_of[$process]}" != "$prefix"* ]] || those+=("$process"); done
  done
  ((${#those[@]})) || return 0
  kill -TERM "${those[@]}" 2>/dev/null || true
  for process in "${those[@]}"; do wait "$process" 2>/dev/null || true; unset "name_of[$process]"; done
}
# What somebody has started again by the command that was printed is no child of this shell.
end_restarted() {
  local process those=() tries
  for process in /proc/[0-9]*; do
    if [[ "${process#/proc/}" != "$$" ]] && grep -qaF -- "$scratch/" "$process/cmdline" 2>/dev/null; then those+=("${process#/proc/}"); fi
  done
  ((${#those[@]})) || return 0
  kill -TERM "${those[@]}" 2>/dev/null || true
  for ((tries = 0; tries < 100; ++tries)); do
    kill -0 "${those[@]}" 2>/dev/null || return 0
    sleep 0.1
  done
  kill -KILL "${those[@]}" 2>/dev/null || true
}
finish() {
  trap '' INT TERM
  # The log last: servers that end have edits under way.
  end haproxy varnish
  end talus
  end nats
  end_restarted
  if ((keep)); then say "kept: $scratch"; else rm -rf --one-file-system "$scratch" 2>&3; fi
}
trap finish EXIT
trap 'exit 0' INT TERM

# start NAME COMMAND...: in the background, not to be reached by Ctrl-C itself; its log is NAME.log.
start() {
  local name="$1"
  shift
  printf '%q ' "$@" >"$scratch/$name.command"
  setsid "$@" >>"$scratch/$name.log" 2>&1 </dev/null 3>&- &
  name_of[$!]="$name"
  last=$!
}

# await NAME PROCESS COMMAND...: until the command succeeds.
await() {
  local name="$1" process="$2"
  shift 2
  until "$@"; do
    kill -0 "$process" 2>/dev/null || { tail -n 5 "$scratch/$name.log" >&2; keep=1; die "$name has ended; all it said: $scratch/$name.log"; }
    ((SECONDS < give_up)) || { tail -n 5 "$scratch/$name.log" >&2; keep=1; die "$name is not ready after a minute; all it said: $scratch/$name.log"; }
    sleep 0.05
  done
}
answers() { curl -s -f -o /dev/null --max-time 2 "$1"; }

hosts=() routes="" addresses=""
for ((i = 0; i < nats; ++i)); do
  hosts+=("nats-$i,localhost")
  routes+="    \"tls://localhost:$(nats_port $i 1)\"\n"
  addresses+="${addresses:+, }\"tls://localhost:$(nats_port $i 0)\""
done
docker/nats/certificates.sh "$scratch/secrets" "${hosts[@]}" >/dev/null
cp docker/nats/permissions.conf "$scratch/"

say "starting $nats nats-server"
give_up=$((SECONDS + 60))
processes=()
for ((i = 0; i < nats; ++i)); do
  mkdir "$scratch/nats-$i" "$scratch/nats-$i/tls"
  cp "$scratch/secrets/ca.pem" "$scratch/nats-$i/tls/ca.pem"
  cp "$scratch/secrets/nats-$i.pem" "$scratch/nats-$i/tls/certificate.pem"
  cp "$scratch/secrets/nats-$i-key.pem" "$scratch/nats-$i/tls/key.pem"
  # One nats-server alone is no cluster.
  sed -e "s#0.0.0.0:4222#127.0.0.1:$(nats_port $i 0)#; s#0.0.0.0:6222#127.0.0.1:$(nats_port $i 1)#" \
    -e "s#/etc/nats/tls#$scratch/nats-$i/tls#; s#/var/lib/nats#$scratch/nats-$i/data#; s#include \"#include \"../#" \
    -e "s#^    \"tls://nats-0:6222\"#$routes#; /tls:\/\/nats-[0-9]:6222/d" docker/nats/nats-server.conf |
    if ((nats == 1)); then sed '/^cluster {/,/^}/d'; else cat; fi >"$scratch/nats-$i/nats-server.conf"
  start "nats-$i" env "NATS_NAME=nats-$i" "NATS_MONITOR=127.0.0.1:$(nats_port $i 2)" nats-server -c "$scratch/nats-$i/nats-server.conf"
  processes+=("$last")
done
for ((i = 0; i < nats; ++i)); do await "nats-$i" "${processes[$i]}" answers "http://127.0.0.1:$(nats_port $i 2)/healthz"; done

store="$(openssl rand -hex 16)"
openssl rand -base64 32 >"$scratch/secrets/signing_key"
"$talusd" token --key-file "$scratch/secrets/signing_key" --subject peers --rights read,admin --valid 8760h >"$scratch/secrets/peers_token"
chmod 600 "$scratch/secrets/signing_key" "$scratch/secrets/peers_token"
peers=""
for ((i = 0; i < servers; ++i)); do peers+="${peers:+, }\"http://127.0.0.1:$(server_port $i 1)\""; done

# settings CERTIFICATE: what all have of [cluster], and talusd.toml's top.
settings() {
  [[ -z "$world" ]] || printf 'world = "%s"\n' "$(realpath "$world")"
  cat <<TOML
[cluster]
nats = [$addresses]
store = "$store"
replicas = $nats
ca = "$scratch/secrets/ca.pem"
certificate = "$scratch/secrets/$1.pem"
key = "$scratch/secrets/$1-key.pem"
TOML
}

say "making the log"
settings talus-admin >"$scratch/init.toml"
"$talusd" cluster init --config "$scratch/init.toml" >"$scratch/init.log" 2>&1 || { keep=1; cat "$scratch/init.log" >&2; die "talusd cluster init failed: $scratch/init.log"; }

say "starting $servers talusd"
give_up=$((SECONDS + 60))
processes=()
site="$build/web"
for ((i = 0; i < servers; ++i)); do
  {
    cat <<TOML
listen = "127.0.0.1:$(server_port $i 0)"
admin = "127.0.0.1:$(server_port $i 1)"
data = "$scratch/talus-$i"
publish = "public"
proxies = "$proxy"
TOML
    settings talusd
    cat <<TOML
peers = [$peers]
peers_token_file = "$scratch/secrets/peers_token"
[access]
signing_key_file = "$scratch/secrets/signing_key"
without_token = "read,edit"
[http]
listen = "127.0.0.1:$(server_port $i 2)"
$([[ ! -f "$site/index.html" ]] || echo "web = \"$site\"")
[shutdown]
lead_ms = 3000
TOML
  } >"$scratch/talus-$i.toml"
  start "talus-$i" "$talusd" --config "$scratch/talus-$i.toml"
  processes+=("$last")
done
for ((i = 0; i < servers; ++i)); do await "talus-$i" "${processes[$i]}" answers "http://127.0.0.1:$(server_port $i 1)/-/ready"; done

# HAProxy's file names three servers in each backend; each such list becomes one of ours.
say "starting HAProxy and Varnish"
awk -v servers="$servers" -v port="$port" '
  /^ *server talus-[0-9]+ / {
    if ($2 != "talus-0") next
    kind = $3 ~ /:4782$/ ? 2 : 0
    for (i = 0; i < servers; ++i) printf "    server talus-%d 127.0.0.1:%d check port %d\n", i, port + 40 + 3 * i + kind, port + 41 + 3 * i
    next
  }
  { print }' docker/haproxy/haproxy.cfg |
  sed -e "s#bind :4780#bind 127.0.0.1:$port#; s#ports=4780 #ports=$port #; s#bind :80\$#bind 127.0.0.1:$balancer#" \
    -e "s#bind :4800-4863#bind 127.0.0.1:$((port + 100))-$((port + 163))#; s#ports=4800-4863 #ports=$((port + 100))-$((port + 163)) #" \
    -e "0,/default-server check/s#default-server check#default-server source $proxy check#" >"$scratch/haproxy.cfg"
sed -e "s#bind :8404#bind 127.0.0.1:$stats#" docker/haproxy/stats.cfg >"$scratch/stats.cfg"
start haproxy haproxy -W -db -f "$scratch/haproxy.cfg" -f "$scratch/stats.cfg"
give_up=$((SECONDS + 60))
await haproxy "$last" answers "http://127.0.0.1:$balancer/v1/world"
cp docker/varnish/rules.vcl "$scratch/"
sed -e "s#\"haproxy\"#\"127.0.0.1\"#; s#\"80\"#\"$balancer\"#" docker/varnish/cluster.vcl >"$scratch/cluster.vcl"
mkdir "$scratch/varnish"
# Varnish's own child is another user where root starts it: it may pass, and read what lies there.
chmod 711 "$scratch"
start varnish varnishd -F -n "$scratch/varnish/work" -a "127.0.0.1:$web" -f "$scratch/cluster.vcl" -s malloc,256m -T none
await varnish "$last" answers "http://127.0.0.1:$web/v1/world"

{
  printf '\n%-10s %-18s %-26s %-26s %s\n' "" players operators HTTP log
  for ((i = 0; i < nats; ++i)); do
    printf '%-10s %-18s %-26s %-26s %s\n' "nats-$i" "" "http://127.0.0.1:$(nats_port $i 2)" "" "$scratch/nats-$i.log"
  done
  for ((i = 0; i < servers; ++i)); do
    printf '%-10s %-18s %-26s %-26s %s\n' "talus-$i" "127.0.0.1:$(server_port $i 0)" "http://127.0.0.1:$(server_port $i 1)" \
      "http://127.0.0.1:$(server_port $i 2)" "$scratch/talus-$i.log"
  done
  printf '%-10s %-18s %-26s %-26s %s\n' haproxy "127.0.0.1:$port" "http://127.0.0.1:$stats" "http://127.0.0.1:$balancer" "$scratch/haproxy.log"
  printf '%-10s %-18s %-26s %-26s %s\n\n' varnish "" "" "http://127.0.0.1:$web" "$scratch/varnish.log"
} >&2
say "players connect to 127.0.0.1:$port; try: $talus_client --connect 127.0.0.1:$port edit 0,200,0 --material granite"
say "the world over HTTP: http://127.0.0.1:$web/v1/world$([[ ! -f "$site/index.html" ]] || echo ", and in a browser: http://127.0.0.1:$web/")"
say "the log's state: $talusd cluster status --config $scratch/talus-0.toml"
say "Ctrl-C ends it all"

# What ends by itself, or is killed to see what happens, is told; the rest goes on. Each is looked at: "wait -n" knows nothing of those
# that ended together with another.
exec 2>/dev/null
while ((${#name_of[@]})); do
  sleep 0.2
  for process in "${!name_of[@]}"; do
    kill -0 "$process" && continue
    name="${name_of[$process]}"
    unset "name_of[$process]"
    status=0
    wait "$process" || status=$?
    say "$name has ended with status $status; start it again by: $(<"$scratch/$name.command")>>$scratch/$name.log 2>&1 &"
  done
done
die "nothing runs any more"
