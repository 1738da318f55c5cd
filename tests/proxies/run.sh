#!/usr/bin/env bash
# nginx and Varnish really in front of talusd, with the configurations that ship: docker/nginx/talus.conf and
# docker/varnish/talus.vcl, changed in their addresses and folders alone. Results go to out/proxies.
#
#   - a flight over the same land twice: at most 1 % of the second flight's requests reach talusd
#   - an edit is seen through the caches once they ask again, and what has edits is kept by them for ever
#   - every answer is talusd's own, byte for byte, also while talusd is away
#   - queries, Accept-Encodings, Origins and Hosts that anybody makes up do not fill a cache
#   - the viewer opens while talusd is away, and as it is now once talusd is there
#   - a client behind a proxy is held by the rates of its own address, whatever it claims to be, and no other client is
#   - players by WebSocket get what is right
set -euo pipefail
cd "$(dirname "$0")/../.."

out="$PWD/out/proxies"
. tests/proxies/servers.sh
talus_load="$build/client_sample/load/talus-load"
talus_client="$build/client_sample/cli/talus-client"

# The paths of a flight: what a player with Views of 4 columns' radius wants along 48 chunks, in columns of level 0, single
# chunks where it stands, and squares of level 3 around.
flight() {
  local root="$1" step x z
  for ((step = 0; step < 48; ++step)); do
    for z in {-4..4}; do
      if ((step == 0)); then
        for x in {-4..4}; do echo "$root/0/$x/$z"; done
      else
        echo "$root/0/$((step + 4))/$z"
      fi
    done
    echo "$root/0/$step/0/0"
    ((step % 4 != 0)) || for z in -8 -4 0 4; do echo "$root/3/$((step + 8))/$z/4x4"; done
  done
}

# fetch PORT FOLDER [curl option...]: the flight's answers, each in a file. All must be 200.
fetch() {
  local port="$1" folder="$out/$2" number=0 path
  shift 2
  rm -rf "$folder"
  mkdir -p "$folder"
  while read -r path; do
    printf 'url = "http://127.0.0.1:%s%s"\noutput = "%s/%s"\n' "$port" "$path" "$folder" "$((++number))"
  done <"$out/paths" >"$out/list"
  curl -sS --fail --parallel --parallel-max 8 --interface 127.0.0.2 "$@" -K "$out/list" 2>"$out/curl.log" || die "not all of the flight came by port $port"
}

# answered: how many requests talusd has answered.
answered() {
  curl -sS --fail "http://127.0.0.1:$admin_port/metrics" | awk '/^talus_http_responses_total/ { sum += $2 } END { print sum + 0 }'
}

# same FOLDER: its answers are talusd's own.
same() { diff -rq "$out/own" "$out/$1" >/dev/null || die "$1 differs from talusd's own answers"; }

# fly_twice NAME PORT
fly_twice() {
  local name="$1" port="$2" requests before after
  requests="$(wc -l <"$out/paths")"
  fetch "$port" "$name-first"
  same "$name-first"
  before="$(answered)"
  fetch "$port" "$name-second"
  after="$(answered)"
  same "$name-second"
  awk -v name="$name" -v n="$requests" -v through=$((after - before)) 'BEGIN {
    hits = 100 * (1 - through / n)
    printf "%s: %d requests of the second flight, %.2f %% hits\n", name, n, hits
    exit hits < 99
  }' || die "$name: too many requests of the second flight reached talusd"
}

# through PORT PATH FILE: an answer, and its head in FILE.head. It prints the status.
through() {
  curl -sS -o "$out/$3" -D "$out/$3.head" -w '%{http_code}\n' --interface 127.0.0.2 -H 'X-Forwarded-For: 127.0.0.2' \
    "http://127.0.0.1:$1$2"
}

# columns_in FILE: the edited columns of a region, a line for each: "place revision".
columns_in() { od -An -v -tu1 -w10 -j4 "$out/$1" | awk '{ print $1 + 256 * $2, $3 + 256 * $4 + 65536 * $5 }'; }

