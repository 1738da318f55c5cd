#!/bin/sh
# Makes an authority and certificates for a cluster to begin with, by openssl:
#
#     docker/nats/certificates.sh DIRECTORY HOST[,NAME...]...
#
# ca.pem and ca-key.pem; for each host of nats-server HOST.pem and HOST-key.pem, with HOST and the other names (DNS, or
# addresses of IPv4) that clients and other hosts call it by; talusd.pem for every talusd, talus-admin.pem for `talusd
# cluster init` and nats-operator.pem for people, each with its -key.pem. What is there already stays: run it again with
# another host to add one, or delete a pair to get a new one. They end after DAYS days (365 unless that variable says otherwise),
# the authority after ten years. Whoever has ca-key.pem can make himself anybody: keep it offline.
set -eu

die() { printf 'certificates.sh: %s\n' "$1" >&2; exit 1; }

[ $# -ge 1 ] || die "wants a directory, and the hosts of nats-server: certificates.sh DIRECTORY HOST[,NAME...]..."
command -v openssl >/dev/null || die "needs openssl"
directory="$1"
shift
days="${DAYS:-365}"
umask 077
mkdir -p "$directory"
cd "$directory"

new_key() { openssl genpkey -algorithm EC -pkeyopt ec_paramgen_curve:P-256 -out "$1" 2>/dev/null; }

# issue NAME USAGE [SUBJECT-ALTERNATIVE-NAMES]
issue() {
  [ ! -f "$1.pem" ] || [ ! -f "$1-key.pem" ] || return 0
  new_key "$1-key.pem"
  {
    printf 'basicConstraints=critical,CA:FALSE\nkeyUsage=critical,digitalSignature\nextendedKeyUsage=%s\n' "$2"
    [ -z "${3:-}" ] || printf 'subjectAltName=%s\n' "$3"
  } >extensions.tmp
  openssl req -new -key "$1-key.pem" -subj "/CN=$1" -out request.tmp
  openssl x509 -req -in request.tmp -CA ca.pem -CAkey ca-key.pem -set_serial "0x$(openssl rand -hex 16)" -days "$days" \
    -extfile extensions.tmp -out "$1.pem" 2>/dev/null
  rm -f extensions.tmp request.tmp
  chmod 0644 "$1.pem"
  printf '%s/%s.pem\n' "$directory" "$1"
}

if [ ! -f ca.pem ] || [ ! -f ca-key.pem ]; then
  new_key ca-key.pem
  openssl req -x509 -new -key ca-key.pem -subj "/CN=Talus cluster" -days 3650 -out ca.pem \
    -addext basicConstraints=critical,CA:TRUE,pathlen:0 -addext keyUsage=critical,keyCertSign,cRLSign
  chmod 0644 ca.pem
  printf '%s/ca.pem\n' "$directory"
fi

for host in "$@"; do
  name="${host%%,*}"
  case "$name" in
    "" | *[!a-zA-Z0-9.-]*) die "'$name' is no host's name" ;;
  esac
  alternatives=""
  for other in $(printf '%s' "$host" | tr ',' ' '); do
    case "$other" in
      *[!0-9.]*) alternatives="$alternatives,DNS:$other" ;;
      *) alternatives="$alternatives,IP:$other" ;;
    esac
  done
  # A host is a server to clients and to other hosts, and a client to those.
  issue "$name" serverAuth,clientAuth "${alternatives#,}"
done
for user in talusd talus-admin nats-operator; do issue "$user" clientAuth; done
