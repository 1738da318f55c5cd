#!/usr/bin/env bash
# usage: closed_descriptors.sh WORLD TALUSD PROGRAM...: programs that are started with standard
# descriptors closed write no line into a file that took their number, and end as they do otherwise.
set -uo pipefail
world=$1 talusd=$2
data=$(mktemp -d)
trap 'rm -rf "$data"' EXIT
failed=0

# expect STATUS WHAT: of the command before
expect() {
  local status=$?
  ((status == $1)) && return
  echo "$2: status $status, not $1" >&2
  failed=1
}

for program in "${@:2}"; do
  "$program" --help >"$data/help" 2>&-
  expect 0 "$program --help 2>&-"
  "$program" --help >/dev/null 0<&- 2>&-
  expect 0 "$program --help <&- 2>&-"
done
# Results that go nowhere are a failure that is told, not a crash.
said=$("$talusd" --help 2>&1 >&-)
expect 1 "talusd --help >&-"
[[ $said == *"standard output: cannot write to it"* ]] || { echo "talusd --help >&- says: $said" >&2; failed=1; }

mkdir "$data/store"
"$talusd" pregen --data "$data/store" --world "$world" --center 0,0 --radius 20000 >/dev/null 2>&- &
pregen=$!
until [[ -e $data/store/lock ]]; do kill -0 $pregen || break; done
standard_error=$(readlink "/proc/$pregen/fd/2")
[[ $standard_error == /dev/null ]] || { echo "talusd pregen 2>&- writes its errors into $standard_error" >&2; failed=1; }
kill $pregen
wait $pregen
echo "not a file of edits" >"$data/file"
"$talusd" store import --data "$data/store" "$data/file" >&- 2>&-
expect 1 "talusd store import >&- 2>&-"
exit $failed
