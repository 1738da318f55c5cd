#include "chunk_planes.h"

#include <talus/voxel/coords.h>

#include <talus/vectors/tables.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/chunk_planes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace talus::terrain::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Bytes = hn::ScalableTag<std::uint8_t>;
// Rows are below 128, so signed comparisons work, which all instruction sets have.
using Rows = hn::ScalableTag<std::int8_t>;

auto load(const std::uint8_t* plane, std::size_t i) {
  return hn::BitCast(Rows{}, hn::LoadU(Bytes{}, plane + i));
}

void lower_of(const std::uint8_t* a, const std::uint8_t* b, std::uint8_t* out) {
  const Bytes d;
  for (std::size_t i = 0; i < kChunkArea; i += hn::Lanes(d)) {
    hn::StoreU(hn::Min(hn::LoadU(d, a + i), hn::LoadU(d, b + i)), d, out + i);
  }
}

void higher_of(const std::uint8_t* a, const std::uint8_t* b, std::uint8_t* out) {
  const Bytes d;
  for (std::size_t i = 0; i < kChunkArea; i += hn::Lanes(d)) {
    hn::StoreU(hn::Max(hn::LoadU(d, a + i), hn::LoadU(d, b + i)), d, out + i);
  }
}

std::size_t count_inside(const std::uint8_t* from, const std::uint8_t* to, const std::uint8_t* bottom,
                         const std::uint8_t* top) {
  const Rows d;
  std::size_t count = 0;
  for (std::size_t i = 0; i < kChunkArea; i += hn::Lanes(d)) {
    const auto low = load(from, i);
    const auto high = load(to, i);
    const auto outside = hn::Or(hn::Lt(low, load(bottom, i)), hn::Lt(load(top, i), high));
    count += hn::CountTrue(d, hn::AndNot(outside, hn::Lt(low, high)));
  }
  return count;
}

bool any(const std::uint8_t* from, const std::uint8_t* to) {
  const Rows d;
  for (std::size_t i = 0; i < kChunkArea; i += hn::Lanes(d)) {
    if (!hn::AllFalse(d, hn::Lt(load(from, i), load(to, i)))) return true;
  }
  return false;
}

void interval(const std::uint8_t* from, const std::uint8_t* to, const std::uint8_t* other, std::uint8_t* low,
              std::uint8_t* high) {
  const Bytes d;
  for (std::size_t i = 0; i < kChunkArea; i += hn::Lanes(d)) {
    const auto here = hn::Lt(load(from, i), load(to, i));
    const auto else_row = load(other, i);
    hn::StoreU(hn::BitCast(d, hn::IfThenElse(here, load(from, i), else_row)), d, low + i);
    hn::StoreU(hn::BitCast(d, hn::IfThenElse(here, load(to, i), else_row)), d, high + i);
  }
}

void raise_where(const std::uint8_t* looks, std::size_t stride, std::uint8_t look, const std::uint8_t* plane,
                 std::uint8_t* rows) {
  const hn::CappedTag<std::uint8_t, kChunkSize> d;
  const auto wanted = hn::Set(d, look);
  for (int z = 0; z < kChunkSize; ++z, looks += stride) {
    for (std::size_t x = 0; x < kChunkSize; x += hn::Lanes(d), plane += hn::Lanes(d), rows += hn::Lanes(d)) {
      const auto here = hn::Eq(hn::LoadU(d, looks + x), wanted);
      hn::StoreU(hn::IfThenElse(here, hn::LoadU(d, plane), hn::LoadU(d, rows)), d, rows);
    }
  }
}

}  // namespace

constexpr ChunkPlaneKernels kChunkPlanes{lower_of, higher_of, count_inside, any, interval, raise_where};

}  // namespace talus::terrain::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace talus::terrain {

const ChunkPlaneKernels& chunk_plane_kernels(InstructionSet set) {
  static constexpr const ChunkPlaneKernels* kTables[] = TALUS_TABLES(kChunkPlanes);
  return *kTables[static_cast<std::size_t>(set)];
}

}  // namespace talus::terrain
#endif
