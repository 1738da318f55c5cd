#include "volume_kernels.h"

#include <algorithm>

#include "volume_read.h"
#include "volume_scalar.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "volume_read.cpp"
#include <talus/vectors/tables.h>

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "volume-inl.h"

HWY_BEFORE_NAMESPACE();
namespace talus::HWY_NAMESPACE {
namespace {

using namespace codec;

#if HWY_TARGET == HWY_SCALAR

VolumeFault read(VolumeSource& source, const VolumeCode& code, PaddedVoxels& padded) {
  return read_volume_scalar(source, code, padded);
}

void read_slots(VolumeSource& source, const SlotTable& slots, std::size_t count, std::uint8_t* kinds) {
  read_slots_scalar(source, slots, count, kinds);
}

#else

/// The contexts of a batch, and then its symbols as two strings of bits.
class Batch {
 public:
  void clear() { size_ = 0; }

  template <std::size_t count>
  HWY_INLINE void add(RowMask coded, const ContextBits& bits) {
    put_numbers<count>(coded, bits, contexts_.data() + size_);
    size_ += static_cast<std::size_t>(std::popcount(coded));
  }

  HWY_INLINE void decode(VolumeSource& source, const std::uint32_t* intervals) {
    next_ = 0;
    if (size_ == 0) return;
    const std::uint8_t* next = source.next;
    WordParts states = load_words(source.states.data());
    const Half d;
    for (std::size_t i = 0; i < size_; i += kLanes) {
      const HalfVec symbols = decode_symbols(states, starts(i, intervals), next);
      const auto bits = [&](std::uint8_t bit) HWY_ATTR {
        return static_cast<std::uint16_t>(
            lanes_of(hn::Eq(hn::And(symbols, hn::Set(d, bit)), hn::Set(d, bit))));
      };
      low_[i / kLanes] = bits(1);
      high_[i / kLanes] = bits(2);
    }
    store_words(states, source.states.data());
    source.next = next;
  }

  struct Symbols {
    RowMask low;
    RowMask high;
  };
  /// Of the next row, in the order in which rows were added.
  HWY_INLINE Symbols take(RowMask coded) {
    const Symbols symbols{deposit_bits(bits_at(low_), coded), deposit_bits(bits_at(high_), coded)};
    next_ += static_cast<std::size_t>(std::popcount(coded));
    return symbols;
  }

 private:
  using BitString = std::array<std::uint16_t, kMaxBatch / kLanes + 2>;

  [[nodiscard]] HWY_INLINE std::uint32_t bits_at(const BitString& string) const {
    std::uint32_t bits;
    std::memcpy(&bits, reinterpret_cast<const std::uint8_t*>(string.data()) + next_ / 8, sizeof bits);
    return bits >> next_ % 8;
  }

  [[nodiscard]] HWY_INLINE StartParts starts(std::size_t first, const std::uint32_t* intervals) const {
    const Words d;
    const auto low_byte = hn::Set(d, 0xFF);
    const std::uint32_t active = size_ - first < kLanes ? (1U << (size_ - first)) - 1 : 0xFFFF;
    StartParts starts;
#if HWY_TARGET == HWY_AVX3
    const __m512i contexts = _mm512_cvtepu8_epi32(hn::LoadU(Half{}, contexts_.data() + first).raw);
    const __m512i ends = _mm512_mask_i32gather_epi32(_mm512_setzero_si512(), static_cast<__mmask16>(active),
                                                     contexts, intervals, 4);
    const WordVec one_two{_mm512_cvtepi32_epi16(ends)};
    starts.one.part[0] = hn::And(one_two, low_byte);
    starts.two.part[0] = hn::ShiftRight<8>(one_two);
    starts.three.part[0] = WordVec{_mm512_cvtepi32_epi16(_mm512_srli_epi32(ends, 16))};
#else
    alignas(32) std::array<std::uint32_t, kLanes> ends;
    for (std::size_t i = 0; i < kLanes; ++i) {
      ends[i] = (active >> i & 1U) != 0 ? intervals[contexts_[first + i]] : 0;
    }
    const auto* const words = reinterpret_cast<const std::uint16_t*>(ends.data());
    for (std::size_t p = 0; p < kParts; ++p) {
      const auto low = hn::LoadU(d, words + 2 * p * hn::MaxLanes(d));
      const auto high = hn::LoadU(d, words + (2 * p + 1) * hn::MaxLanes(d));
      const auto one_two = hn::ConcatEven(d, high, low);
      starts.one.part[p] = hn::And(one_two, low_byte);
      starts.two.part[p] = hn::ShiftRight<8>(one_two);
      starts.three.part[p] = hn::ConcatOdd(d, high, low);
    }
#endif
    return starts;
  }

