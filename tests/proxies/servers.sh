# Starts talusd and the proxies for the scripts of this folder, with the configurations that ship, changed in their addresses
# and folders alone; ends them with the script. The script sets `out`, an absolute folder.

build="${BUILD:-build/release}"
talusd="$build/server/talusd"
pids=()

die() { printf 'failed: %s\n' "$*" >&2; exit 1; }

stop() {
  local pid
  for pid in "${pids[@]}"; do kill -TERM "$pid" 2>/dev/null || true; done
  for pid in "${pids[@]}"; do wait "$pid" 2>/dev/null || true; done
  pids=()
}
trap stop EXIT
trap 'exit 130' INT TERM

PATH="$PATH:/usr/sbin"
has() { command -v "$1" >/dev/null || die "$1 is not installed; ./dev deps proxies"; }

# free_port VARIABLE: a port that nobody has now. Below those that the system deals out, so that it stays free.
next_port=$((20000 + RANDOM % 8000))
free_port() {
  while (: <"/dev/tcp/127.0.0.1/$next_port") 2>/dev/null; do next_port=$((next_port + 1)); done
  printf -v "$1" '%s' "$next_port"
  next_port=$((next_port + 1))
}

# await PORT PID NAME: until somebody listens there.
await() {
  until (: <"/dev/tcp/127.0.0.1/$1") 2>/dev/null; do
    kill -0 "$2" 2>/dev/null || { cat "$out/$3.log" >&2; die "$3 did not start"; }
    sleep 0.05
  done
}

# start_talusd [VARIABLE=value...]: without rates unless told.
start_talusd() {
  env TALUS_WORLD=core/worlds/classic.toml TALUS_LOG_LEVEL=warning TALUS_PROXIES=127.0.0.1 \
    TALUS_RATES_ADDRESS_REQUESTS=0 TALUS_RATES_ADDRESS_CHUNKS=0 TALUS_RATES_ADDRESS_BYTES=0 \
    TALUS_RATES_SESSION_REQUESTS=0 TALUS_RATES_SESSION_CHUNKS=0 TALUS_RATES_SESSION_BYTES=0 "$@" \
    "$talusd" --listen 127.0.0.1:0 --http "127.0.0.1:$talusd_port" --admin "127.0.0.1:$admin_port" >"$out/talusd.log" 2>&1 &
  talusd_pid=$!
  pids+=($talusd_pid)
  await "$talusd_port" $talusd_pid talusd
  await "$admin_port" $talusd_pid talusd
}

stop_talusd() {
  kill -TERM "$talusd_pid"
  wait "$talusd_pid" || die "talusd ended with $?"
}

# start_nginx NAME PORT FILE: with that file for conf.d.
start_nginx() {
  local folder="$out/$1"
  mkdir -p "$folder"
  cat >"$folder/nginx.conf" <<CONF
daemon off;
worker_processes 1;
pid $folder/pid;
error_log $out/$1.log warn;
events { worker_connections 1024; }
http {
  access_log off;
  client_body_temp_path $folder/body;
  proxy_temp_path $folder/proxy;
  fastcgi_temp_path $folder/fastcgi;
  uwsgi_temp_path $folder/uwsgi;
  scgi_temp_path $folder/scgi;
  include $3;
}
CONF
  chmod -R a+rwX "$folder"
  nginx -p "$folder" -e "$out/$1.log" -c "$folder/nginx.conf" &
  pids+=($!)
  await "$2" $! "$1"
}

# start_varnish NAME PORT FILE: with that VCL.
start_varnish() {
  mkdir -p "$out/$1"
  varnishd -F -n "$out/$1/work" -a "127.0.0.1:$2" -a "[::1]:$2" -f "$3" -s malloc,256m -T none >"$out/$1.log" 2>&1 &
  pids+=($!)
  await "$2" $! "$1"
}
