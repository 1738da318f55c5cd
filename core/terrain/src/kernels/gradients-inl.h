// Gradients of lattice corners from hashes. Included once per instruction set, hence this include guard:
#if defined(TALUS_GRADIENTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TALUS_GRADIENTS_INL
#undef TALUS_GRADIENTS_INL
#else
#define TALUS_GRADIENTS_INL
#endif

#include <hwy/highway.h>

#include "kernels/hash-inl.h"

HWY_BEFORE_NAMESPACE();
namespace talus::terrain::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::ScalableTag<float>;
using Words = hn::RebindToUnsigned<Floats>;

// 16 directions of length sqrt(2), so that the noise spans -1 to 1. They are turned by half a step, so that
// no direction lies along an axis or a diagonal, which would make the lattice visible. The top two bits of a
// hash are the quadrant, the next two the direction in it: of four magnitudes, sqrt(2) times the cosine of
// 11.25, 33.75, 56.25 and 78.75 degrees, one is x and its complement z, swapped in every second quadrant.
HWY_ALIGN constexpr float kMagnitudes[4] = {1.38703985F, 1.17587560F, 0.78569496F, 0.27589938F};

HWY_INLINE hn::Vec<Words> magnitude(hn::Vec<Words> index) {
#if HWY_TARGET == HWY_SCALAR
  return hn::BitCast(Words{}, hn::Set(Floats{}, kMagnitudes[hn::GetLane(index)]));
#else
  // Four byte indices per lane: 4 k + 3, 4 k + 2, 4 k + 1, 4 k for magnitude k.
  const auto bytes = hn::Add(hn::Mul(index, hn::Set(Words{}, 0x04040404U)), hn::Set(Words{}, 0x03020100U));
  return hn::TableLookupBytes(hn::BitCast(Words{}, hn::LoadDup128(Floats{}, kMagnitudes)), bytes);
#endif
}

struct Gradient {
  hn::Vec<Floats> x;
  hn::Vec<Floats> z;
};

/// The gradients of the corners with axis hashes `a` and `b`, as in corner_hash() of lattice_hash.h; b is
/// rotated by 16 bits.
HWY_INLINE Gradient gradient_at(hn::Vec<Words> a, hn::Vec<Words> turned_b) {
  const Floats f;
  const Words w;
  const auto sign = hn::Set(w, 0x80000000U);
  const auto hash = mixed(hn::Xor(a, turned_b));
  const auto second = hn::ShiftLeft<1>(hash);
  const auto mirrored = hn::And(hn::Sub(hn::Zero(w), hn::ShiftRight<31>(second)), hn::Set(w, 3));
  const auto chosen = hn::Xor(hn::And(hn::ShiftRight<28>(hash), hn::Set(w, 3)), mirrored);
  const auto x = magnitude(chosen);
  const auto z = magnitude(hn::Xor(chosen, hn::Set(w, 3)));
  return {hn::BitCast(f, hn::Xor(x, hn::And(hn::Xor(hash, second), sign))),
          hn::BitCast(f, hn::Xor(z, hn::And(hash, sign)))};
}

}  // namespace
}  // namespace talus::terrain::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