  std::array<std::uint8_t, kMaxBatch + 16> contexts_;
  BitString low_;
  BitString high_;
  std::size_t size_ = 0;
  std::size_t next_ = 0;
};

/// A row of the wave that is being read.
struct WaveRow {
  MaterialId* voxels;
  RowsAround around;
  AroundMasks masks;
  BesideMasks beside;
  RowMask same;
  RowMask coded;
  std::size_t y;
  std::size_t z;
  bool uniform;  // it and all around it are of one material
};

class Reader {
 public:
  Reader(VolumeSource& source, const VolumeCode& code, DenseVoxels& voxels)
      : source_{source}, code_{code}, voxels_{voxels.data()}, exceptions_{code, source} {
    row_zero_.fill(code.first);
  }

  VolumeFault read() {
    for (int wave = 0; wave < kWaves; ++wave) {
      rows_ = 0;
      batch_.clear();
      for (int y = first_row_of(wave); y <= last_row_of(wave); ++y) begin_row(y, wave - 2 * y);
      if (!finish_batch<0>()) return fault();
      batch_.clear();
      for (std::size_t i = 0; i < rows_; ++i) begin_odd(row_[i]);
      if (!finish_batch<kOddContexts>()) return fault();
      for (std::size_t i = 0; i < rows_; ++i) {
        const WaveRow& row = row_[i];
        if (row.uniform) continue;
        const RowVec now = load_voxels(row.voxels);
        equal_.set(row.y, row.z, equal(now, west_of(now, row.voxels)),
                   equal(now, load_voxels(row.around.north)), equal(now, load_voxels(row.around.below)));
      }
    }
    return exceptions_.all_taken() ? VolumeFault::none : VolumeFault::bad_number;
  }

 private:
  /// Gives the exceptions among the `steady` voxels of a row their materials.
  HWY_INLINE void take_exceptions(MaterialId* row, RowMask steady) {
    auto count = static_cast<std::uint32_t>(std::popcount(steady));
    while (HWY_UNLIKELY(exceptions_.gap() < count)) {
      const int x = std::countr_zero(deposit_bits(1U << exceptions_.gap(), steady));
      row[x] = exceptions_.take(source_);
      steady &= ~(RowMask{2} << x) + 1;
      count = static_cast<std::uint32_t>(std::popcount(steady));
    }
    exceptions_.pass(count);
  }

  HWY_INLINE void begin_row(int y, int z) {
    WaveRow& row = row_[rows_];
    row.masks = equal_.around(static_cast<std::size_t>(y), static_cast<std::size_t>(z));
    row.voxels = voxels_ + (y * kChunkSize + z) * kChunkSize;
    row.y = static_cast<std::size_t>(y);
    row.z = static_cast<std::size_t>(z);
    row.around = rows_around(voxels_, row_zero_.data() + kChunkSize, y, z);
    const RowVec below = load_voxels(row.around.below);
    if ((row.masks.all() & row.masks.level) == kAllColumns) {
      // All around is of one material. The masks of such a row are what they were set to at first.
      store_voxels(below, row.voxels);
      row.coded = 0;
      row.uniform = exceptions_.gap() >= kLanes;
      row.same = kAllColumns;
      take_exceptions(row.voxels, kEvenColumns);
      ++rows_;
      return;
    }
    const RowVec north = load_voxels(row.around.north);
    row.uniform = false;
    row.same = equal(north, below);
    store_voxels(select(row.masks.level, north, below), row.voxels);
    const RowMask steady = kEvenColumns & row.same & row.masks.all();
    row.coded = kEvenColumns & ~steady;
    take_exceptions(row.voxels, steady);
    ++rows_;
    if (row.coded == 0) return;
    const RowMask south = equal(load_voxels(row.around.below_south), north);
    batch_.add<7>(row.coded, even_contexts(row.masks, row.same, south));
  }

  HWY_INLINE void begin_odd(WaveRow& row) {
    if (row.uniform) {
      row.uniform = exceptions_.gap() >= kLanes;
      row.coded = 0;
      take_exceptions(row.voxels, kOddColumns);
      return;
    }
    const RowVec north = load_voxels(row.around.north);
    const RowVec below = load_voxels(row.around.below);
    const RowVec base = select(row.masks.level, north, below);
    const RowVec other = select(row.masks.level, below, north);
    const RowVec now = load_voxels(row.voxels);
    const RowVec west = west_of(now, row.voxels);
    const RowVec east = east_of(now, row.voxels);
    row.beside = {equal(west, east) | 1U << 31U, equal(base, west), equal(base, east), equal(other, west),
                  equal(other, east)};
    const RowMask steady = kOddColumns & row.beside.agrees() & row.masks.all();
    row.coded = kOddColumns & ~steady;
    store_voxels(select(kOddColumns, select(row.beside.is_east(), east, west), now), row.voxels);
    take_exceptions(row.voxels, steady);
    if (row.coded != 0) batch_.add<8>(row.coded, odd_contexts(row.masks, row.beside, row.same));
  }

  /// Reads the symbols of a batch and gives its voxels their materials.
  template <std::size_t first_context>
  HWY_INLINE bool finish_batch() {
    source_.keep_ahead();
    batch_.decode(source_, code_.intervals->data() + first_context);
    for (std::size_t i = 0; i < rows_; ++i) {
      if (row_[i].coded != 0) finish_row<first_context != 0>(row_[i]);
    }
    for (std::size_t i = 0; i < escapes_; ++i) {
      *escaped_[i] = MaterialId{decode_slot(source_, i % kLanes, code_.materials)};
    }
    escapes_ = 0;
    return source_.next <= source_.end && !bad_number_;
  }