# The region of the origin, and the revision of its column 3, 3, which is edited by `edit_column`.
region() { echo "/v1/$fingerprint/$store/edits/0/0/0"; }
revision_through() {
  [[ "$(through "$1" "$(region)" region)" == 200 ]] || return 0
  columns_in region | awk '$1 == 99 { print $2 }'
}
# By WebSocket through the proxy of that port.
edit_column() {
  "$talus_client" --connect "ws://[::1]:$1" edit "100,200,100" --material "$2" >/dev/null || die "no edit"
}

# edits_seen NAME PORT: what is built is there within seconds, though all was in the cache before; and is kept.
edits_seen() {
  local name="$1" port="$2" before now column
  through "$port" "/v1/$fingerprint/4/0/3/3" base >/dev/null
  before="$(revision_through "$port")"
  edit_column "$port" "$3"
  until now="$(revision_through "$port")" && [[ -n "$now" && "$now" != "$before" ]]; do
    kill -0 "$talusd_pid" || die "talusd has ended"
  done
  column="/v1/$fingerprint/$store/4/0/3/3@$now"
  [[ "$(through "$port" "$column" edited)" == 200 ]] || die "$name: no column of revision $now"
  ! cmp -s "$out/base" "$out/edited" || die "$name: the column of revision $now has no edit"
  through "$port" "$column" edited >/dev/null
  grep -qi '^x-cache: *hit' "$out/edited.head" || die "$name does not keep what has edits"
  [[ "$(through "$port" "/v1/$fingerprint/$store/4/0/3/3@$((now + 7))" moved)" == 307 ]] || die "$name: another revision is no 307"
  grep -qi "^location: *3@$now" "$out/moved.head" || die "$name: where the newest revision is was not told"
  printf '%s: an edit is seen, and its column kept\n' "$name"
}

# site_through NAME PORT: the viewer's pages and assets are those of `site`.
site_through() {
  local file
  while read -r file; do
    [[ "$(through "$2" "/$file" file)" == 200 ]] || die "$1: no /$file"
    cmp -s "$out/file" "$site/$file" || die "$1: another /$file"
  done < <(cd "$site" && find . -type f -printf '%P\n')
  [[ "$(through "$2" / file)" == 200 ]] && cmp -s "$out/file" "$site/index.html" || die "$1: no page at /"
}

# site_kept NAME PORT: the viewer comes, and its assets from the cache.
site_kept() {
  local asset
  site_through "$1" "$2"
  for asset in "$site"/assets/*; do
    [[ "$(through "$2" "/assets/${asset##*/}" file)" == 200 ]] && grep -qi '^x-cache: *hit' "$out/file.head" ||
      die "$1 does not keep $asset"
  done
}

# objects NAME: how many answers a proxy keeps.
objects() {
  if [[ "$1" == nginx ]]; then
    find "$out/nginx/cache" -type f | wc -l
  else
    varnishstat -1 -n "$out/varnish/work" -f MAIN.n_object | awk '{ print $2 }'
  fi
}

# made_up NAME PORT: queries of the viewer's files, Accept-Encodings, Origins and Hosts that anybody makes up add no copies,
# but for the three forms of a file.
made_up() {
  local name="$1" port="$2" before after number path chunk="/v1/$fingerprint/4/0/0/0" deadline=$((SECONDS + 30))
  local asset="/assets/$(cd "$site/assets" && ls ./*.js | sed -n '1s#^./##p')"
  # asked PATH FIELD...
  asked() {
    printf 'next\nfail\nsilent\nshow-error\ninterface = 127.0.0.2\noutput = /dev/null\nurl = "http://127.0.0.1:%s%s"\n' "$port" "$1"
    printf 'header = "%s"\n' "${@:2}"
  }
  before="$(objects "$name")"
  for number in {1..40}; do
    asked "$asset?$number" "Accept-Encoding: br, made-up-$number"
    asked "/?$number" "Accept-Encoding: gzip;q=0.$number"
    for path in "$chunk" /v1/world "$(region)"; do
      asked "$path" "Origin: https://made-up-$number.example"
      asked "$path" "Host: made-up-$number.example" "Origin: http://made-up-$number.example"
      asked "$path" "Host: made-up-$number.example"
    done
  done | sed 1d >"$out/list"
  curl -K "$out/list" >"$out/curl.log" 2>&1 || die "$name: not all came that was made up"
  # Varnish knows for a second what is not kept.
  until after="$(objects "$name")" && ((after <= before + 8)); do
    ((SECONDS < deadline)) || die "$name keeps $((after - before)) answers more for what was made up"
  done
  printf '%s: of 440 requests with fields and queries that were made up it keeps %s answers\n' "$name" "$((after - before))"
}

