#include "volume_write.h"

#include <algorithm>

#include <talus/vectors/tables.h>

#include "volume_scalar.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "volume_write.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "rans-inl.h"
#include "volume_analyse-inl.h"

HWY_BEFORE_NAMESPACE();
namespace talus::HWY_NAMESPACE {
namespace {

using namespace codec;

#if HWY_TARGET == HWY_SCALAR

bool analyse(const DenseVoxels& voxels, VolumeEvents& events) {
  return analyse_volume_scalar(voxels, events);
}

void write(const VolumeEvents& events, const EventBatches& batches, const VolumeSymbols& symbols,
           RansSink& sink) {
  write_volume_scalar(events, batches, symbols, sink);
}

void write_intervals(const std::uint32_t* intervals, std::size_t count, RansSink& sink) {
  write_intervals_scalar(intervals, count, sink);
}

#else

bool analyse(const DenseVoxels& voxels, VolumeEvents& events) {
  VolumeAnalyser analyser{voxels, events};
  return analyser.number(voxels) ? analyser.analyse() : analyse_volume_scalar(voxels, events);
}

/// The rANS states during writing, last symbol first.
class SymbolWriter {
 public:
  explicit SymbolWriter(RansSink& sink)
      : sink_{sink}, states_{load_words(sink.states.data())}, next_{sink.next} {}

  /// Writes sixteen symbols; each word holds start and size of an interval.
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

  /// Writes at most as many symbols as there are lanes.
  HWY_INLINE void put(const std::uint32_t* intervals, std::size_t count) {
    if (count == kLanes) return put(intervals);
    alignas(64) std::array<std::uint32_t, kLanes> some;
    some.fill(kEverything);
    std::copy_n(intervals, count, some.begin());
    put(some.data());
  }

#if HWY_TARGET == HWY_AVX3
  /// Writes sixteen symbols; a size of 0 means 256, which leaves a lane unchanged if the start is 0.
  HWY_INLINE void put(const std::uint8_t* starts, const std::uint8_t* sizes) {
    const Half d;
    const Words words;
    WordParts start;
    WordParts size;
    start.part[0] = hn::PromoteTo(words, hn::LoadU(d, starts));
    size.part[0] = hn::Add(hn::PromoteTo(words, hn::Sub(hn::LoadU(d, sizes), hn::Set(d, 1))),
                           hn::Set(words, std::uint16_t{1}));
    encode_symbols(states_, start, size, next_);
  }
#endif

  /// Writes the symbols of up to sixteen voxels. `intervals`: by context and symbol.
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
  /// The interval that leaves a lane unchanged.
  static constexpr std::uint32_t kEverything = std::uint32_t{kProbabilityTotal} << 16U;

  RansSink& sink_;
  WordParts states_;
  std::uint8_t* next_;
};

/// Calls put(first, count) for groups of sixteen out of `count`, last group first.
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

void write(const VolumeEvents& events, const EventBatches& batches, const VolumeSymbols& symbols,
           RansSink& sink) {
  SymbolWriter writer{sink};
  std::size_t first = batches.first_coded + batches.coded;
#if HWY_TARGET == HWY_AVX3
  if (const VolumeVbmi* const vbmi = volume_vbmi(); HWY_LIKELY(vbmi != nullptr)) {
    // The intervals of all batches, each starting at lane 0: then it does not matter where a batch ends.
    alignas(64) std::array<std::uint8_t, kChunkVolume + kBatches * kLanes + 64> starts;
    alignas(64) std::array<std::uint8_t, kChunkVolume + kBatches * kLanes + 64> sizes;
    std::size_t place = 0;
    std::size_t at = batches.first_coded;
    for (std::size_t batch = batches.begin; batch < batches.end; ++batch) {
      const std::size_t count = events.batch[batch];
      const std::size_t first_context = first_context_of(batch);
      vbmi->intervals(symbols.ends.data() + first_context, first_context != 0, events.context.data() + at,
                      events.symbol.data() + at, count, starts.data() + place, sizes.data() + place);
      at += count;
      place += (count + kLanes - 1) / kLanes * kLanes;
    }
    for (; place > 0; place -= kLanes)
      writer.put(starts.data() + place - kLanes, sizes.data() + place - kLanes);
    writer.finish();
    return;
  }
#endif
  for (std::size_t batch = batches.end; batch-- > batches.begin;) {
    const std::size_t count = events.batch[batch];
    first -= count;
    const std::uint32_t* const intervals = symbols.interval.data() + 4 * first_context_of(batch);
    over_groups(count, [&](std::size_t at, std::size_t size) HWY_ATTR {
      writer.put_voxels(events.context.data() + first + at, events.symbol.data() + first + at, size,
                        intervals);
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
