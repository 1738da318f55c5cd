#include "kernels.h"

#include <algorithm>
#include <array>

#include <talus/vectors/tables.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace talus::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// Rows are 0 to 32, so that bytes with a sign hold them, and compare in one instruction.
using Bytes = hn::CappedTag<std::uint8_t, kChunkSize>;
using Rows = hn::RebindToSigned<Bytes>;
using Words = hn::CappedTag<std::uint16_t, kChunkSize>;
using HalfBytes = hn::Rebind<std::uint8_t, Words>;

const std::int8_t* rows(const std::uint8_t* bytes) {
  return reinterpret_cast<const std::int8_t*>(bytes);
}

/// 0, 1 or 2 for a below, equal to or above b.
template <class Vec>
HWY_INLINE Vec sign(Vec a, Vec b) {
  const Rows d;
  const auto above = hn::VecFromMask(d, hn::Gt(a, b));  // -1 where true
  const auto below = hn::VecFromMask(d, hn::Lt(a, b));
  return hn::Add(hn::Sub(hn::Set(d, 1), above), below);
}

/// 3 * high + low. Past 127 the sign is wrong and the bits are right.
template <class Vec>
HWY_INLINE Vec digits(Vec high, Vec low) {
  return hn::Add(hn::Add(high, high), hn::Add(high, low));
}

void guess(const codec::RowsBefore& before, codec::RowGuess& guess) {
  const Rows d;
  const std::size_t lanes = hn::Lanes(d);
  // x from -1 to 33, the row's ends once more beyond them.
  HWY_ALIGN std::array<std::int8_t, kChunkSize + 4> north;
  for (std::size_t x = 0; x < kChunkSize; x += lanes) {
    hn::StoreU(hn::LoadU(d, rows(before.north) + x), d, north.data() + 1 + x);
  }
  north[0] = north[1];
  north[kChunkSize + 1] = north[kChunkSize + 2] = north[kChunkSize];

  HWY_ALIGN std::array<std::uint8_t, kChunkSize> signs;
  HWY_ALIGN std::array<std::uint8_t, kChunkSize> bareness;
  const std::int8_t* const steps = before.steps_north->padded.data();
  for (std::size_t x = 0; x < kChunkSize; x += lanes) {
    const auto here = hn::LoadU(d, north.data() + x + 1);
    const auto floor = hn::LoadU(d, rows(before.floor) + x);
    const auto floor_north = hn::LoadU(d, rows(before.floor_north) + x);
    const auto bare = hn::Eq(here, floor_north);
    const auto predicted = hn::IfThenElse(bare, floor, hn::Max(here, floor));
    hn::StoreU(predicted, d, reinterpret_cast<std::int8_t*>(guess.predicted.data()) + x);

    auto all = sign(here, hn::LoadU(d, north.data() + x));
    all = digits(all, sign(hn::LoadU(d, north.data() + x + 3), here));
    all = digits(all, sign(hn::LoadU(d, steps + x + 2), hn::Zero(d)));
    all = digits(all, sign(hn::LoadU(d, steps + x), hn::Zero(d)));
    all = digits(all, sign(floor, floor_north));
    const Bytes bytes;
    const auto half = hn::Set(bytes, static_cast<std::uint8_t>(codec::kRowContexts / 2));
    hn::StoreU(hn::BitCast(bytes, all), bytes, signs.data() + x);
    hn::StoreU(hn::And(hn::BitCast(bytes, hn::VecFromMask(d, bare)), half), bytes, bareness.data() + x);
  }
  const Words words;
  const HalfBytes halves;
  for (std::size_t x = 0; x < kChunkSize; x += hn::Lanes(words)) {
    const auto low = hn::PromoteTo(words, hn::LoadU(halves, signs.data() + x));
    const auto high = hn::PromoteTo(words, hn::LoadU(halves, bareness.data() + x));
    hn::StoreU(hn::Add(low, high), words, guess.context.data() + x);
  }
}