# listed_origin NAME PORT: who asks from an origin that is listed gets what is kept, and it is told that it may read it.
listed_origin() {
  local turn
  for turn in 1 2; do
    curl -sS --fail -o /dev/null -D "$out/listed.head" --interface 127.0.0.2 -H 'Origin: https://play.example' \
      "http://127.0.0.1:$2/v1/$fingerprint/4/0/0/0"
  done
  grep -qi '^access-control-allow-origin: https://play.example' "$out/listed.head" || die "$1: a listed origin may not read"
  grep -qi '^x-cache: *hit' "$out/listed.head" || die "$1 does not keep what a listed origin asks for"
}

# new_page NAME PORT: once talusd has another page, it is seen.
new_page() {
  until [[ "$(through "$2" / file)" == 200 ]] && cmp -s "$out/file" "$site/index.html"; do
    kill -0 "$talusd_pid" || die "talusd has ended"
  done
  printf '%s: the viewer opens while talusd is away, and its new page is seen\n' "$1"
}

# without_talusd NAME PORT: the land seen before, and which world it is.
without_talusd() {
  fetch "$2" "$1-away"
  same "$1-away"
  curl -sS --fail --interface 127.0.0.2 "http://127.0.0.1:$2/v1/world" | cmp -s - "$out/world" ||
    die "$1 has no right /v1/world while talusd is away"
  [[ -n "$(revision_through "$2")" ]] || die "$1 does not say what was edited while talusd is away"
  [[ "$(through "$2" "/v1/$fingerprint/$store/4/0/3/3@$(revision_through "$2")" away)" == 200 ]] ||
    die "$1 has no land with edits while talusd is away"
  site_through "$1" "$2"
  printf '%s: all right while talusd is away\n' "$1"
}

# statuses PORT ADDRESS COLUMNS: of requests that no cache answers, from that address, with a claim to be another. All at once.
statuses() {
  curl -sS -o /dev/null -w '%{http_code}\n' --interface "$2" -H 'X-Forwarded-For: 198.51.100.7' \
    "http://127.0.0.1:$1/v1/heights?columns=$3,1"
}

# rates_behind NAME PORT FIRST-ADDRESS SECOND-ADDRESS: talusd grants an address ten requests at once.
rates_behind() {
  local name="$1" refused
  # Varnish leaves a backend that was away alone for a moment.
  until [[ "$(statuses "$2" "$4" 2)" == 200 ]]; do kill -0 "$talusd_pid" || die "talusd has ended"; done
  refused="$(statuses "$2" "$3" '[1-60]' | grep -c 429 || true)"
  ((refused >= 20)) || die "$name: a client that floods was refused $refused times of 60"
  [[ "$(statuses "$2" "$4" 3)" == 200 ]] || die "$name: another client is refused with the one that floods"
  printf '%s: %s of 60 requests of one client are refused, none of another\n' "$name" "$refused"
}

