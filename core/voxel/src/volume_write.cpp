#include "volume_write.h"

#include <algorithm>

#include <talus/vectors/tables.h>

#include "volume_scalar.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "volume_write.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "volume-inl.h"

HWY_BEFORE_NAMESPACE();
namespace talus::HWY_NAMESPACE {
namespace {

using namespace codec;

#if HWY_TARGET == HWY_SCALAR

bool analyse(const DenseVoxels& voxels, VolumeEvents& events) {
  return analyse_volume_scalar(voxels, events);
}

void write(const VolumeEvents& events, std::size_t first, std::size_t count, const std::uint32_t* intervals,
           RansSink& sink) {
  write_volume_scalar(events, first, count, intervals, sink);
}

void write_intervals(const std::uint32_t* intervals, std::size_t count, RansSink& sink) {
  write_intervals_scalar(intervals, count, sink);
}

#else

/// A row of the wave that is being written.
struct WaveRow {
  const MaterialId* voxels;
  RowsAround around;
  AroundMasks masks;
  RowMask same;
  RowMask west;  // which voxels equal the one to their west
  bool uniform;  // it and all around it are of one material
};

class Analyser {
 public:
  Analyser(const DenseVoxels& voxels, VolumeEvents& events) : voxels_{voxels.data()}, events_{events} {
    row_zero_.fill(voxels.front());
    std::copy_n(first_row(), kChunkSize, first_.begin() + kChunkSize);
    std::copy_n(last_row(), kChunkSize, last_.begin() + kChunkSize);
  }

  bool analyse() {
    events_.coded = events_.surprises = events_.exceptions = events_.escapes = 0;
    for (batch_ = 0; batch_ < kBatches; ++batch_) {
      const int wave = static_cast<int>(batch_ / 2);
      const int first = first_row_of(wave);
      const auto rows = static_cast<std::size_t>(last_row_of(wave) - first + 1);
      const std::size_t coded = events_.coded;
      const std::size_t escapes = events_.escapes;
      for (std::size_t i = 0; i < rows; ++i) {
        if (batch_ % 2 == 0) {
          even(rows_[i], first + static_cast<int>(i), wave);
        } else {
          odd(rows_[i]);
        }
      }
      events_.batch[batch_] = static_cast<std::uint16_t>(events_.coded - coded);
      events_.batch_escapes[batch_] = static_cast<std::uint16_t>(events_.escapes - escapes);
      if (is_noise(batch_ + 1, events_.surprises)) return false;
    }
    return true;
  }

 private:
  [[nodiscard]] const MaterialId* first_row() const { return voxels_; }
  [[nodiscard]] const MaterialId* last_row() const { return voxels_ + kChunkVolume - kChunkSize; }

  /// The same row, where loads may touch the voxels before and after it.
  [[nodiscard]] HWY_INLINE const MaterialId* padded(const MaterialId* row) const {
    if (HWY_UNLIKELY(row == first_row())) return first_.data() + kChunkSize;
    if (HWY_UNLIKELY(row == last_row())) return last_.data() + kChunkSize;
    return row;
  }

