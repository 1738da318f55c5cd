// Converts materials to one-byte numbers and back: a volume has at most 256 of them.
// Included once per instruction set, hence this guard:
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
#include "volume_vbmi.h"

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
    tables_ = (count + kTable - 1) / kTable;
#if HWY_TARGET != HWY_AVX3
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
          _mm256_permute4x64_epi64(number.raw, 0xD8);  // packed results are interleaved by lanes of 128 bits
#endif
      auto low = hn::Zero(d);
      auto high = hn::Zero(d);
      for (std::size_t t = 0; t < tables_; ++t) {
        // For numbers of other tables the highest bit is set, which finds 0.
        const auto beyond = hn::SaturatedAdd(
            hn::Sub(number, hn::Set(d, static_cast<std::uint8_t>(t * kTable))), hn::Set(d, 0x70));
        const auto index = hn::And(beyond, hn::Set(d, 0x8F));
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
  static constexpr std::size_t kMaxTables = 4;  // with more, single voxels are faster
  alignas(16) std::array<std::uint8_t, kProbabilityTotal> low_{};
  alignas(16) std::array<std::uint8_t, kProbabilityTotal> high_{};
#endif
};

using Ids = hn::CappedTag<std::uint16_t, kChunkSize>;

/// True if all ids have the same high byte: then their low bytes distinguish them.
HWY_INLINE bool have_one_high_byte(const std::uint16_t* ids) {
  const Ids d;
  const auto first = hn::Set(d, ids[0]);
  auto differ = hn::Zero(d);
  for (std::size_t i = 0; i < kChunkVolume; i += hn::MaxLanes(d))
    differ = hn::Or(differ, hn::Xor(hn::LoadU(d, ids + i), first));
  return hn::AllTrue(d, hn::Eq(hn::ShiftRight<8>(differ), hn::Zero(d)));
}

/// Numbers the materials of voxels `begin` to `end` - 1. Looks up only voxels that differ from all the voxels
/// `before` positions earlier. Returns false if there are too many materials.
template <std::size_t count>
HWY_INLINE bool find_materials(const std::uint16_t* ids, std::size_t begin, std::size_t end,
                               const std::array<std::size_t, count>& before, MaterialCode& materials) {
  const Ids d;
  for (std::size_t i = begin; i < end; i += hn::MaxLanes(d)) {
    const auto id = hn::LoadU(d, ids + i);
    auto known = hn::Eq(id, hn::LoadU(d, ids + i - before[0]));
    for (std::size_t b = 1; b < count; ++b)
      known = hn::Or(known, hn::Eq(id, hn::LoadU(d, ids + i - before[b])));
    if (HWY_LIKELY(hn::AllTrue(d, known))) continue;
    std::uint64_t unknown = 0;
    hn::StoreMaskBits(d, hn::Not(known), reinterpret_cast<std::uint8_t*>(&unknown));
    if constexpr (hn::MaxLanes(Ids{}) < 32) unknown &= (std::uint64_t{1} << hn::MaxLanes(d)) - 1;
    for (; unknown != 0; unknown &= unknown - 1) {
      const MaterialId material{ids[i + static_cast<std::size_t>(std::countr_zero(unknown))]};
      if (materials.number_of(material) == MaterialCode::kMaxMaterials) return false;
    }
  }
  return true;
}

/// One-byte number of a material; distinct for all materials if `factor` is from factor_of().
constexpr std::uint16_t byte_of(std::uint16_t id, std::uint16_t factor) {
  return static_cast<std::uint16_t>((id + (id >> 8U) * factor) & 0xFFU);
}

/// Finds a factor that makes byte_of() distinct; kNoFactor if none was found.
inline constexpr std::uint16_t kNoFactor = 64;
inline std::uint16_t factor_of(const MaterialCode& materials) {
  for (std::uint16_t factor = 0; factor < kNoFactor; ++factor) {
    std::array<bool, 256> taken{};
    bool differ = true;
    for (std::size_t i = 0; i < materials.size() && differ; ++i) {
      bool& is_taken = taken[byte_of(to_integer(materials.material(i)), factor)];
      differ = !is_taken;
      is_taken = true;
    }
    if (differ) return factor;
  }
  return kNoFactor;
}

/// Numbers all voxels by byte_of().
HWY_INLINE void number_by_factor(const std::uint16_t* ids, std::uint16_t factor, VoxelRows& rows) {
  const Ids d;
  const auto times = hn::Set(d, factor);
  const auto number = [&](const std::uint16_t* from) HWY_ATTR {
    const auto id = hn::LoadU(d, from);
    return hn::Add(id, hn::Mul(hn::ShiftRight<8>(id), times));
  };
  for (std::size_t row = 0; row < kChunkArea; ++row, ids += kRowBytes) {
    std::uint8_t* const to = rows.row(row);
#if HWY_TARGET == HWY_AVX3
    const hn::Rebind<std::uint8_t, Ids> bytes;
    hn::StoreU(hn::TruncateTo(bytes, number(ids)), bytes, to);
#else
    const hn::Repartition<std::uint8_t, Ids> bytes;
    for (std::size_t x = 0; x < kRowBytes; x += hn::MaxLanes(bytes)) {
      const auto low = hn::BitCast(bytes, number(ids + x));
      const auto high = hn::BitCast(bytes, number(ids + x + hn::MaxLanes(d)));
      hn::StoreU(hn::ConcatEven(bytes, high, low), bytes, to + x);
    }
#endif
  }
}

/// Finds the materials of all voxels. Returns false if there are too many.
inline bool find_materials(const DenseVoxels& voxels, MaterialCode& materials) {
  const auto* const ids = reinterpret_cast<const std::uint16_t*>(voxels.data());
  for (std::size_t i = 1; i < kChunkSize; ++i) {
    if (ids[i] != ids[i - 1]) (void)materials.number_of(voxels[i]);
  }
  constexpr std::size_t kRow = kChunkSize;
  constexpr std::size_t kPlane = kChunkArea;
  return find_materials<2>(ids, kRow, kPlane + kRow, {1, kRow}, materials) &&
         find_materials<4>(ids, kPlane + kRow, kChunkVolume, {1, kRow, kPlane, kRow - 1}, materials);
}

/// Gives distinct materials distinct one-byte numbers. Returns false if there are more than 256.
inline bool number_voxels(const DenseVoxels& voxels, const VolumeVbmi* vbmi, VoxelRows& rows) {
  const auto* const ids = reinterpret_cast<const std::uint16_t*>(voxels.data());
  MaterialCode materials{voxels.front()};
  if (HWY_TARGET == HWY_AVX3 && vbmi != nullptr) {
    const Numbering numbering = vbmi->number(ids, rows, materials);
    if (numbering != Numbering::two_alike) return numbering == Numbering::done;
  } else if (have_one_high_byte(ids)) {
    number_by_factor(ids, 0, rows);
    return true;
  } else if (!find_materials(voxels, materials)) {
    return false;
  }
  const std::uint16_t factor = factor_of(materials);
  if (factor != kNoFactor) {
    number_by_factor(ids, factor, rows);
    return true;
  }
  std::uint8_t number = 0;
  for (std::size_t i = 0; i < kChunkVolume; ++i) {
    if (i == 0 || ids[i] != ids[i - 1]) number = static_cast<std::uint8_t>(materials.number_of(voxels[i]));
    rows.row(i / kRowBytes)[i % kRowBytes] = number;
  }
  return true;
}

}  // namespace
}  // namespace talus::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#endif
