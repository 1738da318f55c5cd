# shellcheck shell=bash
# What the commands of ./dev share.

say() { printf '\033[1m==> %s\033[0m\n' "$*" >&2; }
die() { printf '%s\n' "$*" >&2; exit 1; }
wrong_use() { printf '%s\n' "$*" >&2; exit 2; }
# no_arguments COMMAND [ARGUMENT...]: refuses an argument.
no_arguments() { (($# <= 1)) || wrong_use "$1: '$2' is not an argument; it takes none"; }

now_ms() { printf '%d' $((${EPOCHREALTIME/[.,]/} / 1000)); }

# stage NAME COMMAND...: runs it, and prints its duration.
stage() {
  local name="$1" began
  shift
  began="$(now_ms)"
  "$@"
  say "$name took $((($(now_ms) - began + 500) / 1000)) s"
}

# cpu_ms VARIABLE: the processor time of all that this shell has started and waited for.
cpu_ms() {
  local file
  file="$(mktemp)"
  times >"$file"
  printf -v "$1" '%s' "$(awk 'NR == 2 { for (i = 1; i <= 2; ++i) { split($i, t, /[ms]/); ms += 60000 * t[1] + 1000 * t[2] } printf "%d", ms }' "$file")"
  rm "$file"
}

# compiling: the files that compilers work on in this folder, and the seconds of each.
compiling() {
  local process arguments argument status up age separator=""
  for process in /proc/[0-9]*; do
    { mapfile -d '' -t arguments <"$process/cmdline" && status="$(<"$process/stat")"; } 2>/dev/null || continue
    [[ "${arguments[0]:-}" == */cc1plus || "${arguments[1]:-}" == -cc1 ]] || continue
    for argument in "${arguments[@]}"; do
      [[ "$argument" == "$PWD"/*.@(c|cc|cpp|cxx) ]] || continue
      # The 22nd field is when it began, in hundredths of a second; the second may contain blanks.
      read -ra status <<<"${status##*) }"
      read -r up _ </proc/uptime
      age=$((${up%.*} - status[19] / 100))
      printf '%s%s (%s s)' "$separator" "${argument#"$PWD"/}" "$age"
      separator=", "
      break
    done
  done
}

# aloud WHAT COMMAND...: runs it, with its output on stderr. Without a terminal, a line says that it goes on, and which
# files are compiled, whenever nothing was printed for eight seconds.
aloud() {
  local what="$1" began=$SECONDS line files read_status
  shift
  if [[ -t 2 ]]; then "$@" >&2; return; fi
  "$@" 2>&1 | while true; do
    read_status=0
    IFS= read -r -t 8 line || read_status=$?
    if ((read_status == 0)); then
      printf '%s\n' "$line" >&2
    elif ((read_status > 128)); then
      printf '%s' "$line" >&2
      files="$(compiling)"
      say "$what for $((SECONDS - began)) s${files:+: $files}"
    else
      printf '%s' "$line" >&2
      break
    fi
  done
}

# package_groups: the groups of docker/packages.txt, in words.
package_groups() { awk '/^[a-z]+:/ && !seen[$1]++ { printf "%s%s", separator, substr($1, 1, length($1) - 1); separator = ", " }' docker/packages.txt; }

# deps GROUP...: installs those of the groups' packages that are missing.
deps() {
  local missing=() group package
  for group in "$@"; do
    while read -r package; do
      [[ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" == installed || " ${missing[*]} " == *" $package "* ]] ||
        missing+=("$package")
    done < <(awk -v group="$group:" '$1 == group { for (i = 2; i <= NF; ++i) print $i }' docker/packages.txt)
  done
  ((${#missing[@]})) || return 0
  command -v apt-get >/dev/null || die "this is not Debian; install by your own means: ${missing[*]}"
  local as_root=()
  if ((EUID != 0)); then
    command -v sudo >/dev/null || die "not root and no sudo; ask root to run: apt-get install ${missing[*]}"
    as_root=(sudo)
  fi
  say "installing ${missing[*]}"
  local install=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}")
  # The lists of packages that are there will mostly do.
  aloud "installing packages" packages_with_sizes /dev/null "${install[@]}" ||
    { "${as_root[@]}" apt-get update -qq && aloud "installing packages" packages_with_sizes /dev/stderr "${install[@]}"; }
}

# packages_with_sizes ERRORS APT-GET...: runs it with its errors in a file, and prints the packages with their sizes.
packages_with_sizes() { "${@:2}" 2>"$1" | sed -un -E '/^(Get:|Need to get|Setting up )/p'; }

# configure PRESET [CMake option...]
configure() {
  local preset="$1" options=("${@:2}")
  mkdir -p "build/$preset"
  if ! cmake --preset "$preset" "${options[@]}" >"build/$preset/configure.log" 2>&1; then
    cat "build/$preset/configure.log" >&2
    die "could not configure the $preset build"
  fi
}

# compile PRESET [target...]
compile() {
  local preset="$1" targets=()
  shift
  (($#)) && targets=(--target "$@")
  aloud "compiling" cmake --build --preset "$preset" -j "$jobs" "${targets[@]}"
}

# build PRESET [CMake option...] [-- target...]
build() {
  local preset="$1" options=()
  shift
  while (($#)) && [[ "$1" != -- ]]; do options+=("$1"); shift; done
  (($#)) && shift
  say "building $preset${*:+: $*}"
  configure "$preset" "${options[@]}"
  compile "$preset" "$@"
}

# tests_of PRESET [ctest option...]
tests_of() { aloud "testing" ctest --test-dir "build/$1" --output-on-failure -j "$jobs" "${@:2}"; }

# tracked PATTERN...: the repository's files of these patterns; in an archive without git all there are.
tracked() {
  local pattern
  if [[ -e .git ]]; then git ls-files -co --exclude-standard -- "$@"; return; fi
  for pattern in "$@"; do
    find . \( -path ./build -o -path ./out -o -name node_modules \) -prune -o -path "./$pattern" -type f -print
  done
}

check_format() {
  say "checking the format"
  local found
  found="$({ tracked '*.cpp' '*.h' | xargs -P "$jobs" -n 50 clang-format-14 --dry-run --Werror; } 2>&1)" && return
  printf '%s\n' "$found" >&2
  [[ "$found" == *-Wclang-format-violations* ]] || die "the format could not be checked"
  die "not formatted; ./dev lint --fix formats it"
}

check_layering() {
  say "checking who includes whom"
  tests/layering/check.sh
}

# node_tools: node and npm as they are, or Debian's. Debian's npm conflicts with another vendor's nodejs.
node_tools() {
  local tool
  for tool in node npm; do
    command -v "$tool" >/dev/null || deps "$tool" || true
    command -v "$tool" >/dev/null || die "the viewer's tests need $tool, and there is no package of it; install Node.js 18 or newer, with npm"
  done
}
