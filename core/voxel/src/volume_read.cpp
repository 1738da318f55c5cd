#include "volume_kernels.h"

#include <algorithm>

#include "volume_read.h"
#include "volume_scalar.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "volume_read.cpp"
#include <talus/vectors/tables.h>

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "volume_candidates-inl.h"

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
  template <std::size_t bits>
  HWY_INLINE void begin(const BatchMasks& masks, const VolumePack* pack) {
    size_ = masks.coded_rows == 0 ? 0 : masks.put_contexts<bits>(pack, contexts_.data());
  }

  HWY_INLINE void decode(VolumeSource& source, const std::uint32_t* intervals) {
    next_ = 0;
    if (size_ == 0) return;
    const std::uint8_t* next = source.next;
    WordParts states = load_words(source.states.data());
    const Half d;
    std::uint64_t low = 0;
    std::uint64_t high = 0;
    for (std::size_t i = 0; i < size_; i += kLanes) {
      const HalfVec symbols = decode_symbols(states, starts(i, intervals), next);
      const auto bits = [&](std::uint8_t bit) HWY_ATTR {
        return static_cast<std::uint16_t>(
            lanes_of(hn::Eq(hn::And(symbols, hn::Set(d, bit)), hn::Set(d, bit))));
      };
      // Put together in registers: what is taken later lies across several of these.
      const std::size_t shift = i % 64;
      low |= std::uint64_t{bits(1)} << shift;
      high |= std::uint64_t{bits(2)} << shift;
      low_[i / 64] = low;
      high_[i / 64] = high;
      if (shift == 48) low = high = 0;
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
  using BitString = std::array<std::uint64_t, kMaxBatch / 64 + 1>;

  [[nodiscard]] HWY_INLINE std::uint32_t bits_at(const BitString& string) const {
    const std::size_t word = next_ / 64;
    const std::size_t shift = next_ % 64;
    return static_cast<std::uint32_t>(string[word] >> shift | (string[word + 1] << 1U) << (63 - shift));
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
    alignas(32) std::array<std::uint32_t, kLanes> ends{};
    if (active == 0xFFFF) {
      for (std::size_t i = 0; i < kLanes; ++i) ends[i] = intervals[contexts_[first + i]];
    } else {
      for (std::size_t i = 0; i < size_ - first; ++i) ends[i] = intervals[contexts_[first + i]];
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

  std::array<std::uint8_t, kMaxBatch + 32> contexts_;
  BitString low_;
  BitString high_;
  std::size_t size_ = 0;
  std::size_t next_ = 0;
};

class Reader {
 public:
  Reader(VolumeSource& source, const VolumeCode& code, DenseVoxels& voxels)
      : source_{source}, code_{code}, voxels_{voxels.data()}, exceptions_{code, source} {
    row_zero_.fill(code.first);
  }

  VolumeFault read() {
    for (int wave = 0; wave < kWaves; ++wave) {
      rows_ = static_cast<std::size_t>(last_row_of(wave) - first_row_of(wave) + 1);
      const AroundMasks<MaskVec> around = equal_.around(wave);
      around_.store(around);
      const MaskVec in_wave = mask_of_rows(rows_);
      mixed_ = rows_with_any(in_wave & ~(around.all() & around.level));
      if (mixed_ == 0 && exceptions_.gap() >= rows_ * kChunkSize) {
        repeat_rows(wave);
        continue;
      }
      begin_even(wave);
      const MaskVec same = same_.get();
      store_masks(same, same_rows_.data());
      masks_.store<7>(in_wave & set_masks(kEvenColumns), same & around.all(),
                      even_contexts(around, same, south_.get()));
      if (!read_batch<false>()) return fault();

      begin_odd();
      const BesideMasks<MaskVec> beside = beside_.get();
      beside_rows_.store(beside);
      masks_.store<8>(in_wave & set_masks(kOddColumns), beside.agrees() & around.all(),
                      odd_contexts(around, beside, same));
      if (!read_batch<true>()) return fault();
      end_wave(wave);
    }
    return exceptions_.all_taken() ? VolumeFault::none : VolumeFault::bad_number;
  }

 private:
  /// All rows are of one material with all around them, and no voxel is an exception.
  HWY_INLINE void repeat_rows(int wave) {
    exceptions_.pass(static_cast<std::uint32_t>(rows_ * kChunkSize));
    const int first = first_row_of(wave);
    MaterialId* to = voxels_ + (first * kChunkSize + wave - 2 * first) * kChunkSize;
    const MaterialId* from =
        rows_around(voxels_, row_zero_.data() + kChunkSize, first, wave - 2 * first).below;
    for (std::size_t i = 0; i < rows_; ++i) {
      store_voxels(load_voxels(from), to);
      to += kRowToRow;
      from = to - kChunkArea;
    }
    equal_.begin(wave);
  }

  /// The even columns get their first candidates, and all columns of rows that are not mixed.
  HWY_INLINE void begin_even(int wave) {
    same_.clear();
    south_.clear();
    place_rows(voxels_, row_zero_.data() + kChunkSize, wave, row_);
    for (std::size_t i = 0; i < rows_; ++i) store_voxels(load_voxels(row_[i].around.below), row_[i].voxels);
    over_bits(mixed_, [this](std::size_t i) HWY_ATTR {
      const WaveRow<MaterialId>& row = row_[i];
      const RowVec north = load_voxels(row.around.north);
      const RowVec below = load_voxels(row.around.below);
      same_.set(i, equal(north, below));
      south_.set(i, equal(load_voxels(row.around.below_south), north));
      store_voxels(select(around_.of.level[i], north, below), row.voxels);
    });
  }

  /// The odd columns get their first candidates.
  HWY_INLINE void begin_odd() {
    beside_.clear();
    over_bits(mixed_, [this](std::size_t i) HWY_ATTR {
      const WaveRow<MaterialId>& row = row_[i];
      const RowVec north = load_voxels(row.around.north);
      const RowVec below = load_voxels(row.around.below);
      const RowVec now = load_voxels(row.voxels);
      const RowVec west = west_of(now, row.voxels);
      const RowVec east = east_of(now, row.voxels);
      const RowMask level = around_.of.level[i];
      const RowMask is_east =
          beside_.set(i, select(level, north, below), select(level, below, north), west, east);
      store_voxels(select(kOddColumns, select(is_east, east, west), now), row.voxels);
    });
  }

  HWY_INLINE void end_wave(int wave) {
    equal_.begin(wave);
    const int first = first_row_of(wave);
    over_bits(mixed_, [this, first, wave](std::size_t i) HWY_ATTR {
      const WaveRow<MaterialId>& row = row_[i];
      const RowVec now = load_voxels(row.voxels);
      const int y = first + static_cast<int>(i);
      equal_.set(y, wave - 2 * y, equal(now, west_of(now, row.voxels)),
                 equal(now, load_voxels(row.around.north)), equal(now, load_voxels(row.around.below)));
    });
  }

  /// Gives the exceptions among the steady voxels their materials.
  HWY_INLINE void take_exceptions() {
    const std::uint32_t all = masks_.steady_voxels();
    if (HWY_LIKELY(exceptions_.gap() >= all)) {
      exceptions_.pass(all);
      return;
    }
    // In a register: the voxels that are written in between might be anything.
    std::uint32_t gap = exceptions_.gap();
    for (std::size_t i = 0; i < rows_; ++i) {
      RowMask steady = masks_.steady[i];
      auto count = static_cast<std::uint32_t>(std::popcount(steady));
      while (gap < count) {
        const int x = std::countr_zero(deposit_bits(1U << gap, steady));
        row_[i].voxels[x] = exceptions_.take(source_);
        gap = exceptions_.gap();
        mixed_ |= 1U << i;
        steady &= ~(RowMask{2} << x) + 1;
        count = static_cast<std::uint32_t>(std::popcount(steady));
      }
      gap -= count;
    }
    exceptions_.pass(exceptions_.gap() - gap);
  }

  /// Reads the symbols of a batch and gives its voxels their materials. False where there is a fault.
  template <bool odd>
  HWY_INLINE bool read_batch() {
    take_exceptions();
    batch_.template begin<odd ? 8 : 7>(masks_, pack_);
    source_.keep_ahead();
    batch_.decode(source_, code_.intervals->data() + (odd ? kOddContexts : 0));
    // Which rows have other symbols than 0 cannot be foreseen: they are found first, without a branch for
    // each.
    std::uint32_t surprising = 0;
    over_bits(masks_.coded_rows, [this, &surprising](std::size_t i) HWY_ATTR {
      symbols_[i] = batch_.take(masks_.coded[i]);
      surprising |= ((symbols_[i].low | symbols_[i].high) != 0 ? 1U : 0U) << i;
    });
    over_bits(surprising, [this](std::size_t i) HWY_ATTR { finish_row<odd>(i); });
    for (std::size_t i = 0; i < escapes_; ++i) {
      *escaped_[i] = MaterialId{decode_slot(source_, i % kLanes, code_.materials)};
    }
    escapes_ = 0;
    return source_.next <= source_.end && !bad_number_;
  }

  template <bool odd>
  HWY_INLINE void finish_row(std::size_t i) {
    const Batch::Symbols& symbols = symbols_[i];
    const WaveRow<MaterialId>& row = row_[i];
    const RowNeighbours near = neighbours_of(row, around_.row(i));
    const RowVec now = near.now;  // the first candidates
    RowVec second;
    if constexpr (odd) {
      second = second_of_odd(near, row.around, beside_rows_, i, west_of(now, row.voxels),
                             east_of(now, row.voxels));
    } else {
      second = second_of_even(near, row.around, same_rows_[i]);
    }
    RowVec found = select(symbols.low & ~symbols.high, second, now);
    const RowMask is_third = symbols.high & ~symbols.low;
    if (is_third != 0) {
      RowMask exists = 0;
      const RowVec third = third_candidate(now, second, near.masks.level, row.around, exists);
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
  const VolumePack* pack_ = volume_pack();
  EqualMasks equal_;
  AroundArrays around_;
  GrowingBeside beside_;
  BesideArrays beside_rows_;
  BatchMasks masks_;
  GrowingMasks same_;
  GrowingMasks south_;
  WaveMasks same_rows_;
  Batch batch_;
  std::array<WaveRow<MaterialId>, kWaveRows> row_;
  std::size_t rows_ = 0;
  std::uint32_t mixed_ = 0;  // bit i: row i, or a row around it, is not of the one material
  std::array<Batch::Symbols, kWaveRows> symbols_;
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
