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

// Rows are 0 to 32: they fit signed bytes, which compare in one instruction.
using FullBytes = hn::ScalableTag<std::uint8_t>;
using FullRows = hn::RebindToSigned<FullBytes>;
using FullWords = hn::ScalableTag<std::uint16_t>;
using BytesOfWords = hn::Rebind<std::uint8_t, FullWords>;

const std::int8_t* rows(const std::uint8_t* bytes) {
  return reinterpret_cast<const std::int8_t*>(bytes);
}

Extent extent(const std::uint8_t* plane) {
  const FullBytes d;
  auto low = hn::LoadU(d, plane);
  auto high = low;
  for (std::size_t i = hn::Lanes(d); i < kChunkArea; i += hn::Lanes(d)) {
    const auto more = hn::LoadU(d, plane + i);
    low = hn::Min(low, more);
    high = hn::Max(high, more);
  }
  std::array<std::uint8_t, hn::MaxLanes(FullBytes{})> lows;
  std::array<std::uint8_t, hn::MaxLanes(FullBytes{})> highs;
  hn::StoreU(low, d, lows.data());
  hn::StoreU(high, d, highs.data());
  const auto lanes = static_cast<std::ptrdiff_t>(hn::Lanes(d));
  return {*std::min_element(lows.begin(), lows.begin() + lanes),
          *std::max_element(highs.begin(), highs.begin() + lanes)};
}

/// Stores the bytes of columns as voxels.
template <class Vec>
HWY_INLINE void widen(Vec bytes, std::uint16_t* out) {
  const FullWords d;
#if HWY_TARGET == HWY_SCALAR  // a vector of one lane has no halves
  hn::StoreU(hn::PromoteTo(d, bytes), d, out);
#else
  const BytesOfWords halves;
  hn::StoreU(hn::PromoteTo(d, hn::LowerHalf(halves, bytes)), d, out);
  hn::StoreU(hn::PromoteTo(d, hn::UpperHalf(halves, bytes)), d, out + hn::Lanes(d));
#endif
}

/// The material above each plane replaces the one below in columns whose top is not above row y: plane after
/// plane, without branches. With `known_planes` the loop over them is unrolled; -1 means any number.
template <int known_planes, class Write>
HWY_INLINE void over_planes(const CutSlice& slice, const Write& write) {
  const FullBytes d;
  const FullRows compared;
  const auto y = hn::Set(compared, static_cast<std::int8_t>(slice.y));
  const std::size_t planes = known_planes < 0 ? slice.planes : static_cast<std::size_t>(known_planes);
  for (std::size_t i = 0; i < kChunkArea; i += hn::Lanes(d)) {
    auto bytes = hn::Set(d, slice.bytes[0]);
    for (std::size_t p = 0; p < planes; ++p) {
      const auto tops = hn::LoadU(compared, rows(slice.tops) + p * kChunkArea + i);
      bytes = hn::IfThenElse(hn::RebindMask(d, hn::Gt(tops, y)), bytes, hn::Set(d, slice.bytes[p + 1]));
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
  auto* const out = reinterpret_cast<std::uint16_t*>(voxels);
  over_slice(slice, [out](auto bytes, std::size_t i) HWY_ATTR { widen(bytes, out + i); });
}

void slice_bytes(const CutSlice& slice, std::uint8_t* out) {
  over_slice(slice, [out](auto bytes, std::size_t i) HWY_ATTR { hn::StoreU(bytes, FullBytes{}, out + i); });
}

}  // namespace

constexpr VoxelKernels kVoxels{extent, slice, slice_bytes};

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
