#!/usr/bin/env bash
# refused.sh CXX: exact_floats.h refuses flags by which floats differ from those of other machines.
set -euo pipefail
cxx="$1"
cd "$(dirname "$0")/../.."
compiled() {
  printf '#include <talus/vectors/exact_floats.h>\n' |
    "$cxx" -std=c++20 -Icore/vectors/include -fsyntax-only -x c++ "$@" - 2>&1
}
# refused WORDS FLAG...: compiling by the flags fails, and says so.
refused() {
  local words="$1" said
  shift
  if said="$(compiled "$@")"; then echo "$*: compiled" >&2; exit 1; fi
  [[ "$said" == *"$words"* ]] || { printf '%s: not "%s", but\n%s\n' "$*" "$words" "$said" >&2; exit 1; }
}
compiled -ffp-contract=off -DTALUS_NO_CONTRACTION
refused "compile with -ffp-contract=off" -O2
refused "-ffast-math" -ffp-contract=off -DTALUS_NO_CONTRACTION -ffast-math
refused "-ffast-math" -ffp-contract=off -DTALUS_NO_CONTRACTION -Ofast
if "$cxx" --version | grep -q 'Free Software' && [[ "$(uname -m)" == x86_64 ]]; then
  refused "-mfpmath=sse" -ffp-contract=off -DTALUS_NO_CONTRACTION -mfpmath=387
fi
