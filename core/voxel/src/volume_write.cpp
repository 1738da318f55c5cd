#include "volume_write.h"

#include <algorithm>

#include <talus/vectors/tables.h>

#include "volume_scalar.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "volume_write.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "volume_candidates-inl.h"

HWY_BEFORE_NAMESPACE();
namespace talus::HWY_NAMESPACE {
namespace {

using namespace codec;

#if HWY_TARGET == HWY_SCALAR

bool analyse(const DenseVoxels& voxels, VolumeEvents& events) {
  return analyse_volume_scalar(voxels, events);
}

void write(const VolumeEvents& events, const EventBatches& batches, const std::uint32_t* intervals,
           RansSink& sink) {
  write_volume_scalar(events, batches, intervals, sink);
}

void write_intervals(const std::uint32_t* intervals, std::size_t count, RansSink& sink) {
  write_intervals_scalar(intervals, count, sink);
}

#else

class Analyser {
 public:
  Analyser(const DenseVoxels& voxels, VolumeEvents& events) : voxels_{voxels.data()}, events_{events} {
    row_zero_.fill(voxels.front());
    std::copy_n(first_row(), kChunkSize, first_.begin() + kChunkSize);
    std::copy_n(last_row(), kChunkSize, last_.begin() + kChunkSize);
  }

  bool analyse() {
    // In the order of memory, which that of waves is not: voxels that nobody has touched lately come in at
    // once.
    for (std::size_t i = 0; i < kChunkVolume; i += kChunkSize) hwy::Prefetch(voxels_ + i);
    events_.coded = events_.surprises = events_.changes = events_.exceptions = events_.escapes = 0;
    for (int wave = 0; wave < kWaves; ++wave) {
      rows_ = static_cast<std::size_t>(last_row_of(wave) - first_row_of(wave) + 1);
      const AroundMasks<MaskVec> around = equal_.around(wave);
      around_.store(around);
      const MaskVec in_wave = mask_of_rows(rows_);
      mixed_ = rows_with_any(in_wave & ~(around.all() & around.level));
      compare(wave);
      if (mixed_ == 0) {
        add_steady_wave(wave);
      } else {
        add_mixed_wave(wave, in_wave, around);
      }
      if (is_noise(2 * static_cast<std::size_t>(wave) + 2, events_)) return false;
    }
    return true;
  }

 private:
  HWY_INLINE void add_mixed_wave(int wave, const MaskVec& in_wave, const AroundMasks<MaskVec>& around) {
    const MaskVec same = same_.get();
    store_masks(same, same_rows_.data());
    masks_.store<7>(in_wave & set_masks(kEvenColumns), same & around.all(),
                    even_contexts(around, same, south_.get()));
    store_masks(select(around.level, north_.get(), below_.get()), is_first_.data());
    add_batch<false>(2 * static_cast<std::size_t>(wave));

    const BesideMasks<MaskVec> beside = beside_.get();
    beside_rows_.store(beside);
    const MaskVec west = west_.get();
    store_masks(select(beside.is_east(), of_east(west), west), is_first_.data());
    masks_.store<8>(in_wave & set_masks(kOddColumns), beside.agrees() & around.all(),
                    odd_contexts(around, beside, same));
    add_batch<true>(2 * static_cast<std::size_t>(wave) + 1);
  }

  [[nodiscard]] const MaterialId* first_row() const { return voxels_; }
  [[nodiscard]] const MaterialId* last_row() const { return voxels_ + kChunkVolume - kChunkSize; }

  /// The same row, where loads may touch the voxels before and after it.
  [[nodiscard]] HWY_INLINE const MaterialId* padded(const MaterialId* row) const {
    if (HWY_UNLIKELY(row == first_row())) return first_.data() + kChunkSize;
    if (HWY_UNLIKELY(row == last_row())) return last_.data() + kChunkSize;
    return row;
  }

