# shellcheck shell=bash
# ./dev bench, lint, avx512 and fuzz.

bench() {
  local gate="" json=""
  while (($#)); do
    case "$1" in
      --gate) gate="check" ;;
      --gate-write) gate="write" ;;
      --json) (($# > 1)) || wrong_use "bench: --json takes a folder"; json="$2"; shift ;;
      --benchmark_*) break ;;
      *) wrong_use "bench: '$1' is not --json DIR, --gate, --gate-write or a flag of the benchmarks, --benchmark_..." ;;
    esac
    shift
  done
  deps build test bench
  local targets=(bench_terrain bench_voxel bench_wanted bench_work)
  [[ -n "$gate" ]] || (($#)) || targets+=(talusd talus-gen talus-load talus-http-load talus-http-floor)
  build release -DTALUS_TESTS=ON -DTALUS_BENCH=ON -- "${targets[@]}"
  if [[ -n "$gate" ]]; then
    deps aarch
    node_tools
    count_instructions "$gate"
    return
  fi
  local module
  for module in terrain voxel wanted; do
    local out=()
    if [[ -n "$json" ]]; then
      mkdir -p "$json"
      out=(--benchmark_out="$json/$module.json" --benchmark_out_format=json)
    fi
    "build/release/tests/bench/bench_$module" "${out[@]}" "$@"
  done
  (($#)) || bench_web
}

bench_web() {
  deps proxies
  local failed=0
  say "what a chunk by HTTP costs, beside an epoll loop, nginx and Varnish"
  tests/proxies/cost.sh || failed=1
  say "what a chunk by WebSocket costs, beside TCP"
  tests/load/run.sh websocket || failed=1
  say "the decoder in TypeScript beside the native one"
  node_tools
  client_sample/web/talus-js/bench/run.sh build/release || failed=1
  say "the viewer's first picture and frames"
  test_in_browser --bench || failed=1
  ((!failed)) || die "over the marks of docs/SPEED.md, \"By HTTP, and by WebSocket\" and \"In a browser\"; a machine with other work says little"
}

# count_instructions check|write: the instructions of fixed work against tests/bench/instructions.txt.
count_instructions() {
  local known=tests/bench/instructions.txt counted
  counted="$(mktemp)"
  { count_here; count_neon; count_wasm; } >"$counted"
  awk 'NR == FNR { was[$1] = $2; next }
    {
      printf "%-24s %14s instructions: %s\n", $1, $2, $1 in was ? sprintf("%+.2f %%", 100 * ($2 - was[$1]) / was[$1]) : "new"
      if (!($1 in was) || $2 > 1.03 * was[$1]) failed = 1
      delete was[$1]
    }
    END {
      for (stage in was) { printf "%-24s was not counted\n", stage; failed = 1 }
      exit failed
    }' "$known" "$counted" || [[ "$1" == write ]] ||
    die "more than 3 % over $known; find out why, or ./dev bench --gate-write"
  [[ "$1" != write ]] || cat "$counted" >"$known"
  rm "$counted"
}

# count_stages PREFIX COMMAND...: a line for each stage of bench_work, which COMMAND runs and counts.
count_stages() {
  local prefix="$1" stage count
  shift
  for stage in $(build/release/tests/bench/bench_work --list); do
    count="$("$@" "$stage" 2>&1 | sed -n 's/.*Collected : *//p')"
    [[ -n "$count" ]] || die "bench_work $stage: nothing was counted by $1"
    printf '%s %s\n' "$prefix$stage" "$count"
  done
}

# The counter knows no AVX-512, so the kernels are AVX2's everywhere, and then SSE4's, which have NEON's width.
count_here() {
  local set
  for set in avx2 sse4; do
    TALUS_INSTRUCTION_SET="$set" count_stages "$([[ "$set" == avx2 ]] || printf %s_ "$set")" valgrind --tool=callgrind \
      --callgrind-out-file=/dev/null --toggle-collect=talus_counted_work build/release/tests/bench/bench_work
  done
}

count_neon() {
  build golden-aarch64 -- bench_work
  gcc -O2 -shared -fPIC -o build/counted_work.so tests/bench/counted_work.c
  count_stages neon_ qemu-aarch64 -L /usr/aarch64-linux-gnu -plugin build/counted_work.so build/golden-aarch64/tests/bench/bench_work
}

# The modules that ./dev wasm made.
count_wasm() {
  local set counting=build/counted_world
  for set in simd scalar; do
    wasm2wat "client_sample/web/talus-js/wasm/talus-world$([[ "$set" == scalar ]] || printf -- -simd).wasm" |
      awk -f tests/bench/count_wasm.awk >"$counting.wat"
    wat2wasm "$counting.wat" -o "$counting.wasm"
    node tests/bench/count_wasm.mjs "$counting.wasm" "wasm_${set}_"
  done
}

lint() {
  [[ "${1:---fix}" == --fix && $# -le 1 ]] || wrong_use "lint: '${2:-$1}' is not --fix"
  deps build test format lint clang
  if [[ "${1:-}" == --fix ]]; then
    tracked '*.cpp' '*.h' | xargs clang-format-14 -i
  fi
  check_format
  check_layering
  # It reads the commands of clang's own build, and headers that the build makes.
  build clang -- talus_protocol
  say "running clang-tidy"
  tracked 'core/*.cpp' 'protocol/*.cpp' 'server/*.cpp' 'client_sample/*.cpp' |
    xargs -P "$jobs" -n 4 clang-tidy-14 -p build/clang --quiet --warnings-as-errors='*'
}

avx512() {
  no_arguments avx512 "$@"
  deps build test
  build release -DTALUS_TESTS=ON -- test_terrain test_voxel talus_golden_O3
  if grep -qw avx512bw /proc/cpuinfo && grep -qw avx512dq /proc/cpuinfo && grep -qw avx512vl /proc/cpuinfo; then
    say "the kernels' tests by AVX-512, on this processor"
    local -x TALUS_INSTRUCTION_SET=avx512
    build/release/tests/terrain/test_terrain -w NoTests "*instruction set*"
    build/release/tests/voxel/test_voxel -w NoTests "*instruction set*"
    build/release/tests/golden/talus_golden_O3 tests/golden/golden.txt
    return
  fi
  deps emulator
  build release -DTALUS_TESTS=ON -- talus_golden_O0
  say "the kernels' tests by AVX-512, emulated"
  tests/emulator/avx512.sh
}

fuzz() {
  (($# <= 1)) || wrong_use "fuzz: '$2' is not an argument; it takes the seconds of each target"
  local seconds="${1:-60}" target
  [[ "$seconds" =~ ^[1-9][0-9]{0,5}$ ]] || wrong_use "fuzz: '$seconds' is not a number of seconds from 1 to 999999"
  deps build clang
  local targets=(tests/fuzz/corpus/*)
  build fuzz -- "${targets[@]##*/}"
  mkdir -p out/fuzz
  for target in "${targets[@]}"; do
    local name="${target##*/}"
    say "fuzzing $name for $seconds seconds"
    mkdir -p "out/fuzz/$name"
    "build/fuzz/tests/fuzz/$name" -max_total_time="$seconds" -print_final_stats=1 -artifact_prefix="out/fuzz/$name-" \
      "out/fuzz/$name" "tests/fuzz/corpus/$name"
  done
}
