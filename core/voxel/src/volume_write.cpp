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

void analyse(const DenseVoxels& voxels, VolumeEvents& events) {
  analyse_volume_scalar(voxels, events);
}

void write(const VolumeEvents& events, std::size_t first, std::size_t count, const std::uint32_t* intervals,
           RansSink& sink) {
  write_volume_scalar(events, first, count, intervals, sink);
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

  void analyse() {
    events_.coded = events_.exceptions = events_.escapes = 0;
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
    }
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
    row.around = rows_around(voxels_, row_zero_.data() + kChunkSize, y, z);
    row.around.north = padded(row.around.north);
    row.around.below = padded(row.around.below);
    row.masks = equal_.around(static_cast<std::size_t>(y), static_cast<std::size_t>(z));
    const RowVec now = load_voxels(row.voxels);
    const RowVec below = load_voxels(row.around.below);
    const RowVec north = load_voxels(row.around.north);
    const RowMask equals_below = equal(now, below);
    const RowMask equals_north = equal(now, north);
    row.west = equal(now, load_voxels(row.voxels - 1)) | 1U;
    equal_.set(static_cast<std::size_t>(y), static_cast<std::size_t>(z), row.west, equals_north, equals_below);
    row.uniform = (row.masks.all() & row.masks.level & equals_below) == kAllColumns;
    if (row.uniform) {
      gap_ += kLanes;
      return;
    }
    row.same = equal(north, below);
    const RowMask steady = kEvenColumns & row.same & row.masks.all();
    const RowMask coded = kEvenColumns & ~steady;
    const RowMask is_first = codec::select(row.masks.level, equals_north, equals_below);
    add_exceptions(row, steady, is_first);
    if (coded == 0) return;
    const RowMask south = equal(load_voxels(row.around.below_south), north);
    RowMask is_second = ~row.same & codec::select(row.masks.level, equals_below, equals_north);
    if ((coded & row.same & ~is_first) != 0) {
      is_second |= row.same & equal(now, first_different(row.masks, row.around));
    }
    add_coded<7>(row, coded, even_contexts(row.masks, row.same, south), is_first, is_second);
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
    const RowVec west = load_voxels(row.voxels - 1);
    const RowVec east = load_voxels(row.voxels + 1);
    const BesideMasks beside{equal(west, east) | 1U << 31U, equal(base, west), equal(base, east),
                             equal(other, west), equal(other, east)};
    const RowMask agrees = beside.agrees();
    const RowMask is_east = beside.is_east();
    const RowMask steady = kOddColumns & agrees & row.masks.all();
    const RowMask coded = kOddColumns & ~steady;
    const RowMask is_first = codec::select(is_east, row.west >> 1U, row.west);
    add_exceptions(row, steady, is_first);
    if (coded == 0) return;
    RowMask is_second = 0;
    if ((coded & ~is_first) != 0) {
      const RowVec of_equal = select(row.masks.level ^ beside.base_west, north, below);
      const RowVec beyond = select(is_east, west, east);
      const RowVec candidate =
          select(agrees, first_different(row.masks, row.around), select(beside.equal, of_equal, beyond));
      is_second = equal(now, candidate);
    }
    add_coded<8>(row, coded, odd_contexts(row.masks, beside, row.same), is_first, is_second);
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

  template <std::size_t count>
  HWY_INLINE void add_coded(const WaveRow& row, RowMask coded, const ContextBits& contexts, RowMask is_first,
                            RowMask is_second) {
    const RowMask rare = coded & ~(is_first | is_second);
    RowMask low = coded & ~is_first & is_second;
    for (RowMask left = rare; left != 0; left &= left - 1) {
      const int x = std::countr_zero(left);
      const Prediction prediction = predict(row.around, row.voxels, x);
      if (prediction.candidates == kCandidates && prediction.candidate[kCandidates - 1] == row.voxels[x]) continue;
      low |= RowMask{1} << x;
      events_.escape[events_.escapes++] = row.voxels[x];
    }
    put_numbers<count>(coded, contexts, events_.context.data() + events_.coded);
    put_numbers<2>(coded, std::array{low, rare}, events_.symbol.data() + events_.coded);
    events_.coded += static_cast<std::size_t>(std::popcount(coded));
  }

  const MaterialId* voxels_;
  VolumeEvents& events_;
  EqualMasks equal_;
  std::array<WaveRow, 16> rows_;
  std::size_t batch_ = 0;
  std::uint32_t gap_ = 0;
  std::array<MaterialId, 3 * kChunkSize> row_zero_;
  std::array<MaterialId, 3 * kChunkSize> first_{};
  std::array<MaterialId, 3 * kChunkSize> last_{};
};

void analyse(const DenseVoxels& voxels, VolumeEvents& events) {
  Analyser{voxels, events}.analyse();
}

void write(const VolumeEvents& events, std::size_t first, std::size_t count, const std::uint32_t* intervals,
           RansSink& sink) {
  if (count == 0) return;
  std::array<std::uint16_t, kMaxBatch> starts;
  std::array<std::uint16_t, kMaxBatch> sizes;
  for (std::size_t i = 0; i < count; ++i) {
    // Where the intervals start and end, a byte each, but for the last end.
    const std::uint64_t ends = std::uint64_t{intervals[events.context[first + i]]} << 8U | std::uint64_t{256} << 32U;
    const unsigned shift = 8U * events.symbol[first + i];
    const std::uint64_t start = ends >> shift & 0xFFU;
    const std::uint64_t end = ends >> shift >> 8U & (shift == 8U * kEscape ? 0x1FFU : 0xFFU);
    starts[i] = static_cast<std::uint16_t>(start);
    sizes[i] = static_cast<std::uint16_t>(end - start);
  }
  const std::size_t groups = (count + kLanes - 1) / kLanes;
  for (std::size_t i = count; i < groups * kLanes; ++i) {
    starts[i] = 0;
    sizes[i] = kProbabilityTotal;
  }
  WordParts states = load_words(sink.states.data());
  std::uint8_t* next = sink.next;
  for (std::size_t g = groups; g-- > 0;) {
    encode_symbols(states, load_words(starts.data() + g * kLanes), load_words(sizes.data() + g * kLanes), next);
  }
  sink.next = next;
  store_words(states, sink.states.data());
}

#endif

}  // namespace

constexpr VolumeWrite kWrite{analyse, write};

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