  HWY_INLINE void even(WaveRow& row, int y, int wave) {
    const int z = wave - 2 * y;
    row.voxels = padded(voxels_ + (y * kChunkSize + z) * kChunkSize);
    row.masks = equal_.around(static_cast<std::size_t>(y), static_cast<std::size_t>(z));
    row.around = rows_around(voxels_, row_zero_.data() + kChunkSize, y, z);
    const RowVec now = load_voxels(row.voxels);
    const RowVec below = load_voxels(row.around.below);
    const RowMask equals_below = equal(now, below);
    row.uniform = (row.masks.all() & row.masks.level & equals_below) == kAllColumns;
    if (row.uniform) {  // the masks of such a row are what they were set to at first
      gap_ += kLanes;
      return;
    }
    row.around.north = padded(row.around.north);
    row.around.below = padded(row.around.below);
    const RowVec north = load_voxels(row.around.north);
    const RowMask equals_north = equal(now, north);
    row.west = equal(now, west_of(now, row.voxels)) | 1U;
    equal_.set(static_cast<std::size_t>(y), static_cast<std::size_t>(z), row.west, equals_north,
               equals_below);
    row.same = equal(north, below);
    const RowMask steady = kEvenColumns & row.same & row.masks.all();
    const RowMask coded = kEvenColumns & ~steady;
    const RowMask is_first = codec::select(row.masks.level, equals_north, equals_below);
    if ((steady & ~is_first) == 0) {
      gap_ += static_cast<std::uint32_t>(std::popcount(steady));
    } else {
      add_exceptions(row, steady, is_first);
    }
    if (coded == 0) return;
    const RowMask south = equal(load_voxels(row.around.below_south), north);
    const auto contexts = even_contexts(row.masks, row.same, south);
    if ((coded & ~is_first) == 0) return add_first<7>(coded, contexts);
    const RowVec first = select(row.masks.level, north, below);
    const RowVec second =
        select(row.same, first_different(row.masks, row.around), select(row.masks.level, below, north));
    add_coded(row, coded & ~is_first, now, first, second);
    add_contexts<7>(coded, contexts);
  }

  HWY_INLINE void odd(const WaveRow& row) {
    if (row.uniform) {
      gap_ += kLanes;
      return;
    }
    const RowVec now = load_voxels(row.voxels);
    const RowVec below = load_voxels(row.around.below);
    const RowVec north = load_voxels(row.around.north);
    const RowVec base = select(row.masks.level, north, below);
    const RowVec other = select(row.masks.level, below, north);
    const RowVec west = west_of(now, row.voxels);
    const RowVec east = east_of(now, row.voxels);
    const BesideMasks beside{equal(west, east) | 1U << 31U, equal(base, west), equal(base, east),
                             equal(other, west), equal(other, east)};
    const RowMask agrees = beside.agrees();
    const RowMask is_east = beside.is_east();
    const RowMask steady = kOddColumns & agrees & row.masks.all();
    const RowMask coded = kOddColumns & ~steady;
    const RowMask is_first = codec::select(is_east, row.west >> 1U, row.west);
    if ((steady & ~is_first) == 0) {
      gap_ += static_cast<std::uint32_t>(std::popcount(steady));
    } else {
      add_exceptions(row, steady, is_first);
    }
    if (coded == 0) return;
    const auto contexts = odd_contexts(row.masks, beside, row.same);
    if ((coded & ~is_first) == 0) return add_first<8>(coded, contexts);
    const RowVec of_equal = select(row.masks.level ^ beside.base_west, north, below);
    const RowVec second = select(agrees, first_different(row.masks, row.around),
                                 select(beside.equal, of_equal, select(is_east, west, east)));
    add_coded(row, coded & ~is_first, now, select(is_east, east, west), second);
    add_contexts<8>(coded, contexts);
  }

  HWY_INLINE void add_exceptions(const WaveRow& row, RowMask steady, RowMask is_first) {
    std::uint32_t passed = 0;
    for (RowMask left = steady & ~is_first; HWY_UNLIKELY(left != 0); left &= left - 1) {
      const int x = std::countr_zero(left);
      const auto before = static_cast<std::uint32_t>(std::popcount(steady & ((RowMask{1} << x) - 1)));
      events_.exception[events_.exceptions++] = {static_cast<std::uint16_t>(gap_ + before - passed),
                                                 static_cast<std::uint16_t>(batch_), row.voxels[x]};
      gap_ = 0;
      passed = before + 1;
    }
    gap_ += static_cast<std::uint32_t>(std::popcount(steady)) - passed;
  }

  /// Coded voxels that all are their first candidates.
  template <std::size_t count>
  HWY_INLINE void add_first(RowMask coded, const ContextBits& contexts) {
    low_ = high_ = 0;
    add_contexts<count>(coded, contexts);
  }