  /// Compares the rows of a wave, but for those that are of one material with all around.
  HWY_INLINE void compare(int wave) {
    for (GrowingMasks* masks : {&same_, &south_, &north_, &below_, &west_}) masks->clear();
    beside_.clear();
    equal_.begin(wave);
    const int first = first_row_of(wave);
    place_rows(voxels_, row_zero_.data() + kChunkSize, wave, row_);
    for (std::size_t i = 0; i < rows_; ++i) {
      const RowMask below = equal(load_voxels(row_[i].voxels), load_voxels(row_[i].around.below));
      mixed_ |= (below != kAllColumns ? 1U : 0U) << i;
    }
    over_bits(mixed_, [this, first, wave](std::size_t i) HWY_ATTR {
      WaveRow<const MaterialId>& row = row_[i];
      row.voxels = padded(row.voxels);
      row.around.north = padded(row.around.north);
      row.around.below = padded(row.around.below);
      const RowVec now = load_voxels(row.voxels);
      const RowVec below = load_voxels(row.around.below);
      const RowVec north = load_voxels(row.around.north);
      const RowVec west = west_of(now, row.voxels);
      const RowMask level = around_.of.level[i];
      const RowMask equals_west = equal(now, west) | 1U;
      const RowMask equals_north = equal(now, north);
      const RowMask equals_below = equal(now, below);
      west_.set(i, equals_west);
      north_.set(i, equals_north);
      below_.set(i, equals_below);
      same_.set(i, equal(north, below));
      south_.set(i, equal(load_voxels(row.around.below_south), north));
      (void)beside_.set(i, select(level, north, below), select(level, below, north), west,
                        east_of(now, row.voxels));
      const int y = first + static_cast<int>(i);
      equal_.set(y, wave - 2 * y, equals_west, equals_north, equals_below);
      events_.changes += static_cast<std::size_t>(std::popcount(~equals_west));
    });
  }

  /// All rows are of one material with all around them: nothing to code.
  HWY_INLINE void add_steady_wave(int wave) {
    gap_ += static_cast<std::uint32_t>(rows_ * kChunkSize);
    for (const std::size_t batch :
         {2 * static_cast<std::size_t>(wave), 2 * static_cast<std::size_t>(wave) + 1}) {
      events_.batch[batch] = 0;
      events_.batch_escapes[batch] = 0;
    }
  }

  template <bool odd>
  HWY_INLINE void add_batch(std::size_t batch) {
    const std::size_t coded = events_.coded;
    const std::size_t escapes = events_.escapes;
    add_exceptions(batch);
    // Which rows have other symbols than 0 cannot be foreseen: they are found first, without a branch for
    // each.
    const MaskVec low = load_masks(masks_.coded.data()) & ~load_masks(is_first_.data());
    store_masks(low, low_.data());
    store_masks(set_masks(0), high_.data());
    over_bits(rows_with_any(low),
              [this](std::size_t i) HWY_ATTR { find_symbols<odd>(i, low_[i], high_[i]); });
    if (masks_.coded_rows != 0) {
      put_symbols(events_.symbol.data() + events_.coded);
      events_.coded += masks_.put_contexts < odd ? 8 : 7 > (pack_, events_.context.data() + events_.coded);
    }
    events_.batch[batch] = static_cast<std::uint16_t>(events_.coded - coded);
    events_.batch_escapes[batch] = static_cast<std::uint16_t>(events_.escapes - escapes);
  }

  HWY_INLINE void put_symbols(std::uint8_t* out) const {
    if (HWY_TARGET <= HWY_AVX3 && pack_ != nullptr) {
      return pack_->symbols({masks_.coded.data(), masks_.coded_rows}, low_.data(), high_.data(), out);
    }
    over_bits(masks_.coded_rows, [&](std::size_t i) HWY_ATTR {
      put_numbers<2>(
          masks_.coded[i], [&](std::size_t b) { return b == 0 ? low_[i] : high_[i]; }, out);
      out += std::popcount(masks_.coded[i]);
    });
  }

