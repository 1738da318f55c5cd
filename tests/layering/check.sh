#!/usr/bin/env bash
# Holds every #include against docs/modules.txt: a module includes only what the table lets it, private headers stay
# private, pure modules touch no clock, thread, file or socket, dependencies form no cycle and each is used.
set -euo pipefail
cd "$(dirname "$0")/../.."

usage() {
  cat <<'USAGE'
usage: tests/layering/check.sh [--write | --found]

  --write   puts the table of docs/modules.txt into docs/DESIGN.md
  --found   prints the lines for docs/modules.txt as the includes would have them, right or wrong
USAGE
}

first='<!-- modules: written by tests/layering/check.sh --write -->'
last='<!-- end of modules -->'

# files: every header and source of a module, tests apart.
files() { find core protocol server client_sample -name node_modules -prune -o \( -name '*.h' -o -name '*.cpp' \) -print | LC_ALL=C sort; }
includes() { files | xargs grep -nHE '^[[:space:]]*#[[:space:]]*include[[:space:]]*[<"]'; }
judge() { awk -v MODE="$1" -f tests/layering/modules.awk docs/modules.txt <(files) <(includes); }
# printed: the lines of docs/DESIGN.md between the two marks.
printed() { awk -v first="$first" -v last="$last" '$0 == last { inside = 0 } inside { print } $0 == first { inside = 1 }' docs/DESIGN.md; }

write() {
  local table written
  table="$(judge table)"
  written="$(awk -v first="$first" -v last="$last" -v table="$table" '
    $0 == last { inside = 0 }
    !inside { print }
    $0 == first { inside = 1; print table }' docs/DESIGN.md)"
  printf '%s\n' "$written" >docs/DESIGN.md
}

case "${1:-}" in
  "") ;;
  --write) write; exit ;;
  --found) judge found; exit ;;
  *) usage >&2; exit 2 ;;
esac

failed=0
judge check || failed=1
if [[ "$(judge table)" != "$(printed)" ]]; then
  echo "docs/DESIGN.md: its table of modules is not that of docs/modules.txt; tests/layering/check.sh --write"
  failed=1
fi
if find core protocol server client_sample tests docs -name node_modules -prune -o -type d \( -name utils -o -name common -o -name helpers \) -print | grep .; then
  echo "a thing lives with what it serves: no utils, common or helpers"
  failed=1
fi
if grep -rl random_device tests --include='*.cpp' --include='*.h' | grep -vx tests/seed_of_run.h; then
  echo "a test's random numbers begin with seed_of_run(), so that TALUS_SEED repeats them"
  failed=1
fi
exit "$failed"
