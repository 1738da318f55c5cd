// How a kernel source gets a table of its functions for each instruction set.
#pragma once

#include <talus/vectors/instruction_set.h>

// Each kernel source is compiled once for every set below (Highway's foreach_target); a table exists for
// those that this compiler can make. Highway gives code for the compiler's own baseline whatever it is.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)

// The plain code is for vectors of one lane (HWY_SCALAR). Highway would emulate vectors of 16 bytes instead
// (HWY_EMU128) by compilers that it trusts to do so: clang, and g++ from 12.3 on.
#undef HWY_BROKEN_EMU128
#define HWY_BROKEN_EMU128 1

namespace talus {

/// Elements that kernels may touch past the end of the buffers that they call padded: two of the widest
/// vectors.
inline constexpr std::size_t kPadding = 32;

[[nodiscard]] constexpr std::size_t padded(std::size_t size) {
  return (size + kPadding - 1) / kPadding * kPadding + kPadding;
}

}  // namespace talus

// The address of a table for each InstructionSet, null where this build has none. To be used where HWY_ONCE.
#define TALUS_TABLES(table) \
  { HWY_CHOOSE_FALLBACK(table), HWY_CHOOSE_SSE4(table), HWY_CHOOSE_AVX2(table), HWY_CHOOSE_AVX3(table) }