  HWY_INLINE void add_exceptions(std::size_t batch) {
    const std::uint32_t all = masks_.steady_voxels();
    if (HWY_LIKELY(rows_with_any(load_masks(masks_.steady.data()) & ~load_masks(is_first_.data())) == 0)) {
      gap_ += all;
      return;
    }
    for (std::size_t i = 0; i < rows_; ++i) {
      const RowMask steady = masks_.steady[i];
      std::uint32_t passed = 0;
      for (RowMask left = steady & ~is_first_[i]; left != 0; left &= left - 1) {
        const int x = std::countr_zero(left);
        const auto before = static_cast<std::uint32_t>(std::popcount(steady & ((RowMask{1} << x) - 1)));
        events_.exception[events_.exceptions++] = {static_cast<std::uint16_t>(gap_ + before - passed),
                                                   static_cast<std::uint16_t>(batch), row_[i].voxels[x]};
        gap_ = 0;
        passed = before + 1;
      }
      gap_ += static_cast<std::uint32_t>(std::popcount(steady)) - passed;
    }
  }

  /// The symbols of the coded voxels that are not their first candidates: at first those of `low`.
  template <bool odd>
  HWY_INLINE void find_symbols(std::size_t i, RowMask& low, RowMask& high) {
    events_.surprises += static_cast<std::size_t>(std::popcount(low));
    const WaveRow<const MaterialId>& row = row_[i];
    const RowNeighbours near = neighbours_of(row, around_.row(i));
    RowVec first;
    RowVec second;
    if constexpr (odd) {
      const RowVec west = west_of(near.now, row.voxels);
      const RowVec east = east_of(near.now, row.voxels);
      first = select(beside_rows_.is_east[i], east, west);
      second = second_of_odd(near, row.around, beside_rows_, i, west, east);
    } else {
      first = select(near.masks.level, near.north, near.below);
      second = second_of_even(near, row.around, same_rows_[i]);
    }
    high = low & ~equal(near.now, second);
    low &= ~high;
    if (high == 0) return;
    RowMask exists = 0;
    const RowVec third = third_candidate(first, second, near.masks.level, row.around, exists);
    RowMask escapes = high & ~(exists & equal(near.now, third));
    low |= escapes;
    for (; escapes != 0; escapes &= escapes - 1) {
      events_.escape[events_.escapes++] = row.voxels[std::countr_zero(escapes)];
    }
  }

  const MaterialId* voxels_;
  VolumeEvents& events_;
  const VolumePack* pack_ = volume_pack();
  EqualMasks equal_;
  AroundArrays around_;
  GrowingBeside beside_;
  BesideArrays beside_rows_;
  BatchMasks masks_;
  GrowingMasks same_;
  GrowingMasks south_;
  GrowingMasks north_;  // where the rows equal those to the north, and so on
  GrowingMasks below_;
  GrowingMasks west_;
  WaveMasks same_rows_;
  WaveMasks is_first_;  // where the voxels are their first candidates
  WaveMasks low_;       // the symbols of coded voxels, as bits
  WaveMasks high_;
  std::array<WaveRow<const MaterialId>, kWaveRows> row_;
  std::size_t rows_ = 0;
  std::uint32_t mixed_ = 0;  // bit i: row i is not of one material with all around it
  std::uint32_t gap_ = 0;
  std::array<MaterialId, 3 * kChunkSize> row_zero_;
  std::array<MaterialId, 3 * kChunkSize> first_{};
  std::array<MaterialId, 3 * kChunkSize> last_{};
};

bool analyse(const DenseVoxels& voxels, VolumeEvents& events) {
  return Analyser{voxels, events}.analyse();
}

/// The rANS states while symbols are written, the last one first.
class SymbolWriter {
 public:
  explicit SymbolWriter(RansSink& sink)
      : sink_{sink}, states_{load_words(sink.states.data())}, next_{sink.next} {}

  /// Sixteen symbols; each word holds start and size of an interval.
  HWY_INLINE void put(const std::uint32_t* intervals) {
    const Words d;
    const auto* const words = reinterpret_cast<const std::uint16_t*>(intervals);
    WordParts starts;
    WordParts sizes;
    for (std::size_t p = 0; p < kParts; ++p) {
      const auto low = hn::LoadU(d, words + 2 * p * hn::MaxLanes(d));
      const auto high = hn::LoadU(d, words + (2 * p + 1) * hn::MaxLanes(d));
      starts.part[p] = hn::ConcatEven(d, high, low);
      sizes.part[p] = hn::ConcatOdd(d, high, low);
    }
    encode_symbols(states_, starts, sizes, next_);
  }

