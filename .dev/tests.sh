# shellcheck shell=bash
# ./dev test, sanitize, clang and coverage.

# viewer_packages: the viewer's packages, as its lock file names them.
viewer_packages() {
  node_tools
  local folder=client_sample/web/viewer
  [[ "$folder/node_modules/.package-lock.json" -nt "$folder/package-lock.json" ]] && return
  say "installing the viewer's packages"
  aloud "installing the viewer's packages" npm --prefix "$folder" ci --no-audit --no-fund --loglevel error
}

# test_in_browser [--full]
test_in_browser() {
  deps browser
  viewer_packages
  aloud "testing in a browser" client_sample/web/viewer/test/browser/run.sh build/release/server/talusd build/release/core/tools/talus-gen "$@"
}

test_javascript() {
  (cd client_sample/web/talus-js && npm ci --no-audit --no-fund --loglevel error >&2 &&
    TALUSD="$OLDPWD/build/release/server/talusd" npm test --silent)
}

# The viewer's sources make the committed dist/, byte by byte.
check_viewer() {
  viewer_packages
  (cd client_sample/web/viewer && npm run --silent check && npm test --silent && test/check_dist.sh)
}

# A busy machine's times say nothing: only what is lost, wrong or twice is judged here.
edits_at_rate() {
  build release -DTALUS_TESTS=ON -DTALUS_BENCH=ON -- bench_stream talus-load
  python3 -B tests/balancer/edits_at_rate.py --rate 1000 --times 1000 --seen-ms 60000
}

# Hosts of a cluster as network namespaces.
break_clusters() {
  if ((EUID != 0)); then say "only root can cut hosts from each other: tests/cluster_chaos is left out"; return; fi
  deps chaos
  local folder=tests/cluster_chaos
  stage "talusd killed between publish and answer" python3 -B $folder/kills.py --kills 20
  stage "hosts of a cluster cut off" python3 -B $folder/partitions.py --seconds 20 --well-s 60 --chunks-s 30
  stage "a cluster in which things happen" python3 -B $folder/chaos.py --seconds 240
}

run_tests() {
  case "${1:-}" in
    "") no_arguments test "${@:2}" ;;
    --full) (($# == 1)) || wrong_use "test: '$2' does not go with --full" ;;
    -*) wrong_use "test: '$1' is not --full or the name of a module" ;;
    *) test_modules "$@"; return ;;
  esac
  deps build test format
  check_format
  check_layering
  # TALUS_TESTS may be off from ./dev run, TALUS_BENCH on from ./dev bench.
  stage "building" build release -DTALUS_TESTS=ON -DTALUS_BENCH=OFF
  # Twice as many at once as processors: half of the time they wait, for a balancer, an election, a time-out.
  stage "testing" tests_of release -j "$((2 * jobs))" -LE sanitized
  stage "testing in a browser" test_in_browser
  stage "the same voxels on ARM and in WebAssembly" golden aarch64 wasm-simd
  stage "building for address + undefined behaviour" build asan-ubsan -- sanitized_tests
  # RapidCheck tries a property a hundred times by itself, as in ./dev sanitize.
  RC_PARAMS="${RC_PARAMS-max_success=40}" stage "testing by address + undefined behaviour" \
    tests_of asan-ubsan -j "$((2 * jobs))" -L 'sanitized|both'
  [[ "${1:-}" != --full ]] || test_at_length
}

# test_modules MODULE...: the tests of some modules alone, each where ./dev test runs it.
test_modules() {
  local module preset
  deps build test
  for module in "$@"; do
    [[ "$module" =~ ^[a-z0-9_]+$ ]] || wrong_use "test: '$module' is not the name of a module; such are voxel, server_config, e2e"
    preset=asan-ubsan
    ! grep -rqE "^ *talus_test\($module ([A-Z]+ )*(RELEASE|BOTH)" tests --include=CMakeLists.txt || preset=release
    build "$preset" -DTALUS_TESTS=ON -- "test_$module"
    tests_of "$preset" -R "^$module:"
  done
}

