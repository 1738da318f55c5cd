#!/usr/bin/env bash
# What talus-edits-model says of files of edits that are not whole: PROGRAM.
set -euo pipefail
program="$1"
scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT

# refused TEXT WHY: before any server is asked; port 1 is nobody's.
refused() {
  local said
  printf "$1" >"$scratch/edits"
  if said="$("$program" "$scratch/edits" 127.0.0.1 1 2>&1)"; then
    echo "taken: $1"
    exit 1
  fi
  if [[ "$said" != "talus-edits-model: $scratch/edits: $2" ]]; then
    echo "$1: $said"
    exit 1
  fi
}
refused '1 2 3 4 256\n2 2 3 4 25' 'line 2 is cut'
refused '1 2 3 4 256\n2 2 3' 'line 2 is cut'
refused '1 2 3 4 256\n2 2 3\n' 'line 2 is not an edit, which is five numbers'
refused '1 2 3 4\n256 2 2 3 4 5\n' 'line 1 is not an edit, which is five numbers'
refused '1 2 3 4 256 7\n' 'line 1 is not an edit, which is five numbers'
refused '1 2 3 4 stone\n' 'line 1 is not an edit, which is five numbers'
refused '1 2 3 4 256\n\n' 'line 2 is not an edit, which is five numbers'
# Whole, but not all edits.
printf '1 2 3 4 256\n4 2 3 4 0\n2 2 3 4 5\n' >"$scratch/edits"
if said="$("$program" "$scratch/edits" 127.0.0.1 1 2>&1)" ||
  [[ "$said" != "talus-edits-model: no edit was acknowledged as revision 3, and one as revision 4" ]]; then
  echo "a file without revision 3: $said"
  exit 1
fi
# Whole: it asks the server.
printf '1 2 3 4 256\n2 -2 3 4 65535\n' >"$scratch/edits"
if said="$("$program" "$scratch/edits" 127.0.0.1 1 2>&1)" || [[ "$said" != "talus-edits-model: 127.0.0.1:1: "* ]]; then
  echo "a whole file: $said"
  exit 1
fi
