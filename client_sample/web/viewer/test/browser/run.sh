#!/usr/bin/env bash
# The viewer in a browser: run.sh TALUSD TALUS_GEN [--full | --bench]; --bench judges times. Needs node, `npm ci` in the viewer's folder, and chromium.
set -euo pipefail
(($# >= 2)) || { printf 'usage: run.sh TALUSD TALUS_GEN [--full | --bench]\n' >&2; exit 2; }
TALUSD="$(realpath "$1")"
TALUS_GEN="$(realpath "$2")"
export TALUSD TALUS_GEN
cd "$(dirname "$0")"
case "${3:-}" in
  --full) tests=(*.test.mjs) ;;
  --bench) tests=(budget.test.mjs) && export TALUS_BENCH=1 ;;
  *) tests=(short.test.mjs here.test.mjs) ;;
esac
for test in "${tests[@]}"; do
  printf '%s\n' "-- $test"
  node --test "$test"
done
