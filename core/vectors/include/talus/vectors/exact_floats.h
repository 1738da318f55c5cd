// Refuses to compile where floating-point arithmetic is not IEEE 754's, operation by operation: voxels would
// differ from those of other machines. Sources that compute with floats include it.
#pragma once

#include <cfloat>

#if defined(__FAST_MATH__)
#error "-ffast-math (and -Ofast) changes results: compile without"
#endif
#if !defined(FLT_EVAL_METHOD) || FLT_EVAL_METHOD != 0
#error "floats are computed in a wider type here: compile for i386 by -msse2 -mfpmath=sse"
#endif
// A compiler does not report whether it fuses a multiplication with an addition. CMake sets this with
// -ffp-contract=off.
#if !defined(TALUS_NO_CONTRACTION)
#error "compile with -ffp-contract=off, and then -DTALUS_NO_CONTRACTION"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif
