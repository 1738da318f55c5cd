#!/usr/bin/env bash
# What ships for many machines, by the programs that read it: NATS' configuration by three nats-servers, compose files by
# docker-compose, alerts and dashboard by Prometheus, manifests by Kubernetes' types, settings by talusd; and ./dev cluster.
# No image is built (image.sh). BUILD is the build whose talusd and talus-client it takes, build/release unless told otherwise.
set -euo pipefail
cd "$(dirname "$0")"

PATH="$PATH:/usr/sbin"
for program in nats-server haproxy varnishd docker-compose promtool prometheus openssl curl npm; do
  command -v "$program" >/dev/null || { printf '%s is not installed; ./dev deps cluster deployment\n' "$program" >&2; exit 1; }
done

# Debian's python3 has yaml; another one that comes first in PATH often has not.
/usr/bin/python3 -B -m unittest test_nats test_compose test_monitoring test_settings test_cluster
# The tables of docs/MILLION.md are those that its program makes.
/usr/bin/python3 -B ../load/million.py --check

cd kubernetes
[[ node_modules/.package-lock.json -nt package-lock.json ]] || npm ci --no-audit --no-fund --loglevel error >&2
npm test --silent
