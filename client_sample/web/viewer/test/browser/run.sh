#!/usr/bin/env bash
# The viewer in a browser: run.sh TALUSD TALUS_GEN [--full]. Needs node, `npm ci` in the viewer's folder, and chromium.
set -euo pipefail
(($# >= 2)) || { printf 'usage: run.sh TALUSD TALUS_GEN [--full]\n' >&2; exit 2; }
TALUSD="$(realpath "$1")"
TALUS_GEN="$(realpath "$2")"
export TALUSD TALUS_GEN
cd "$(dirname "$0")"
tests=(short.test.mjs)
[[ "${3:-}" != --full ]] || tests=(*.test.mjs)
for test in "${tests[@]}"; do
  printf '%s\n' "-- $test"
  node --test "$test"
done
