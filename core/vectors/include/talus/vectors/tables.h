// Gives a kernel source a table of its functions for each instruction set.
#pragma once

#include <talus/vectors/instruction_set.h>

// Each kernel source is compiled once for every set below (Highway's foreach_target). Only sets that this
// compiler supports get a table. Highway always generates code for the compiler's own baseline.
// TALUS_OTHER_TARGETS are those that a quick build leaves out (TALUS_QUICK).
#ifndef TALUS_OTHER_TARGETS
#define TALUS_OTHER_TARGETS 0
#endif
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL | TALUS_OTHER_TARGETS)

// Scalar code uses vectors of one lane (HWY_SCALAR). With compilers that Highway trusts (clang, and g++ from
// 12.3 on) it would otherwise emulate 16-byte vectors (HWY_EMU128).
#undef HWY_BROKEN_EMU128
#define HWY_BROKEN_EMU128 1

namespace talus {

/// Elements that kernels may access past the end of a padded buffer: two of the widest vectors.
inline constexpr std::size_t kPadding = 32;

[[nodiscard]] constexpr std::size_t padded(std::size_t size) {
  return (size + kPadding - 1) / kPadding * kPadding + kPadding;
}

}  // namespace talus

// The table's address for each InstructionSet, null if this build has no code for it. For use in HWY_ONCE.
#define TALUS_TABLES(table) \
  { HWY_CHOOSE_FALLBACK(table), HWY_CHOOSE_SSE4(table), HWY_CHOOSE_AVX2(table), HWY_CHOOSE_AVX3(table) }
