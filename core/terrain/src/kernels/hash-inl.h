// The hashes of lattice_hash.h in vectors. Included once per instruction set, hence this include guard:
#if defined(TALUS_HASH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TALUS_HASH_INL
#undef TALUS_HASH_INL
#else
#define TALUS_HASH_INL
#endif

#include <cstdint>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace talus::terrain::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// mix32.
HWY_INLINE hn::Vec<hn::ScalableTag<std::uint32_t>> mixed(hn::Vec<hn::ScalableTag<std::uint32_t>> key) {
  const hn::ScalableTag<std::uint32_t> w;
  key = hn::Mul(hn::Xor(key, hn::ShiftRight<16>(key)), hn::Set(w, 0x7FEB352DU));
  key = hn::Mul(hn::Xor(key, hn::ShiftRight<15>(key)), hn::Set(w, 0x846CA68BU));
  return hn::Xor(key, hn::ShiftRight<16>(key));
}

}  // namespace
}  // namespace talus::terrain::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
