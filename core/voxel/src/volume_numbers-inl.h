// Materials as numbers of one byte, and back: a volume has 256 of them at most.
// Included once for each instruction set, hence no include guard but this:
#if defined(TALUS_VOLUME_NUMBERS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TALUS_VOLUME_NUMBERS_INL
#undef TALUS_VOLUME_NUMBERS_INL
#else
#define TALUS_VOLUME_NUMBERS_INL
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>
#include <talus/voxel/chunk.h>

#include "material_code.h"
#include "volume_parts-inl.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace talus::HWY_NAMESPACE {
namespace {

/// Writes rows of numbers as rows of materials.
class RowWriter {
 public:
  explicit RowWriter(const SlotTable& materials) : materials_{materials.value} {
    std::size_t count = 1;
    for (const std::uint32_t slot : materials.slot) count = std::max(count, std::size_t{slot & 0xFFU} + 1);
#if HWY_TARGET == HWY_AVX3
    tables_ = (count + kTable - 1) / kTable;
#else
    tables_ = (count + kTable - 1) / kTable;
    for (std::size_t i = 0; i < count; ++i) {
      low_[i] = static_cast<std::uint8_t>(materials_[i]);
      high_[i] = static_cast<std::uint8_t>(materials_[i] >> 8U);
    }
#endif
  }

  HWY_INLINE void write(const std::uint8_t* numbers, MaterialId* to) const {
#if HWY_TARGET == HWY_AVX3
    const __m256i bytes = _mm256_load_si256(reinterpret_cast<const __m256i*>(numbers));
    const __m512i number = _mm512_cvtepu8_epi16(bytes);
    const std::uint16_t* table = materials_.data();
    __m512i found =
        _mm512_permutex2var_epi16(_mm512_loadu_si512(table), number, _mm512_loadu_si512(table + 32));
    for (std::size_t t = 1; t < tables_; ++t) {
      table += kTable;
      const __mmask32 here =
          _mm512_cmpge_epu16_mask(number, _mm512_set1_epi16(static_cast<short>(t * kTable)));
      found = _mm512_mask_mov_epi16(
          found, here,
          _mm512_permutex2var_epi16(_mm512_loadu_si512(table), number, _mm512_loadu_si512(table + 32)));
    }
    _mm512_storeu_si512(to, found);
#else
    if (tables_ > kMaxTables) {
      for (std::size_t x = 0; x < kChunkSize; ++x) to[x] = MaterialId{materials_[numbers[x]]};
      return;
    }
    const Numbers d;
    const hn::Repartition<std::uint16_t, Numbers> words;
    auto* out = reinterpret_cast<std::uint16_t*>(to);
    for (std::size_t x = 0; x < kChunkSize; x += hn::MaxLanes(d)) {
      auto number = hn::LoadU(d, numbers + x);
#if HWY_TARGET == HWY_AVX2
      number.raw =
          _mm256_permute4x64_epi64(number.raw, 0xD8);  // what is put together lies in lanes of 128 bits
#endif
      auto low = hn::Zero(d);
      auto high = hn::Zero(d);
      for (std::size_t t = 0; t < tables_; ++t) {
        // Of other tables' numbers the highest bit is set, which finds 0.
        const auto index = hn::SaturatedAdd(
            hn::Sub(number, hn::Set(d, static_cast<std::uint8_t>(t * kTable))), hn::Set(d, 0x70));
        low = hn::Or(low, hn::TableLookupBytesOr0(hn::LoadDup128(d, low_.data() + t * kTable), index));
        high = hn::Or(high, hn::TableLookupBytesOr0(hn::LoadDup128(d, high_.data() + t * kTable), index));
      }
      hn::StoreU(hn::BitCast(words, hn::InterleaveLower(d, low, high)), words, out);
      hn::StoreU(hn::BitCast(words, hn::InterleaveUpper(d, low, high)), words, out + hn::MaxLanes(words));
      out += hn::MaxLanes(d);
    }
#endif
  }