  template <bool odd>
  HWY_INLINE void finish_row(const WaveRow& row) {
    const Batch::Symbols symbols = batch_.take(row.coded);
    if ((symbols.low | symbols.high) == 0) return;
    const RowVec north = load_voxels(row.around.north);
    const RowVec below = load_voxels(row.around.below);
    const RowVec now = load_voxels(row.voxels);  // the first candidates
    RowVec second;
    if constexpr (odd) {
      const BesideMasks& beside = row.beside;
      // Base, unless that is the west: then the other.
      const RowVec of_equal = select(row.masks.level ^ beside.base_west, north, below);
      const RowVec beyond = select(beside.is_east(), west_of(now, row.voxels), east_of(now, row.voxels));
      second = select(beside.agrees(), first_different(row.masks, row.around),
                      select(beside.equal, of_equal, beyond));
    } else {
      second =
          select(row.same, first_different(row.masks, row.around), select(row.masks.level, below, north));
    }
    RowVec found = select(symbols.low & ~symbols.high, second, now);
    const RowMask is_third = symbols.high & ~symbols.low;
    if (is_third != 0) {
      RowMask exists = 0;
      const RowVec third = third_candidate(now, second, row.masks, row.around, exists);
      found = select(is_third, third, found);
      bad_number_ |= (is_third & ~exists) != 0;
    }
    store_voxels(found, row.voxels);
    for (RowMask left = symbols.high & symbols.low; left != 0; left &= left - 1) {
      escaped_[escapes_++] = row.voxels + std::countr_zero(left);
    }
  }

  [[nodiscard]] VolumeFault fault() const {
    return source_.next > source_.end ? VolumeFault::truncated : VolumeFault::bad_number;
  }

  VolumeSource& source_;
  const VolumeCode& code_;
  MaterialId* voxels_;
  ExceptionReader exceptions_;
  EqualMasks equal_;
  Batch batch_;
  std::array<WaveRow, 16> row_;
  std::size_t rows_ = 0;
  std::array<MaterialId*, kMaxBatch> escaped_;
  std::size_t escapes_ = 0;
  bool bad_number_ = false;
  std::array<MaterialId, 3 * kChunkSize> row_zero_;
};

void read_slots(VolumeSource& source, const SlotTable& slots, std::size_t count, std::uint8_t* kinds) {
  const Words d;
  const std::uint8_t* next = source.next;
  WordParts states = load_words(source.states.data());
  std::size_t i = 0;
  for (; i + kLanes <= count; i += kLanes) {
    alignas(64) std::array<std::uint32_t, kLanes> found;
#if HWY_TARGET == HWY_AVX3
    const __m512i low = _mm512_cvtepu16_epi32(hn::And(states.part[0], hn::Set(d, 0xFF)).raw);
    _mm512_store_si512(found.data(), _mm512_i32gather_epi32(low, slots.slot.data(), 4));
#else
    alignas(32) std::array<std::uint16_t, kLanes> now;
    store_words(states, now.data());
    for (std::size_t lane = 0; lane < kLanes; ++lane) found[lane] = slots.slot[now[lane] & 0xFFU];
#endif
    const auto* const words = reinterpret_cast<const std::uint16_t*>(found.data());
    WordParts kind;
    for (std::size_t p = 0; p < kParts; ++p) {
      const auto a = hn::LoadU(d, words + 2 * p * hn::MaxLanes(d));
      const auto b = hn::LoadU(d, words + (2 * p + 1) * hn::MaxLanes(d));
      const auto kind_start = hn::ConcatEven(d, b, a);
      const auto size = hn::ConcatOdd(d, b, a);
      const auto state = states.part[p];
      const auto slot = hn::And(state, hn::Set(d, 0xFF));
      kind.part[p] = hn::And(kind_start, hn::Set(d, 0xFF));
      states.part[p] =
          hn::Add(hn::Mul(size, hn::ShiftRight<8>(state)), hn::Sub(slot, hn::ShiftRight<8>(kind_start)));
    }
    refill(states, next);
    hn::StoreU(narrow(kind), Half{}, kinds + i);
  }
  store_words(states, source.states.data());
  source.next = next;
  if (i < count) read_slots_scalar(source, slots, count - i, kinds + i);
}

VolumeFault read(VolumeSource& source, const VolumeCode& code, PaddedVoxels& padded) {
  return Reader{source, code, padded.voxels}.read();
}

#endif

}  // namespace

constexpr VolumeRead kRead{read, read_slots};

}  // namespace talus::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace talus::codec {

const VolumeRead& volume_read(InstructionSet set) {
  static constexpr const VolumeRead* kTables[] = TALUS_TABLES(kRead);
  return *kTables[static_cast<std::size_t>(set)];
}

}  // namespace talus::codec
#endif