void classify(const std::uint8_t* row, const codec::RowGuess& guess, codec::Steps& steps,
              codec::RowSymbols& symbols) {
  const Rows d;
  const std::size_t lanes = hn::Lanes(d);
  for (std::size_t x = 0; x < kChunkSize; x += lanes) {
    const auto predicted = hn::LoadU(d, rows(guess.predicted.data()) + x);
    hn::StoreU(hn::Sub(hn::LoadU(d, rows(row) + x), predicted), d, steps.data() + x);
  }
  HWY_ALIGN std::array<std::uint8_t, kChunkSize> wests;
  const auto one = hn::Set(d, 1);
  const auto minus_one = hn::Set(d, -1);
  const auto number_of = [&](auto step) HWY_ATTR {
    static_assert(codec::kOneUp == static_cast<int>(codec::West::up) &&
                  codec::kOneDown == static_cast<int>(codec::West::down) &&
                  codec::kFurtherOff == static_cast<int>(codec::West::steep));
    const auto flat = hn::Eq(step, hn::Zero(d));
    const auto up = hn::Eq(step, one);
    const auto down = hn::Eq(step, minus_one);
    const auto not_up = hn::IfThenElse(down, hn::Set(d, 2), hn::Set(d, 3));
    return hn::IfThenZeroElse(flat, hn::IfThenElse(up, one, not_up));
  };
  for (std::size_t x = 0; x < kChunkSize; x += lanes) {
    const auto west = hn::LoadU(d, steps.padded.data() + x);
    const auto kind = number_of(west);
    const auto carried = hn::IfThenElseZero(hn::Eq(kind, hn::Set(d, 3)), west);
    const Bytes bytes;
    const auto symbol = number_of(hn::Sub(hn::LoadU(d, steps.data() + x), carried));
    hn::StoreU(hn::BitCast(bytes, symbol), bytes, symbols.symbol.data() + x);
    hn::StoreU(hn::BitCast(bytes, kind), bytes, wests.data() + x);
  }
  const Words words;
  const HalfBytes halves;
  const auto contexts = hn::Set(words, static_cast<std::uint16_t>(codec::kRowContexts));
  for (std::size_t x = 0; x < kChunkSize; x += hn::Lanes(words)) {
    const auto west = hn::PromoteTo(words, hn::LoadU(halves, wests.data() + x));
    const auto context = hn::Add(hn::LoadU(words, guess.context.data() + x), hn::Mul(west, contexts));
    hn::StoreU(context, words, symbols.context.data() + x);
  }
}

bool apply(const codec::RowGuess& guess, const codec::Steps& steps, const std::uint8_t* floor,
           std::uint8_t* row) {
  const Rows d;
  bool inside = true;
  for (std::size_t x = 0; x < kChunkSize; x += hn::Lanes(d)) {
    // -32 to 64: no byte with a sign overflows.
    const auto top = hn::Add(hn::LoadU(d, rows(guess.predicted.data()) + x), hn::LoadU(d, steps.data() + x));
    const auto least = hn::LoadU(d, rows(floor) + x);
    const auto low = hn::Lt(top, least);
    const auto high = hn::Gt(top, hn::Set(d, kChunkSize));
    inside = hn::AllFalse(d, hn::Or(low, high)) && inside;
    hn::StoreU(top, d, reinterpret_cast<std::int8_t*>(row) + x);
  }
  return inside;
}

