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
            lanes_of(hn::VecFromMask(d, hn::Ne(hn::And(symbols, hn::Set(d, bit)), hn::Zero(d)))));
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
      const int first = first_row_of(wave);
      const auto rows = static_cast<std::size_t>(last_row_of(wave) - first + 1);
      batch_.clear();
      for (std::size_t i = 0; i < rows; ++i) begin_row(rows_[i], first + static_cast<int>(i), wave);
      decode(0);
      for (std::size_t i = 0; i < rows; ++i) {
        if (rows_[i].coded != 0) end_even(rows_[i]);
      }
      take_escapes();
      if (faulty()) return fault();
      batch_.clear();
      for (std::size_t i = 0; i < rows; ++i) begin_odd(rows_[i]);
      decode(kOddContexts);
      for (std::size_t i = 0; i < rows; ++i) {
        if (rows_[i].coded != 0) end_odd(rows_[i]);
      }
      take_escapes();
      if (faulty()) return fault();
      for (std::size_t i = 0; i < rows; ++i) {
        const auto y = static_cast<std::size_t>(first) + i;
        const std::size_t z = static_cast<std::size_t>(wave) - 2 * y;
        const WaveRow& row = rows_[i];
        if (row.uniform) {
          equal_.set(y, z, kAllColumns, kAllColumns, kAllColumns);
          continue;
        }
        const RowVec now = load_voxels(row.voxels);
        equal_.set(y, z, equal(now, load_voxels(row.voxels - 1)), equal(now, load_voxels(row.around.north)),
                   equal(now, load_voxels(row.around.below)));
      }
    }
    return exceptions_.all_taken() ? VolumeFault::none : VolumeFault::bad_number;
  }

 private:
  HWY_INLINE void decode(std::size_t contexts) {
    source_.keep_ahead();
    batch_.decode(source_, code_.intervals->data() + contexts);
  }

  /// Gives the exceptions among the `steady` voxels of a row their materials.
  HWY_INLINE void take_exceptions(WaveRow& row, RowMask steady) {
    auto count = static_cast<std::uint32_t>(std::popcount(steady));
    while (HWY_UNLIKELY(exceptions_.gap() < count)) {
      const int x = std::countr_zero(deposit_bits(1U << exceptions_.gap(), steady));
      row.voxels[x] = exceptions_.take(source_);
      row.uniform = false;
      steady &= ~(RowMask{2} << x) + 1;
      count = static_cast<std::uint32_t>(std::popcount(steady));
    }
    exceptions_.pass(count);
  }

  HWY_INLINE void begin_row(WaveRow& row, int y, int wave) {
    const int z = wave - 2 * y;
    row.voxels = voxels_ + (y * kChunkSize + z) * kChunkSize;
    row.around = rows_around(voxels_, row_zero_.data() + kChunkSize, y, z);
    row.masks = equal_.around(static_cast<std::size_t>(y), static_cast<std::size_t>(z));
    const RowVec below = load_voxels(row.around.below);
    row.uniform = (row.masks.all() & row.masks.level) == kAllColumns;
    if (row.uniform) {
      store_voxels(below, row.voxels);
      row.same = kAllColumns;
      row.coded = 0;
      take_exceptions(row, kEvenColumns);
      return;
    }
    const RowVec north = load_voxels(row.around.north);
    row.same = equal(north, below);
    store_voxels(select(row.masks.level, north, below), row.voxels);
    const RowMask steady = kEvenColumns & row.same & row.masks.all();
    row.coded = kEvenColumns & ~steady;
    take_exceptions(row, steady);
    if (row.coded == 0) return;
    const RowMask south = equal(load_voxels(row.around.below_south), north);
    batch_.add<7>(row.coded, even_contexts(row.masks, row.same, south));
  }

  HWY_INLINE void end_even(const WaveRow& row) {
    const Batch::Symbols symbols = batch_.take(row.coded);
    if ((symbols.low | symbols.high) == 0) return;
    const RowMask second = symbols.low & ~symbols.high;
    if (second != 0) {
      const RowVec other =
          select(row.masks.level, load_voxels(row.around.below), load_voxels(row.around.north));
      const RowVec candidate = select(row.same, first_different(row.masks, row.around), other);
      store_voxels(select(second, candidate, load_voxels(row.voxels)), row.voxels);
    }
    take_rare(row, symbols);
  }

  HWY_INLINE void begin_odd(WaveRow& row) {
    if (row.uniform) {
      row.coded = 0;
      take_exceptions(row, kOddColumns);
      return;
    }
    const RowVec north = load_voxels(row.around.north);
    const RowVec below = load_voxels(row.around.below);
    const RowVec base = select(row.masks.level, north, below);
    const RowVec other = select(row.masks.level, below, north);
    const RowVec now = load_voxels(row.voxels);
    const RowVec west = load_voxels(row.voxels - 1);
    const RowVec east = load_voxels(row.voxels + 1);
    row.beside = {equal(west, east) | 1U << 31U, equal(base, west), equal(base, east), equal(other, west),
                  equal(other, east)};
    const RowMask steady = kOddColumns & row.beside.agrees() & row.masks.all();
    row.coded = kOddColumns & ~steady;
    store_voxels(select(kOddColumns, select(row.beside.is_east(), east, west), now), row.voxels);
    take_exceptions(row, steady);
    if (row.coded != 0) batch_.add<8>(row.coded, odd_contexts(row.masks, row.beside, row.same));
  }

  HWY_INLINE void end_odd(const WaveRow& row) {
    const Batch::Symbols symbols = batch_.take(row.coded);
    if ((symbols.low | symbols.high) == 0) return;
    const RowMask second = symbols.low & ~symbols.high;
    if (second != 0) {
      const RowVec north = load_voxels(row.around.north);
      const RowVec below = load_voxels(row.around.below);
      const BesideMasks& beside = row.beside;
      // Base, unless that is the west: then the other.
      const RowVec of_equal = select(row.masks.level ^ beside.base_west, north, below);
      const RowVec beyond = select(beside.is_east(), load_voxels(row.voxels - 1), load_voxels(row.voxels + 1));
      const RowVec candidate =
          select(beside.agrees(), first_different(row.masks, row.around), select(beside.equal, of_equal, beyond));
      store_voxels(select(second, candidate, load_voxels(row.voxels)), row.voxels);
    }
    take_rare(row, symbols);
  }

  /// Third candidates and escapes, voxel by voxel.
  HWY_INLINE void take_rare(const WaveRow& row, const Batch::Symbols& symbols) {
    for (RowMask left = symbols.high; left != 0; left &= left - 1) {
      const int x = std::countr_zero(left);
      if ((symbols.low >> x & 1U) != 0) {
        escaped_[escapes_++] = row.voxels + x;
        continue;
      }
      const Prediction prediction = predict(row.around, row.voxels, x);
      bad_number_ |= prediction.candidates < kCandidates;
      row.voxels[x] = prediction.candidate[std::min(kCandidates, prediction.candidates) - 1];
    }
  }

  void take_escapes() {
    for (std::size_t i = 0; i < escapes_; ++i) {
      *escaped_[i] = MaterialId{decode_slot(source_, i % kLanes, code_.materials)};
    }
    escapes_ = 0;
  }

  [[nodiscard]] bool faulty() const { return source_.next > source_.end || bad_number_; }
  [[nodiscard]] VolumeFault fault() const {
    return source_.next > source_.end ? VolumeFault::truncated : VolumeFault::bad_number;
  }

  VolumeSource& source_;
  const VolumeCode& code_;
  MaterialId* voxels_;
  ExceptionReader exceptions_;
  EqualMasks equal_;
  Batch batch_;
  std::array<WaveRow, 16> rows_;
  std::array<MaterialId*, kMaxBatch> escaped_;
  std::size_t escapes_ = 0;
  bool bad_number_ = false;
  std::array<MaterialId, 3 * kChunkSize> row_zero_;
};

VolumeFault read(VolumeSource& source, const VolumeCode& code, PaddedVoxels& padded) {
  return Reader{source, code, padded.voxels}.read();
}

#endif

}  // namespace

constexpr VolumeRead kRead = read;

}  // namespace talus::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace talus::codec {

VolumeRead volume_read(InstructionSet set) {
  static constexpr const VolumeRead* kTables[] = TALUS_TABLES(kRead);
  return *kTables[static_cast<std::size_t>(set)];
}

}  // namespace talus::codec
#endif
