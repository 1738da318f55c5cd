// Instruction sets. The hot loops of generation and coding are compiled once for each. All give the same
// bits, so the choice affects only speed.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace talus {

/// A build for x86-64 has the first four and takes the fastest that its processor has. Every other build has
/// one: neon (64-bit ARM), wasm128 (WebAssembly with SIMD128), or scalar.
enum class InstructionSet : std::uint8_t { scalar, sse4, avx2, avx512, neon, wasm128 };

/// Slowest first.
inline constexpr std::array kInstructionSets{InstructionSet::scalar, InstructionSet::sse4,
                                             InstructionSet::avx2,   InstructionSet::avx512,
                                             InstructionSet::neon,   InstructionSet::wasm128};

/// "scalar", "sse4", "avx2", "avx512", "neon", "wasm128".
[[nodiscard]] std::string_view to_string(InstructionSet set);

/// Returns true if this build has kernels for the set and this processor supports it.
[[nodiscard]] bool runs_here(InstructionSet set);

/// The environment variable that forces a set, for tests and comparisons.
inline constexpr const char* kInstructionSetVariable = "TALUS_INSTRUCTION_SET";

/// Returns the set named by TALUS_INSTRUCTION_SET or, if that is unset or empty, the fastest that runs here.
/// Fails with one line if this build has no such set or the set does not run here. Programs call it at
/// startup.
[[nodiscard]] tl::expected<InstructionSet, std::string> forced_instruction_set();

/// The set that all kernels use, fixed at the first call: the forced one, or the fastest if that is invalid.
[[nodiscard]] InstructionSet instruction_set();

}  // namespace talus
