#include <talus/vectors/instruction_set.h>

#include <cstdlib>

#include <talus/vectors/tables.h>

#include <hwy/highway.h>
#include <hwy/targets.h>

namespace talus {
namespace {

constexpr std::array kNames{std::string_view{"scalar"}, std::string_view{"sse4"}, std::string_view{"avx2"},
                            std::string_view{"avx512"}};

/// Highway's targets for a set, as a bit mask; 0 if the build does not have it.
std::int64_t targets_of(InstructionSet set) {
  constexpr std::array kTargets{std::int64_t{HWY_STATIC_TARGET}, std::int64_t{HWY_SSE4},
                                std::int64_t{HWY_AVX2}, std::int64_t{HWY_AVX3}};
  return kTargets[static_cast<std::size_t>(set)] & std::int64_t{HWY_TARGETS};
}

InstructionSet fastest() {
  for (const auto set : {InstructionSet::avx512, InstructionSet::avx2, InstructionSet::sse4}) {
    if (runs_here(set)) return set;
  }
  return InstructionSet::scalar;
}

}  // namespace

std::string_view to_string(InstructionSet set) {
  return kNames[static_cast<std::size_t>(set)];
}

bool runs_here(InstructionSet set) {
  return set == InstructionSet::scalar || (targets_of(set) & hwy::SupportedTargets()) != 0;
}

tl::expected<InstructionSet, std::string_view> forced_instruction_set() {
  const char* forced = std::getenv(kInstructionSetVariable);
  if (forced == nullptr || *forced == 0) return fastest();
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (kNames[i] != forced) continue;
    const auto set = static_cast<InstructionSet>(i);
    if (runs_here(set)) return set;
    return tl::unexpected<std::string_view>{
        "TALUS_INSTRUCTION_SET: this processor does not have that set; leave it out for the fastest that it "
        "has"};
  }
  return tl::unexpected<std::string_view>{
      "TALUS_INSTRUCTION_SET: no such set; it must be scalar, sse4, avx2 or avx512"};
}

InstructionSet instruction_set() {
  static const InstructionSet kSet = forced_instruction_set().value_or(fastest());
  return kSet;
}

}  // namespace talus
