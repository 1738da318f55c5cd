# shellcheck shell=bash
# What the tests of packages share. Each takes the folder with the packages, out/packages.

die() { printf '%s: %s\n' "$(basename "$0" .sh)" "$*" >&2; exit 1; }
say() { printf '\033[1m==> %s\033[0m\n' "$*" >&2; }

# only_one PATTERN: the one file of this pattern.
only_one() {
  local found
  mapfile -t found < <(compgen -G "$1")
  ((${#found[@]} == 1)) || die "$1: ${#found[@]} files, not one; ./dev package makes it"
  printf '%s\n' "$found"
}

# own_network COMMAND...: without a network, and with ports of its own.
own_network() { unshare --net bash -c 'ip link set lo up && exec "$@"' own_network "$@"; }

# end [PID]: ends this process, if there is one. For a trap: it does not fail, and what the process wrote is whole afterwards.
end() { [[ -z "${1:-}" ]] || { kill "$1" && wait "$1"; } 2>/dev/null || true; }

# wait_for_line FILE PATTERN PID: until the file has such a line. Fails if the process ends before.
wait_for_line() {
  until grep -qs "$2" "$1"; do
    kill -0 "$3" 2>/dev/null || { cat "$1" >&2; die "it ended without '$2'"; }
    sleep 0.05
  done
}
