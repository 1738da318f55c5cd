# shellcheck shell=bash
# For tests that need a bare Debian 12 beside this machine's, as root. The caller has die().

# bare_debian ROOT LOG [OPTION...]: makes it by debootstrap. Where this machine's apt fetches Debian from, and how, is good
# for the new root too.
bare_debian() {
  local root="$1" log="$2" mirror
  shift 2
  mirror="$(apt-get indextargets --format '$(REPO_URI) $(CODENAME)' 'Identifier: Packages' | awk '$2 == "bookworm" { print $1; exit }')"
  [[ -n "$mirror" ]] || die "apt here knows no archive of Debian 12 (bookworm)"
  rm -rf --one-file-system "$root"
  debootstrap --variant=minbase "$@" bookworm "$root" "$mirror" >"$log" 2>&1 ||
    { tail -n 5 "$log" >&2; die "debootstrap failed; all it said: $log"; }
  apt_as_here "$root"
}

# apt_as_here ROOT: its apt fetches as this machine's does.
apt_as_here() {
  rm -f "$1/etc/apt/sources.list"
  cp -r /etc/apt/sources.list.d "$1/etc/apt/"
  [[ ! -f /etc/apt/sources.list ]] || cp /etc/apt/sources.list "$1/etc/apt/"
  apt-config dump | grep -E '^Acquire::(https?|ftp|Check|Force|Retries)[:-]' >"$1/etc/apt/apt.conf.d/90acquire" || true
  cp /etc/resolv.conf /etc/hosts "$1/etc/" 2>/dev/null || true
}

# in_root ROOT COMMAND: in this root, with /proc and /dev, and an end to all of it when the command ends.
in_root() {
  unshare --mount --pid --fork --kill-child bash -c '
    mount -t proc proc "$1/proc" && mount --rbind /dev "$1/dev" && exec chroot "$1" bash -c "$2"' in_root "$1" "$2"
}
