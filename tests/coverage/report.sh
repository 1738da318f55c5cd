#!/usr/bin/env bash
# usage: tests/coverage/report.sh BUILD: which lines the programs of a --coverage build did not reach.
set -euo pipefail
cd "$(dirname "$0")/../.."
build="${1:?usage: tests/coverage/report.sh BUILD}"
# An object that no program ran has no counters, and its lines count as not reached. The tests' objects count too: of an
# inline function that several objects have, the linker keeps one, mostly the test's. One gcov after the other: the lines of
# two at once would mix in the pipe.
find "$build" -name '*.gcno' -print0 | sort -z |
  xargs -0 -n 8 gcov --stdout --relative-only --source-prefix "$PWD" 2>/dev/null |
  awk -f tests/coverage/report.awk docs/modules.txt -
