// Packs the bytes of a batch's coded voxels.
// Included once per instruction set, hence this guard:
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
#include <cstring>

#include <hwy/highway.h>

#include "volume_parts-inl.h"
#include "volume_vbmi.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace talus::HWY_NAMESPACE {
namespace {

/// By mask of eight voxels: the places of the selected ones, among sixteen of which every second counts.
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

/// Extracts every second bit of sixteen.
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

/// Calls put(at, order, place) for each sixteen bytes of the parts: `order` lists the coded bytes in even or
/// odd columns, which go to `place`. Returns their total number.
template <bool odd, class Put>
HWY_INLINE std::size_t over_coded(const PartBits* coded, std::size_t parts, const Put& put) {
  const hn::FixedTag<std::uint8_t, 8> eight;
  std::size_t place = 0;
  for (std::size_t i = 0; i < parts; ++i) {
    for (std::size_t at = 0; at < kPartBytes; at += kLanes) {
      const auto bits = static_cast<std::uint32_t>(coded[i] >> at & 0xFFFFU) >> (odd ? 1U : 0U);
      const std::uint32_t which = every_other(bits);
      auto order = hn::LoadU(eight, kEveryOther[which].data());
      if constexpr (odd) order = hn::Or(order, hn::Set(eight, 1));
      put(i * kPartBytes + at, order, place);
      place += static_cast<std::size_t>(std::popcount(which));
    }
  }
  return place;
}

/// Appends the bytes of coded voxels in even or odd columns; returns their number. May write one part past
/// the last.
template <bool odd>
HWY_INLINE std::size_t pack_coded(const std::uint8_t* bytes, const PartBits* coded, std::size_t parts,
                                  const VolumeVbmi* vbmi, std::uint8_t* out) {
#if HWY_TARGET == HWY_AVX3
  if (HWY_LIKELY(vbmi != nullptr)) return vbmi->pack(coded, odd ? kOddBits : kEvenBits, bytes, parts, out);
#else
  (void)vbmi;
#endif
  return over_coded<odd>(coded, parts, [&](std::size_t at, auto order, std::size_t place) HWY_ATTR {
    hn::StoreU(hn::TableLookupBytes(hn::LoadU(Half{}, bytes + at), order), hn::DFromV<decltype(order)>{},
               out + place);
  });
}

/// Bits of part i of a wave.
HWY_INLINE const std::uint8_t* part_bits(const RowWords& words, std::size_t i) {
  return reinterpret_cast<const std::uint8_t*>(words.data()) + i * kPartBytes / 8;
}
HWY_INLINE PartMask part_mask(const RowWords& words, std::size_t i) {
  return hn::LoadMaskBits(Part{}, part_bits(words, i));
}

/// Appends contexts and symbols of a wave's coded voxels in `pairs` pairs of rows, even columns first. May
/// write 64 bytes past the last.
HWY_INLINE CodedHalves pack_wave(const WaveBits& bits, std::size_t pairs, const VolumeVbmi* vbmi,
                                 std::uint8_t* contexts, std::uint8_t* symbols) {
#if HWY_TARGET == HWY_AVX3
  if (HWY_LIKELY(vbmi != nullptr)) return vbmi->pack_wave(bits, pairs, contexts, symbols);
#else
  (void)vbmi;
#endif
  constexpr std::size_t kRowParts = kWaveRows * kRowBytes / kPartBytes;
  alignas(64) std::array<std::uint8_t, kWaveRows * kRowBytes> all_contexts;
  alignas(64) std::array<std::uint8_t, kWaveRows * kRowBytes> all_symbols;
  std::array<PartBits, kRowParts> coded;
  const std::size_t parts = 2 * pairs * kRowBytes / kPartBytes;
  for (std::size_t i = 0; i < parts; ++i) {
    coded[i] = 0;
    std::memcpy(&coded[i], part_bits(bits.coded, i), kPartBytes / 8);
    if (coded[i] == 0) continue;
    PartVec context = hn::Zero(Part{});
    for (std::size_t b = 0; b < bits.context.size(); ++b) {
      context = or_where(context, part_mask(bits.context[b], i), static_cast<std::uint8_t>(1U << b));
    }
    store(context, all_contexts.data() + i * kPartBytes);
    const PartVec low = hn::IfThenElseZero(part_mask(bits.symbol[0], i), bytes_of(1));
    store(or_where(low, part_mask(bits.symbol[1], i), 2), all_symbols.data() + i * kPartBytes);
  }
  const auto pack = [&](std::size_t start) HWY_ATTR {
    return [&, start](std::size_t at, auto order, std::size_t place) HWY_ATTR {
      const hn::DFromV<decltype(order)> eight;
      hn::StoreU(hn::TableLookupBytes(hn::LoadU(Half{}, all_contexts.data() + at), order), eight,
                 contexts + start + place);
      hn::StoreU(hn::TableLookupBytes(hn::LoadU(Half{}, all_symbols.data() + at), order), eight,
                 symbols + start + place);
    };
  };
  CodedHalves sizes;
  sizes.even = over_coded<false>(coded.data(), parts, pack(0));
  sizes.odd = over_coded<true>(coded.data(), parts, pack(sizes.even));
  return sizes;
}

}  // namespace
}  // namespace talus::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#endif
