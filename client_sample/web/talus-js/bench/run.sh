#!/usr/bin/env bash
# run.sh BUILD [WORLD]: the decoder beside the native one, on chunks of a talusd of BUILD. Fails where it is over its mark.
set -euo pipefail
(($# == 1 || $# == 2)) || { printf 'usage: run.sh BUILD [WORLD.toml]\n' >&2; exit 2; }
build="$(realpath "$1")"
world=()
(($# == 1)) || world=(--world "$(realpath "$2")")
cd "$(dirname "$0")/.."
root=../../..
scratch="$(mktemp -d)"
server=""
trap '[[ -z "$server" ]] || kill "$server" 2>/dev/null || true; rm -rf "$scratch"' EXIT
[[ -d node_modules ]] || npm ci --no-audit --no-fund --loglevel error >&2
npm run --silent build
g++ -std=c++20 -O2 -I$root/core/voxel/include $root/tests/bench/decode_payloads.cpp "$build/core/voxel/libtalus_voxel.a" \
  "$build/core/vectors/libtalus_vectors.a" -lhwy -lxxhash -o "$scratch/native"
: >"$scratch/log"
"$build/server/talusd" --listen 127.0.0.1:0 "${world[@]}" >"$scratch/log" 2>&1 &
server=$!
until address="$(sed -n 's/.*listening on \([^ ]*\).*/\1/p' "$scratch/log" | head -n 1)" && [[ -n "$address" ]]; do
  kill -0 "$server" 2>/dev/null || { cat "$scratch/log" >&2; exit 1; }
  sleep 0.05
done
node bench/collect.js "tcp://$address" "$scratch/payloads"
node bench/decode.js "$scratch/payloads" "$scratch/native"