  /// Fewer symbols than lanes, or as many.
  HWY_INLINE void put(const std::uint32_t* intervals, std::size_t count) {
    if (count == kLanes) return put(intervals);
    alignas(64) std::array<std::uint32_t, kLanes> some;
    some.fill(kEverything);
    std::copy_n(intervals, count, some.begin());
    put(some.data());
  }

  /// The symbols of up to sixteen voxels. `intervals`: by context and symbol.
  HWY_INLINE void put_voxels(const std::uint8_t* contexts, const std::uint8_t* symbols, std::size_t count,
                             const std::uint32_t* intervals) {
#if HWY_TARGET == HWY_AVX3
    const auto active = static_cast<__mmask16>((1U << count) - 1);
    const Half d;
    const __m512i context = _mm512_cvtepu8_epi32(hn::LoadU(d, contexts).raw);
    const __m512i symbol = _mm512_cvtepu8_epi32(hn::LoadU(d, symbols).raw);
    const __m512i found =
        _mm512_mask_i32gather_epi32(_mm512_set1_epi32(static_cast<int>(kEverything)), active,
                                    _mm512_add_epi32(_mm512_slli_epi32(context, 2), symbol), intervals, 4);
    WordParts starts;
    WordParts sizes;
    starts.part[0] = WordVec{_mm512_cvtepi32_epi16(found)};
    sizes.part[0] = WordVec{_mm512_cvtepi32_epi16(_mm512_srli_epi32(found, 16))};
    encode_symbols(states_, starts, sizes, next_);
#else
    alignas(64) std::array<std::uint32_t, kLanes> found;
    if (count < kLanes) found.fill(kEverything);
    for (std::size_t i = 0; i < count; ++i) found[i] = intervals[4 * std::size_t{contexts[i]} + symbols[i]];
    put(found.data());
#endif
  }

  HWY_INLINE void finish() {
    store_words(states_, sink_.states.data());
    sink_.next = next_;
  }

 private:
  /// The interval that leaves a lane as it is.
  static constexpr std::uint32_t kEverything = std::uint32_t{kProbabilityTotal} << 16U;

  RansSink& sink_;
  WordParts states_;
  std::uint8_t* next_;
};

/// Calls put(first, count) for groups of sixteen out of `count`, the last one first.
template <class Put>
HWY_INLINE void over_groups(std::size_t count, const Put& put) {
  for (std::size_t left = count; left > 0;) {
    const std::size_t size = left % kLanes != 0 ? left % kLanes : kLanes;
    left -= size;
    put(left, size);
  }
}

void write_intervals(const std::uint32_t* intervals, std::size_t count, RansSink& sink) {
  SymbolWriter writer{sink};
  over_groups(count,
              [&](std::size_t first, std::size_t size) HWY_ATTR { writer.put(intervals + first, size); });
  writer.finish();
}

void write(const VolumeEvents& events, const EventBatches& batches, const std::uint32_t* intervals,
           RansSink& sink) {
  SymbolWriter writer{sink};
  std::size_t first = batches.first_coded + batches.coded;
  for (std::size_t batch = batches.end; batch-- > batches.begin;) {
    first -= events.batch[batch];
    over_groups(events.batch[batch], [&](std::size_t at, std::size_t size) HWY_ATTR {
      writer.put_voxels(events.context.data() + first + at, events.symbol.data() + first + at, size,
                        intervals + 4 * first_context_of(batch));
    });
  }
  writer.finish();
}

#endif

}  // namespace

constexpr VolumeWrite kWrite{analyse, write, write_intervals};

}  // namespace talus::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace talus::codec {

const VolumeWrite& volume_write(InstructionSet set) {
  static constexpr const VolumeWrite* kTables[] = TALUS_TABLES(kWrite);
  return *kTables[static_cast<std::size_t>(set)];
}

}  // namespace talus::codec
#endif
