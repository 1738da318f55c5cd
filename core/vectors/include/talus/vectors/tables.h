// Gives a kernel source a table of its functions for each instruction set.
#pragma once

#include <talus/vectors/exact_floats.h>
#include <talus/vectors/instruction_set.h>

// Each kernel source is compiled once for every set below (Highway's foreach_target). Only sets that this
// compiler supports get a table. Highway always generates code for the compiler's own baseline.
// TALUS_OTHER_TARGETS are those that a quick build leaves out (TALUS_QUICK).
#ifndef TALUS_OTHER_TARGETS
#define TALUS_OTHER_TARGETS 0
#endif
// Vectors whose size is not known to the compiler are left out; so is NEON of 32-bit ARM, which takes numbers
// below the normal ones for zero, and has no doubles.
#undef HWY_DISABLED_TARGETS
#if defined(__ARM_NEON) && !defined(__aarch64__)
#define TALUS_INEXACT_TARGETS HWY_NEON
#else
#define TALUS_INEXACT_TARGETS 0
#endif
#define HWY_DISABLED_TARGETS                                                                        \
  (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | HWY_PPC8 | \
   TALUS_INEXACT_TARGETS | TALUS_OTHER_TARGETS)
#if !defined(__x86_64__)
#define HWY_COMPILE_ONLY_STATIC
#define TOOLCHAIN_MISS_SYS_AUXV_H  // else Highway gives kernels of ARM more than the compiler's flags, and
                                   // g++ inlines nothing
#endif

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

// The table's address for each InstructionSet, null if this build has no code for it. The first is that of
// the compiler's own baseline, which is not scalar in every build (runs_here()). For use in HWY_ONCE.
#define TALUS_TABLES(table)                                                                             \
  {                                                                                                     \
    HWY_CHOOSE_FALLBACK(table), HWY_CHOOSE_SSE4(table), HWY_CHOOSE_AVX2(table), HWY_CHOOSE_AVX3(table), \
        HWY_CHOOSE_NEON(table), HWY_CHOOSE_WASM(table)                                                  \
  }