# What .ci/run leaves to be run by hand, before an issue is called resolved.
test_at_length() {
  stage "the tables of docs/MILLION.md" /usr/bin/python3 -B tests/load/million.py --check
  stage "building the viewer again" check_viewer
  stage "building the WebAssembly modules again" wasm --check
  stage "testing talus-client for JavaScript" test_javascript
  stage "testing in a browser, at length" test_in_browser --full
  # File by file: every file includes what it uses, and g++ has all its warnings, also of the unit tests.
  stage "building file by file" build release-plain
  stage "2,000 power cuts on one machine, as many in a cluster, and 200 flipped bits" damage_stores
  stage "building as ./dev run does" build no-tests -DTALUS_QUICK=ON -- talusd talus-client
  stage "the same voxels on every target" golden --all
  stage "a server and a client on ARM" agree_on aarch64 arm64
  stage "a server and a client on a big-endian machine" agree_on s390x s390x
  by_clang
  by_clang --all
  say "fourteen hostile minutes"
  TALUS_HOSTILE_SECONDS=600 build/release/tests/e2e/test_e2e -w NoTests "under siege*"
  say "three more by WebSocket"
  TALUS_HOSTILE_SECONDS=120 TALUS_E2E_TRANSPORT=websocket build/release/tests/e2e/test_e2e -w NoTests "~[tcp]under siege*"
  deps proxies
  stage "nginx and Varnish in front of talusd" tests/proxies/run.sh
  stage "a rolling restart of three servers under 500 players" python3 -B tests/balancer/rolling_restart.py --session 20000 --per-second 20
  stage "the same with edits" python3 -B tests/balancer/rolling_restart.py --session 20000 --per-second 20 --edits 1 --radius 3
  deps cluster deployment
  stage "edits at three servers beside bare JetStream" edits_at_rate
  break_clusters
  stage "testing the files for many machines" tests/deployment/run.sh
  deps bindings image
  stage "building the client libraries alone in a bare Debian" tests/install/alone.sh
  package --uncommitted "${package_usual[@]}" arm64 image
  stage "installing every package and using it" tests/packages/run.sh "${package_usual[@]}" arm64 image
  sanitize address thread
  avx512
  fuzz 120
  stage "clients on Windows" test_windows
}

damage_stores() {
  build release -DTALUS_TESTS=ON -- test_server_edits test_server_cluster
  # TALUS_SEED is the first run's seed.
  local first="${TALUS_SEED:-$RANDOM}" run seed
  say "TALUS_POWER_CUTS=2000 TALUS_FLIPS=200 TALUS_SEED=$first"
  TALUS_POWER_CUTS=2000 TALUS_FLIPS=200 TALUS_SEED="$first" build/release/tests/server/test_server_edits "after power cuts*,a flipped bit in any file*"
  # Of the faults, 5 in 12 are power cuts.
  for ((run = 1; run <= 30; ++run)); do
    seed="$((first + run - 1))"
    say "run $run of 30: TALUS_KILLS=160 TALUS_SEED=$seed"
    TALUS_KILLS=160 TALUS_SEED="$seed" aloud "run $run of 30" build/release/tests/server/test_server_cluster "servers that share a log*"
  done
}