 private:
  const std::array<std::uint16_t, kProbabilityTotal>& materials_;
  std::size_t tables_ = 0;
#if HWY_TARGET == HWY_AVX3
  static constexpr std::size_t kTable = 64;
#else
  using Numbers = hn::CappedTag<std::uint8_t, kRowBytes>;
  static constexpr std::size_t kTable = 16;
  static constexpr std::size_t kMaxTables = 4;  // more take longer than single voxels
  alignas(16) std::array<std::uint8_t, kProbabilityTotal> low_{};
  alignas(16) std::array<std::uint8_t, kProbabilityTotal> high_{};
#endif
};

using Ids = hn::ScalableTag<std::uint16_t>;

/// Where all ids have the same high byte: their low bytes. What that is not equal has one bit of ones.
HWY_INLINE bool have_one_high_byte(const std::uint16_t* ids) {
  const Ids d;
  const auto first = hn::Set(d, ids[0]);
  auto differ = hn::Zero(d);
  for (std::size_t i = 0; i < kChunkVolume; i += hn::MaxLanes(d))
    differ = hn::Or(differ, hn::Xor(hn::LoadU(d, ids + i), first));
  return hn::AllTrue(d, hn::Eq(hn::ShiftRight<8>(differ), hn::Zero(d)));
}

HWY_INLINE void take_low_bytes(const std::uint16_t* ids, std::uint8_t* numbers) {
  const Ids d;
  const hn::Repartition<std::uint8_t, Ids> bytes;
  for (std::size_t i = 0; i < kChunkVolume; i += hn::MaxLanes(bytes)) {
    const auto low = hn::BitCast(bytes, hn::LoadU(d, ids + i));
    const auto high = hn::BitCast(bytes, hn::LoadU(d, ids + i + hn::MaxLanes(d)));
    hn::StoreU(hn::ConcatEven(bytes, high, low), bytes, numbers + i);
  }
}

/// Numbers materials in the order in which they come.
class Numberer {
 public:
  explicit Numberer(MaterialId first) : materials_{first} { known_[0] = to_integer(first); }

  /// False where there are too many.
  HWY_INLINE bool number_row(const std::uint16_t* ids, std::uint8_t* numbers) {
    const Ids d;
    using Narrow = hn::Rebind<std::uint8_t, Ids>;
    bool all = true;
    for (std::size_t x = 0; x < kChunkSize; x += hn::MaxLanes(d)) {
      const auto id = hn::LoadU(d, ids + x);
      auto found = hn::Eq(id, hn::Set(d, known_[0]));
      auto number = hn::Zero(d);
      const std::size_t count = std::min(materials_.size(), kKnown);
      for (std::size_t i = 1; i < count && !hn::AllTrue(d, found); ++i) {
        const auto here = hn::Eq(id, hn::Set(d, known_[i]));
        number = hn::Or(number, hn::IfThenElseZero(here, hn::Set(d, static_cast<std::uint16_t>(i))));
        found = hn::Or(found, here);
      }
      all = all && hn::AllTrue(d, found);
      hn::StoreU(hn::TruncateTo(Narrow{}, number), Narrow{}, numbers + x);
    }
    return all || number_voxels(ids, numbers);
  }

 private:
  static constexpr std::size_t kKnown = 16;

  bool number_voxels(const std::uint16_t* ids, std::uint8_t* numbers) {
    for (std::size_t x = 0; x < kChunkSize; ++x) {
      const std::uint32_t number = materials_.number_of(MaterialId{ids[x]});
      if (number == MaterialCode::kMaxMaterials) return false;
      if (number < kKnown) known_[number] = ids[x];
      numbers[x] = static_cast<std::uint8_t>(number);
    }
    return true;
  }

  MaterialCode materials_;
  std::array<std::uint16_t, kKnown> known_{};
};

/// Numbers of a byte that differ where materials do. False where there are more than 256.
inline bool number_voxels(const DenseVoxels& voxels, std::uint8_t* numbers) {
  const auto* const ids = reinterpret_cast<const std::uint16_t*>(voxels.data());
  if (have_one_high_byte(ids)) {
    take_low_bytes(ids, numbers);
    return true;
  }
  Numberer numberer{voxels.front()};
  for (std::size_t i = 0; i < kChunkVolume; i += kChunkSize) {
    if (!numberer.number_row(ids + i, numbers + i)) return false;
  }
  return true;
}

}  // namespace
}  // namespace talus::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#endif
