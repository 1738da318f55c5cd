// Packing the bytes of a batch's coded voxels side by side.
// Included once for each instruction set, hence no include guard but this:
#if defined(TALUS_VOLUME_BATCH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TALUS_VOLUME_BATCH_INL
#undef TALUS_VOLUME_BATCH_INL
#else
#define TALUS_VOLUME_BATCH_INL
#endif

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include "volume_parts-inl.h"
#include "volume_vbmi.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace talus::HWY_NAMESPACE {
namespace {

/// By a mask of eight voxels: the places of those that it has, among sixteen of which every second counts.
alignas(8) inline constexpr auto kEveryOther = [] {
  std::array<std::array<std::uint8_t, 8>, 256> table{};
  for (std::size_t mask = 0; mask < 256; ++mask) {
    std::size_t place = 0;
    for (std::uint8_t i = 0; i < 8; ++i) {
      if ((mask >> i & 1U) != 0) table[mask][place++] = static_cast<std::uint8_t>(2 * i);
    }
  }
  return table;
}();

/// Every second bit of sixteen.
HWY_INLINE std::uint32_t every_other(std::uint32_t bits) {
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
  return _pext_u32(bits, 0x5555);
#else
  bits &= 0x5555U;
  bits = (bits | bits >> 1U) & 0x3333U;
  bits = (bits | bits >> 2U) & 0x0F0FU;
  return (bits | bits >> 4U) & 0xFFU;
#endif
}

/// Appends the bytes of coded voxels, which are in even columns, or in odd ones; gives how many. May write a
/// part past the last.
template <bool odd>
HWY_INLINE std::size_t pack_coded(const std::uint8_t* bytes, const PartBits* coded, std::size_t parts,
                                  const VolumeVbmi* vbmi, std::uint8_t* out) {
#if HWY_TARGET == HWY_AVX3
  if (HWY_LIKELY(vbmi != nullptr)) return vbmi->pack(coded, bytes, parts, out);
#else
  (void)vbmi;
#endif
  const Half d;
  const hn::FixedTag<std::uint8_t, 8> eight;
  std::uint8_t* to = out;
  for (std::size_t i = 0; i < parts; ++i) {
    for (std::size_t at = 0; at < kPartBytes; at += kLanes) {
      const auto bits = static_cast<std::uint32_t>(coded[i] >> at & 0xFFFFU) >> (odd ? 1U : 0U);
      const std::uint32_t which = every_other(bits);
      const HalfVec some = hn::LoadU(d, bytes + i * kPartBytes + at);
      auto order = hn::LoadU(eight, kEveryOther[which].data());
      if constexpr (odd) order = hn::Or(order, hn::Set(eight, 1));
      hn::StoreU(hn::TableLookupBytes(some, order), eight, to);
      to += std::popcount(which);
    }
  }
  return static_cast<std::size_t>(to - out);
}

}  // namespace
}  // namespace talus::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#endif