  /// Finds the symbols of coded voxels; those of `left` are not their first candidates.
  HWY_INLINE void add_coded(const WaveRow& row, RowMask left, const RowVec& now, const RowVec& first,
                            const RowVec& second) {
    events_.surprises += static_cast<std::size_t>(std::popcount(left));
    low_ = left & equal(now, second);
    high_ = left & ~low_;
    if (high_ == 0) return;
    RowMask exists = 0;
    const RowVec third = third_candidate(first, second, row.masks, row.around, exists);
    RowMask escapes = high_ & ~(exists & equal(now, third));
    low_ |= escapes;
    for (; escapes != 0; escapes &= escapes - 1) {
      events_.escape[events_.escapes++] = row.voxels[std::countr_zero(escapes)];
    }
  }

  template <std::size_t count>
  HWY_INLINE void add_contexts(RowMask coded, const ContextBits& contexts) {
    put_numbers<count>(coded, contexts, events_.context.data() + events_.coded);
    put_numbers<2>(coded, std::array{low_, high_}, events_.symbol.data() + events_.coded);
    events_.coded += static_cast<std::size_t>(std::popcount(coded));
  }

  const MaterialId* voxels_;
  VolumeEvents& events_;
  EqualMasks equal_;
  std::array<WaveRow, 16> rows_;
  std::size_t batch_ = 0;
  std::uint32_t gap_ = 0;
  RowMask low_ = 0;  // the symbols of the row, as bits
  RowMask high_ = 0;
  std::array<MaterialId, 3 * kChunkSize> row_zero_;
  std::array<MaterialId, 3 * kChunkSize> first_{};
  std::array<MaterialId, 3 * kChunkSize> last_{};
};

bool analyse(const DenseVoxels& voxels, VolumeEvents& events) {
  return Analyser{voxels, events}.analyse();
}

/// Sixteen intervals from sixteen words that hold start and size.
HWY_INLINE void split(const std::uint32_t* intervals, WordParts& starts, WordParts& sizes) {
  const Words d;
  const auto* const words = reinterpret_cast<const std::uint16_t*>(intervals);
  for (std::size_t p = 0; p < kParts; ++p) {
    const auto low = hn::LoadU(d, words + 2 * p * hn::MaxLanes(d));
    const auto high = hn::LoadU(d, words + (2 * p + 1) * hn::MaxLanes(d));
    starts.part[p] = hn::ConcatEven(d, high, low);
    sizes.part[p] = hn::ConcatOdd(d, high, low);
  }
}

void write_intervals(const std::uint32_t* intervals, std::size_t count, RansSink& sink) {
  if (count == 0) return;
  WordParts states = load_words(sink.states.data());
  std::uint8_t* next = sink.next;
  WordParts starts;
  WordParts sizes;
  std::size_t left = count;
  if (const std::size_t rest = count % kLanes; rest != 0) {
    // An interval of everything leaves the lanes behind the last symbol as they are.
    alignas(64) std::array<std::uint32_t, kLanes> last;
    last.fill(std::uint32_t{kProbabilityTotal} << 16U);
    left -= rest;
    std::copy_n(intervals + left, rest, last.begin());
    split(last.data(), starts, sizes);
    encode_symbols(states, starts, sizes, next);
  }
  while (left > 0) {
    left -= kLanes;
    split(intervals + left, starts, sizes);
    encode_symbols(states, starts, sizes, next);
  }
  sink.next = next;
  store_words(states, sink.states.data());
}

void write(const VolumeEvents& events, std::size_t first, std::size_t count, const std::uint32_t* intervals,
           RansSink& sink) {
  alignas(64) std::array<std::uint32_t, kMaxBatch> found;
  for (std::size_t i = 0; i < count; ++i) {
    found[i] = intervals[4 * std::size_t{events.context[first + i]} + events.symbol[first + i]];
  }
  write_intervals(found.data(), count, sink);
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