sanitize() {
  local kinds=() short=0
  while (($#)); do
    case "$1" in
      address | thread) kinds+=("$1") ;;
      --short) short=1 ;;
      *) wrong_use "sanitize: '$1' is neither address nor thread nor --short" ;;
    esac
    shift
  done
  ((${#kinds[@]})) || kinds=(address thread)
  deps build test
  local kind
  for kind in "${kinds[@]}"; do "sanitize_$kind" "$short"; done
}

# Every test but golden's, which compiles the generator three times over to compare its voxels.
sanitize_address() {
  stage "building for address + undefined behaviour" build asan-ubsan
  stage "testing by address + undefined behaviour" tests_of asan-ubsan
  (($1)) || stage "load scenarios by address + undefined behaviour" scenarios asan-ubsan
}

# The tests of what has threads, and the programs that these run.
sanitize_thread() {
  export TSAN_OPTIONS="halt_on_error=1 suppressions=$PWD/tests/thread_sanitizer.supp"
  say "configuring tsan"
  configure tsan
  local tests modules='(store|(server|client|c_api|load|e2e)[a-z_]*)' programs=(talusd talus-client talus-load talus-gen talus-pong)
  if (($1)); then
    modules='(store|server_(net|chunks|edits|admin|web|app)|client|c_api(_local)?|e2e)'
    programs=()
  fi
  mapfile -t tests < <(ninja -C build/tsan -t targets all | sed -nE "s/^(test_$modules): phony\$/\1/p")
  stage "building for threads: ${programs[*]} ${tests[*]}" compile tsan "${programs[@]}" "${tests[@]}"
  stage "testing by threads" tests_of tsan -R "^$modules:"
  (($1)) || stage "load scenarios by threads" scenarios tsan
}

# The voxels of every compiler and level. With --all every target by clang, file by file, and its tests.
by_clang() {
  [[ "${1:---all}" == --all && $# -le 1 ]] || wrong_use "clang: '${2:-$1}' is not --all"
  deps build test clang
  if (($#)); then
    stage "building everything by clang" build clang
    stage "testing what clang built" tests_of clang
    stage "every golden region, not optimised" golden_not_optimised
    return
  fi
  stage "building by g++ at other levels" build release -DTALUS_TESTS=ON -- golden
  stage "testing what g++ built" tests_of release -C golden -R '^golden:'
  stage "building by clang" build clang-golden -- golden
  stage "testing what clang built" tests_of clang-golden -C golden -R '^golden:'
}

# Of these regions the tests compare every seventh.
golden_not_optimised() {
  build release -DTALUS_TESTS=ON -- talus_golden_O0
  build clang-golden -- talus_golden_O0
  local preset set status
  for preset in release clang-golden; do
    for set in scalar sse4 avx2 avx512; do
      status=0
      TALUS_INSTRUCTION_SET="$set" aloud "$preset by $set" "build/$preset/tests/golden/talus_golden_O0" tests/golden/golden.txt || status=$?
      ((status == 0 || status == 77)) || die "voxels of $preset by $set differ"
    done
  done
}

# golden [--all | TARGET...]: the voxels and payloads of tests/golden/golden.txt on other machines; what this one does not run
# itself runs in an emulator. "undefined" is this machine, under clang's undefined-behaviour sanitizer.
golden() {
  local all=(x86-64 aarch64 armhf i386 riscv64 ppc64le s390x windows wasm-simd wasm-scalar undefined) targets=() target failed=0 rows=()
  while (($#)); do
    if [[ "$1" == --all ]]; then
      targets=("${all[@]}")
    elif [[ " ${all[*]} " == *" $1 "* ]]; then
      targets+=("$1")
    else
      wrong_use "golden: '$1' is not --all or a target; there are ${all[*]}"
    fi
    shift
  done
  ((${#targets[@]})) || targets=(aarch64 wasm-simd)
  for target in "${targets[@]}"; do golden_on "$target"; done
  printf '\n%-12s %-10s %s\n' target vectors "voxels and payloads of $(wc -l <tests/golden/golden.txt) lines"
  printf '%s\n' "${rows[@]}"
  ((!failed)) || die "voxels differ: out/golden has what each target printed"
}

# golden_on TARGET: adds its rows, and sets `failed` if its voxels differ.
golden_on() {
  local target="$1" groups=(build) vectors=("") preset="golden-$1" option test_of="^golden: $1\$" log run
  case "$target" in
    x86-64) preset=release vectors=(scalar sse4 avx2 avx512) ;;
    aarch64) groups+=(aarch) ;;
    wasm-*) preset="$target"; groups+=(test wasm); node_tools ;;
    undefined) groups+=(clang) ;;
    *) groups+=(cross) ;;
  esac
  deps "${groups[@]}"
  case "$target" in
    x86-64) deps test; build release -DTALUS_TESTS=ON -- talus_golden_O3 ;;
    wasm-*) build release -DTALUS_TESTS=ON -- talus_golden_inputs; build "$preset" ;;
    *) build "$preset" ;;
  esac
  mkdir -p out/golden
  for option in "${vectors[@]}"; do
    [[ -z "$option" ]] || test_of="^golden: O3 $option\$"
    log="out/golden/$target${option:+-$option}.txt"
    say "running golden on $target${option:+ by $option}"
    run=(ctest --test-dir "build/$preset" --no-tests=error -V -R "$test_of")
    if [[ "$target" == wasm-* ]]; then
      build/release/tests/golden/talus_golden_inputs >out/golden/inputs.json
      run=(node tests/golden/wasm.mjs "build/$preset/core/wasm/talus-world.wasm" out/golden/inputs.json tests/golden/golden.txt)
    fi
    if "${run[@]}" >"$log" 2>&1; then
      if grep -q 'skipped: ' "$log"; then
        rows+=("$(printf '%-12s %-10s %s' "$target" "$option" "not run: this processor has no $option (./dev avx512 emulates it)")")
      else
        rows+=("$(printf '%-12s %-10s %s' "$target" "$(sed -n 's/.*, by \([a-z0-9]*\)$/\1/p' "$log")" "the same")")
      fi
    else
      failed=1
      rows+=("$(printf '%-12s %-10s %s' "$target" "$option" "DIFFERENT: $log")")
    fi
  done
}

# wasm [--check]: the modules of talus-js/wasm, which are committed.
wasm() {
  [[ "${1:---check}" == --check && $# -le 1 ]] || wrong_use "wasm: '${2:-$1}' is not --check"
  deps build wasm
  local preset module built
  for preset in wasm-scalar wasm-simd; do
    build "$preset"
    built="build/$preset/core/wasm/talus-world.wasm"
    module="client_sample/web/talus-js/wasm/talus-world$([[ "$preset" == wasm-scalar ]] || printf -- -simd).wasm"
    if (($#)); then
      cmp "$built" "$module" || die "$module is not what these sources make: run ./dev wasm, and commit it"
    else
      install -m 644 "$built" "$module"
    fi
    say "$module: $(stat -c %s "$module") bytes, $(brotli -c "$module" | wc -c) by brotli"
  done
}

# foreign_root ARCHITECTURE: Debian's packages of it that a build needs, unpacked into build/root-ARCHITECTURE.
foreign_root() {
  local root="build/root-$1" packages
  [[ ! -e "$root/unpacked" ]] || return 0
  rm -rf "$root"
  mkdir -p build
  packages="$(awk '$1 == "build:" { for (i = 2; i <= NF; ++i) if ($i ~ /-dev$/) printf "%s,", $i }' docker/packages.txt)"
  aloud "unpacking packages of $1" mmdebstrap --quiet --variant=extract --architectures="$1" \
    --include="${packages}libstdc++-12-dev,libc6-dev" bookworm "$root"
  touch "$root/unpacked"
}

# agree_on TARGET ARCHITECTURE: a client, talusd and talus-gen of another machine, in an emulator and with Debian's packages of
# that architecture, against this machine's.
agree_on() {
  deps build test aarch cross machines
  local root="build/root-$2"
  foreign_root "$2"
  build release -DTALUS_TESTS=ON -- talusd talus-client talus-gen talus_fly talus_game
  build "$1" -- talusd talus-client talus-gen talus_fly talus_game
  python3 -B tests/machines/agree.py --other "build/$1" --emulator "qemu-$1-static -L $PWD/$root"
}

scenarios() {
  BUILD="build/$1" tests/load/run.sh --short
  # By TLS those in which a connection waits, closes and is cut off in its own ways.
  TLS=1 BUILD="build/$1" tests/load/run.sh --short hot alone slow churn
}

coverage() {
  no_arguments coverage "$@"
  deps build test
  stage "building" build coverage
  # Counters of an earlier run count no more.
  find build/coverage -name '*.gcda' -delete
  local failed=0
  # Not as a stage, which would end with its own last command's status where a failure is caught.
  tests_of coverage || failed=1
  tests/coverage/report.sh build/coverage
  ((!failed)) || die "tests failed, so the lines that they would have reached are missing above"
}