Extent extent(const std::uint8_t* plane) {
  const Bytes d;
  auto low = hn::LoadU(d, plane);
  auto high = low;
  for (std::size_t i = hn::Lanes(d); i < kChunkArea; i += hn::Lanes(d)) {
    const auto more = hn::LoadU(d, plane + i);
    low = hn::Min(low, more);
    high = hn::Max(high, more);
  }
  std::array<std::uint8_t, kChunkSize> lows;
  std::array<std::uint8_t, kChunkSize> highs;
  hn::StoreU(low, d, lows.data());
  hn::StoreU(high, d, highs.data());
  const auto lanes = static_cast<std::ptrdiff_t>(hn::Lanes(d));
  return {*std::min_element(lows.begin(), lows.begin() + lanes),
          *std::max_element(highs.begin(), highs.begin() + lanes)};
}

using Voxels = std::uint16_t;

/// Bytes of columns as voxels.
template <class Vec>
HWY_INLINE void widen(Vec bytes, Voxels* out) {
  const Words d;
#if HWY_TARGET == HWY_SCALAR  // a vector of one lane has no halves
  hn::StoreU(hn::PromoteTo(d, bytes), d, out);
#else
  if constexpr (hn::MaxLanes(Words{}) == hn::MaxLanes(Bytes{})) {
    hn::StoreU(hn::PromoteTo(d, bytes), d, out);
  } else {
    const HalfBytes halves;
    hn::StoreU(hn::PromoteTo(d, hn::LowerHalf(halves, bytes)), d, out);
    hn::StoreU(hn::PromoteTo(d, hn::UpperHalf(halves, bytes)), d, out + hn::Lanes(d));
  }
#endif
}

/// What lies above a plane takes the columns in which it is not higher: plane after plane, without a branch.
/// With `known_planes` the loop over them is unrolled; -1 is for any number.
template <int known_planes, class Write>
HWY_INLINE void over_planes(const CutSlice& slice, const Write& write) {
  const Bytes d;
  const Rows compared;
  const auto y = hn::Set(compared, static_cast<std::int8_t>(slice.y));
  const std::size_t planes = known_planes < 0 ? slice.planes : static_cast<std::size_t>(known_planes);
  for (std::size_t i = 0; i < kChunkArea; i += hn::Lanes(d)) {
    auto bytes = hn::Set(d, slice.bytes[0]);
    for (std::size_t p = 0; p < planes; ++p) {
      const auto tops = hn::LoadU(compared, rows(slice.tops) + p * kChunkArea + i);
      const auto higher = hn::VecFromMask(compared, hn::Gt(tops, y));
      bytes = hn::IfThenElse(hn::MaskFromVec(hn::BitCast(d, higher)), bytes, hn::Set(d, slice.bytes[p + 1]));
    }
    write(bytes, i);
  }
}

template <class Write>
HWY_INLINE void over_slice(const CutSlice& slice, const Write& write) {
  switch (slice.planes) {
    case 0:
      return over_planes<0>(slice, write);
    case 1:
      return over_planes<1>(slice, write);
    case 2:
      return over_planes<2>(slice, write);
    case 3:
      return over_planes<3>(slice, write);
    default:
      return over_planes<-1>(slice, write);
  }
}

void slice(const CutSlice& slice, MaterialId* voxels) {
  auto* const out = reinterpret_cast<Voxels*>(voxels);
  over_slice(slice, [out](auto bytes, std::size_t i) HWY_ATTR { widen(bytes, out + i); });
}

void slice_bytes(const CutSlice& slice, std::uint8_t* out) {
  over_slice(slice, [out](auto bytes, std::size_t i) HWY_ATTR { hn::StoreU(bytes, Bytes{}, out + i); });
}

}  // namespace

constexpr VoxelKernels kVoxels{guess, classify, apply, extent, slice, slice_bytes};

}  // namespace talus::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace talus {

const VoxelKernels& voxel_kernels(InstructionSet set) {
  static constexpr const VoxelKernels* kTables[] = TALUS_TABLES(kVoxels);
  return *kTables[static_cast<std::size_t>(set)];
}

const VoxelKernels& voxel_kernels() {
  static const VoxelKernels& kKernels = voxel_kernels(instruction_set());
  return kKernels;
}

}  // namespace talus
#endif
