// The loops in which generation and coding spend their time exist once for each instruction set. All give the
// same bits, so which one runs is a matter of speed alone.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include <tl/expected.hpp>

namespace talus {

/// Slowest first. `scalar` runs on every processor that the build is for.
enum class InstructionSet : std::uint8_t { scalar, sse4, avx2, avx512 };

/// "scalar", "sse4", "avx2", "avx512".
[[nodiscard]] std::string_view to_string(InstructionSet set);

/// Whether this build has kernels for the set and this processor runs them.
[[nodiscard]] bool runs_here(InstructionSet set);

/// The environment variable that forces a set, for tests and comparisons.
inline constexpr const char* kInstructionSetVariable = "TALUS_INSTRUCTION_SET";

/// What TALUS_INSTRUCTION_SET asks for, or else the fastest that runs here. An error is one line: the name is
/// not known, or does not run here. Programs call it when they start.
[[nodiscard]] tl::expected<InstructionSet, std::string_view> forced_instruction_set();

/// The set that all kernels use from the first call on: the forced one, or the fastest where that is wrong.
[[nodiscard]] InstructionSet instruction_set();

}  // namespace talus
