#!/usr/bin/env bash
# usage: tests/coverage/report.sh BUILD: which lines the programs of a --coverage build did not reach.
set -euo pipefail
cd "$(dirname "$0")/../.."
build="${1:?usage: tests/coverage/report.sh BUILD}"
# An object that no program ran has no counters, and its lines count as not reached.
find "$build" -name '*.gcno' ! -path '*/tests/*' -print0 |
  xargs -0 -P "${JOBS:-$(nproc)}" -n 8 gcov --stdout --relative-only --source-prefix "$PWD" 2>/dev/null |
  awk -f tests/coverage/report.awk docs/modules.txt -
