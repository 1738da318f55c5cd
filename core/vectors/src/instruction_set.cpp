#include <talus/vectors/instruction_set.h>

#include <array>
#include <cstdlib>
#include <string>

#include <talus/vectors/tables.h>

#include <hwy/highway.h>

namespace talus {
namespace {

constexpr std::array<std::string_view, kInstructionSets.size()> kNames{"scalar", "sse4", "avx2",
                                                                       "avx512", "neon", "wasm128"};
constexpr std::array<std::int64_t, kInstructionSets.size()> kTargets{HWY_SCALAR, HWY_SSE4, HWY_AVX2,
                                                                     HWY_AVX3,   HWY_NEON, HWY_WASM};

bool compiled(InstructionSet set) {
  return (kTargets[static_cast<std::size_t>(set)] & std::int64_t{HWY_TARGETS}) != 0;
}

/// The best set among those that every processor of the build has.
[[nodiscard]] constexpr InstructionSet baseline() {
  for (const auto set : kInstructionSets) {
    if (kTargets[static_cast<std::size_t>(set)] == std::int64_t{HWY_STATIC_TARGET}) return set;
  }
  return InstructionSet::scalar;
}

bool processor_has(InstructionSet set) {
  if (set == baseline()) return true;
#if defined(__x86_64__)
  // What Highway lets the compiler use for each.
  switch (set) {
    case InstructionSet::sse4:
      return __builtin_cpu_supports("sse4.2") != 0 && __builtin_cpu_supports("pclmul") != 0 &&
             __builtin_cpu_supports("aes") != 0;
    case InstructionSet::avx2:
      return processor_has(InstructionSet::sse4) && __builtin_cpu_supports("avx2") != 0 &&
             __builtin_cpu_supports("bmi") != 0 && __builtin_cpu_supports("bmi2") != 0 &&
             __builtin_cpu_supports("fma") != 0;
    case InstructionSet::avx512:
      return processor_has(InstructionSet::avx2) && __builtin_cpu_supports("avx512f") != 0 &&
             __builtin_cpu_supports("avx512vl") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
             __builtin_cpu_supports("avx512bw") != 0;
    default:
      break;
  }
#endif
  return false;
}

InstructionSet fastest() {
  InstructionSet best = baseline();
  for (const auto set : kInstructionSets) {
    if (runs_here(set)) best = set;
  }
  return best;
}

std::string names_of_build() {
  std::string names;
  for (const auto set : kInstructionSets) {
    if (compiled(set)) names += (names.empty() ? "" : ", ") + std::string{to_string(set)};
  }
  return names;
}

}  // namespace

std::string_view to_string(InstructionSet set) {
  return kNames[static_cast<std::size_t>(set)];
}

bool runs_here(InstructionSet set) {
  return compiled(set) && processor_has(set);
}

tl::expected<InstructionSet, std::string> forced_instruction_set() {
  const char* forced = std::getenv(kInstructionSetVariable);
  if (forced == nullptr || *forced == 0) return fastest();
  for (const auto set : kInstructionSets) {
    if (to_string(set) != forced || !compiled(set)) continue;
    if (runs_here(set)) return set;
    return tl::unexpected<std::string>{
        "TALUS_INSTRUCTION_SET: this processor does not have that set; leave it out for the fastest that it "
        "has"};
  }
  return tl::unexpected{"TALUS_INSTRUCTION_SET: this build has no such set; it has " + names_of_build()};
}

InstructionSet instruction_set() {
  static const InstructionSet kSet = forced_instruction_set().value_or(fastest());
  return kSet;
}

}  // namespace talus