# players NAME PORT: by IPv6, so that they have another address than the proxies.
players() {
  "$talus_load" --connect "ws://[::1]:$2" --players 10 --model fly --radius 4 --duration 4 --drain 60 --verify 20 \
    --fail-if 'wrong>0' --fail-if 'errors>0' --fail-if 'disconnects>0' --fail-if 'unanswered>0' --fail-if 'chunks_per_s==0' \
    >"$out/$1-players.txt" 2>&1 || { cat "$out/$1-players.txt" >&2; die "players by WebSocket through $1"; }
  printf '%s: players by WebSocket get what is right\n' "$1"
}

rm -rf "$out"
mkdir -p "$out"
has nginx
has varnishd
for port in talusd_port admin_port nginx_port varnish_port; do free_port $port; done

site="$out/site"
cp -r client_sample/web/viewer/dist "$site"
start_talusd "TALUS_DATA=$out/data" TALUS_ACCESS_WITHOUT_TOKEN=read,edit "TALUS_HTTP_WEB=$site" \
  TALUS_HTTP_ORIGINS=https://play.example
curl -sS --fail "http://127.0.0.1:$talusd_port/v1/world" -H 'X-Forwarded-For: 127.0.0.2' >"$out/world"
fingerprint="$(sed -n 's/.*"fingerprint": *"\([0-9a-f]*\)".*/\1/p' "$out/world")"
store="$(sed -n 's/.*"store_id": *"\([0-9a-f]*\)".*/\1/p' "$out/world")"
flight "/v1/$fingerprint/4" >"$out/paths"
fetch "$talusd_port" own
sed -e "s#/var/cache/nginx/talus#$out/nginx/cache#" -e "s#server 127.0.0.1:4782#server 127.0.0.1:$talusd_port#" \
  -e "s#listen 80;#listen 127.0.0.1:$nginx_port; listen [::1]:$nginx_port;#" docker/nginx/talus.conf >"$out/talus.conf"
start_nginx nginx "$nginx_port" "$out/talus.conf"
cp docker/varnish/rules.vcl "$out/"
sed -e "s#\"4782\"#\"$talusd_port\"#" docker/varnish/talus.vcl >"$out/talus.vcl"
start_varnish varnish "$varnish_port" "$out/talus.vcl"
for proxy in nginx varnish; do
  port="${proxy}_port"
  curl -sS --fail -o /dev/null --interface 127.0.0.2 "http://127.0.0.1:${!port}/v1/world"
  fly_twice $proxy "${!port}"
  players $proxy "${!port}"
  site_kept $proxy "${!port}"
  made_up $proxy "${!port}"
  listed_origin $proxy "${!port}"
done
edits_seen nginx "$nginx_port" granite
edits_seen varnish "$varnish_port" gneiss
# What a cache tells while talusd is away is the last that it was told: of the world, too.
newest="$(revision_through "$talusd_port")"
curl -sS --fail "http://127.0.0.1:$talusd_port/v1/world" -H 'X-Forwarded-For: 127.0.0.2' >"$out/world"
for proxy in nginx varnish; do
  port="${proxy}_port"
  until curl -sS --fail --interface 127.0.0.2 "http://127.0.0.1:${!port}/v1/world" | cmp -s - "$out/world"; do
    kill -0 "$talusd_pid" || die "talusd has ended"
  done
  until [[ "$(revision_through "${!port}")" == "$newest" ]]; do kill -0 "$talusd_pid" || die "talusd has ended"; done
  through "${!port}" "/v1/$fingerprint/$store/4/0/3/3@$newest" edited >/dev/null
done
stop_talusd
for proxy in nginx varnish; do
  port="${proxy}_port"
  without_talusd $proxy "${!port}"
done
echo '<!-- another -->' >>"$site/index.html"
start_talusd "TALUS_HTTP_WEB=$site"
new_page nginx "$nginx_port"
new_page varnish "$varnish_port"
stop_talusd
start_talusd TALUS_RATES_ADDRESS_REQUESTS=1 TALUS_RATES_BURST_MS=10000
rates_behind nginx "$nginx_port" 127.0.0.3 127.0.0.4
rates_behind varnish "$varnish_port" 127.0.0.5 127.0.0.6
stop_talusd
echo "nginx and Varnish in front of talusd: all right"
