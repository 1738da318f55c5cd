#include "volume_write.h"

#include <algorithm>

#include <talus/vectors/tables.h>

#include "volume_scalar.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "volume_write.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "volume_batch-inl.h"
#include "volume_candidates-inl.h"
#include "volume_numbers-inl.h"

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

class Analyser {
 public:
  Analyser(const DenseVoxels& voxels, VolumeEvents& events) : voxels_{voxels.data()}, events_{events} {
    events_.coded = events_.surprises = events_.changes = events_.exceptions = events_.escapes = 0;
  }

  /// The materials as numbers of a byte; false where there are too many.
  bool number(const DenseVoxels& voxels) {
    if (!number_voxels(voxels, vbmi_, numbers_.data())) return false;
    // The first row's north is of the first material.
    bytes_ = WaveBytes{numbers_[0]};
    return true;
  }

  bool analyse() {
    for (int wave = 0; wave < kWaves; ++wave) {
      const NearRows rows{bytes_, equals_, wave};
      const WaveParts parts{wave};
      add_missing_rows(rows, wave);
      const PartSet mixed = whole_rows(unequal_.near(wave) | add_rows(rows, parts, wave)) & parts.all();
      unequal_.set(wave, 0);
      if (mixed == 0) {
        add_steady_wave(rows, parts, wave);
      } else {
        compare(rows, parts, mixed, wave);
        add_half<false>(parts, static_cast<std::size_t>(wave));
        add_half<true>(parts, static_cast<std::size_t>(wave));
      }
      if (is_noise(2 * static_cast<std::size_t>(wave) + 2, events_)) return false;
    }
    return true;
  }

 private:
  /// A part of which some coded voxels, `high`, are neither the first candidate nor the second.
  struct Third {
    PartVec first;
    PartVec second;
    PartBits high;
    std::size_t index;  // of the part
  };

  /// Puts the rows of a wave side by side. Gives in which parts some are not equal to those below.
  HWY_INLINE PartSet add_rows(const NearRows& rows, const WaveParts& parts, int wave) {
    const hn::CappedTag<std::uint8_t, kRowBytes> d;
    const std::uint8_t* row =
        numbers_.data() + (parts.first_row * (kChunkSize - 2) + static_cast<std::size_t>(wave)) * kRowBytes;
    PartSet unequal = 0;
    for (std::size_t y = parts.first_row; y <= parts.last_row; ++y) {
      for (std::size_t x = 0; x < kRowBytes; x += hn::MaxLanes(d)) {
        const std::size_t at = y * kRowBytes + x;
        const auto now = hn::LoadU(d, row + x);
        hn::StoreU(now, d, rows.now + at);
        const bool equal = hn::AllTrue(d, hn::Eq(now, hn::LoadU(d, rows.below + at)));
        unequal |= PartSet{equal ? 0U : 1U} << (at / kPartBytes);
      }
      row += (kChunkSize - 2) * kRowBytes;
    }
    return unequal;
  }

  /// All voxels are of one material with all around them: nothing to code.
  HWY_INLINE void add_steady_wave(const NearRows& rows, const WaveParts& parts, int wave) {
    for (std::size_t p = parts.first; p <= parts.last; ++p)
      store(bytes_of(kEqualsAll), rows.equals_now + p * kPartBytes);
    gap_ += static_cast<std::uint32_t>(parts.rows() * kChunkSize);
    for (const std::size_t batch :
         {2 * static_cast<std::size_t>(wave), 2 * static_cast<std::size_t>(wave) + 1}) {
      events_.batch[batch] = 0;
      events_.batch_escapes[batch] = 0;
    }
  }

  /// Finds contexts, symbols and exceptions of a wave's mixed parts, even and odd columns at once: all voxels
  /// are known. Without branches, which nothing could foresee; what few parts need comes after.
  HWY_INLINE void compare(const NearRows& rows, const WaveParts& parts, PartSet mixed, int wave) {
    for (std::size_t p = parts.first; p <= parts.last; ++p)
      store(bytes_of(kEqualsAll), rows.equals_now + p * kPartBytes);
    count_ = 0;
    std::size_t third_count = 0;
    any_escapes_ = any_exceptional_ = 0;
    PartSet unequal = 0;
    over_bits(mixed, [&](std::size_t p) HWY_ATTR {
      const NearPart near = near_part(rows, p);
      const std::uint8_t* const bytes = rows.now + near.at;
      const PartVec now = load(bytes);
      const PartBits inside = parts.inside(p);
      const HalfPart half = both_halves(even_half(near), odd_half(near, now, bytes, p), p);
      const PartBits steady = bits_of(half.steady);
      const PartBits differs = bits_of(hn::Ne(now, half.first)) & inside;
      const PartBits surprising = differs & ~steady;
      place_[count_] = p;
      coded_[count_] = inside & ~steady;
      exceptional_[count_] = differs & steady;
      any_exceptional_ |= differs & steady;
      store(half.context, contexts_.data() + count_ * kPartBytes);
      events_.surprises += static_cast<std::size_t>(std::popcount(surprising));
      const PartVec second = hn::IfThenElse(half.alike, first_different(rows, near), half.second);
      const PartBits high = surprising & bits_of(hn::Ne(now, second));
      store(or_where(hn::IfThenElseZero(mask_of(surprising ^ high), bytes_of(1)), mask_of(high), 2),
            symbols_.data() + count_ * kPartBytes);
      escapes_[count_] = 0;
      thirds_[third_count] = {half.first, second, high, count_};
      third_count += high != 0 ? 1 : 0;
      ++count_;
      PartBits not_west = 0;
      const PartBits found = find_equals(rows, near, now, p, wave, not_west);
      unequal |= PartSet{(found & inside) != 0 ? 1U : 0U} << p;
      events_.changes += static_cast<std::size_t>(std::popcount(not_west & inside));
    });
    unequal_.set(wave, unequal);
    for (std::size_t i = 0; i < third_count; ++i) find_escapes(rows, thirds_[i]);
  }

  /// Even columns of one, odd ones of the other.
  static HWY_INLINE HalfPart both_halves(const HalfPart& even, const HalfPart& odd, std::size_t part) {
    const PartMask is_odd = columns<IsOddColumn>(part);
    const auto either = [&](PartMask of_odd, PartMask of_even)
                            HWY_ATTR { return hn::Or(hn::And(is_odd, of_odd), hn::AndNot(is_odd, of_even)); };
    return {hn::IfThenElse(is_odd, odd.first, even.first), hn::IfThenElse(is_odd, odd.second, even.second),
            either(odd.alike, even.alike), either(odd.steady, even.steady),
            hn::IfThenElse(is_odd, odd.context, even.context)};
  }

  /// Which voxels are none of their candidates, of those that are neither the first nor the second.
  HWY_INLINE void find_escapes(const NearRows& rows, const Third& third) {
    const std::size_t part = place_[third.index];
    const NearPart near = near_part(rows, part);
    PartMask exists;
    const PartVec candidate = third_candidate(rows, near, third.first, third.second, part, exists);
    const PartVec now = load(rows.now + near.at);
    const PartBits escapes = third.high & ~bits_of(hn::And(exists, hn::Eq(now, candidate)));
    std::uint8_t* const symbols = symbols_.data() + third.index * kPartBytes;
    store(or_where(load(symbols), mask_of(escapes), 1), symbols);
    escapes_[third.index] = escapes;
    any_escapes_ |= escapes;
  }

  /// Adds what was found in a wave's even columns, or in its odd ones, as a batch.
  template <bool odd>
  HWY_INLINE void add_half(const WaveParts& parts, std::size_t wave) {
    constexpr PartBits kColumns = odd ? kOddBits : kEvenBits;
    const std::size_t batch = 2 * wave + (odd ? 1 : 0);
    const std::size_t size =
        pack_coded<odd>(contexts_.data(), symbols_.data(), coded_.data(), count_, vbmi_,
                        events_.context.data() + events_.coded, events_.symbol.data() + events_.coded);
    const auto steady = static_cast<std::uint32_t>(parts.rows() * kChunkSize / 2 - size);
    if (HWY_LIKELY((any_exceptional_ & kColumns) == 0)) {
      gap_ += steady;
    } else {
      add_exceptions(parts, kColumns, batch);
    }
    const std::size_t escapes = events_.escapes;
    if ((any_escapes_ & kColumns) != 0) {
      for (std::size_t i = 0; i < count_; ++i) {
        over_bits(escapes_[i] & kColumns, [&](std::size_t voxel) HWY_ATTR {
          events_.escape[events_.escapes++] = material(i, voxel, wave);
        });
      }
    }
    events_.coded += size;
    events_.batch[batch] = static_cast<std::uint16_t>(size);
    events_.batch_escapes[batch] = static_cast<std::uint16_t>(events_.escapes - escapes);
  }

  /// The material of a voxel of part i.
  [[nodiscard]] MaterialId material(std::size_t i, std::size_t voxel, std::size_t wave) const {
    const std::size_t at = place_[i] * kPartBytes + voxel;
    const std::size_t y = at / kRowBytes;
    return voxels_[(y * (kChunkSize - 2) + wave) * kChunkSize + at % kRowBytes];
  }

  HWY_INLINE void add_exceptions(const WaveParts& parts, PartBits columns, std::size_t batch) {
    // Parts that are not mixed have steady voxels only.
    std::size_t next = parts.first;
    const auto pass = [&](std::size_t end) HWY_ATTR {
      for (; next < end; ++next)
        gap_ += static_cast<std::uint32_t>(std::popcount(columns & parts.inside(next)));
    };
    for (std::size_t i = 0; i < count_; ++i) {
      pass(place_[i]);
      ++next;
      const PartBits steady = columns & parts.inside(place_[i]) & ~coded_[i];
      std::uint32_t passed = 0;
      over_bits(exceptional_[i] & columns, [&](std::size_t x) HWY_ATTR {
        const auto before = static_cast<std::uint32_t>(std::popcount(steady & ((PartBits{1} << x) - 1)));
        events_.exception[events_.exceptions++] = {static_cast<std::uint16_t>(gap_ + before - passed),
                                                   static_cast<std::uint16_t>(batch),
                                                   material(i, x, batch / 2)};
        gap_ = 0;
        passed = before + 1;
      });
      gap_ += static_cast<std::uint32_t>(std::popcount(steady)) - passed;
    }
    pass(parts.last + 1);
  }

  const MaterialId* voxels_;
  VolumeEvents& events_;
  const VolumeVbmi* const vbmi_ = volume_vbmi();
  alignas(64) std::array<std::uint8_t, kChunkVolume> numbers_;
  WaveBytes bytes_{0};
  WaveBytes equals_{kEqualsAll};
  UnequalParts unequal_;
  // Of the mixed parts of a wave:
  std::size_t count_ = 0;
  std::array<std::size_t, kMaxParts> place_;
  alignas(64) std::array<std::uint8_t, kMaxParts * kPartBytes> contexts_;
  alignas(64) std::array<std::uint8_t, kMaxParts * kPartBytes> symbols_;
  std::array<PartBits, kMaxParts> coded_;
  std::array<PartBits, kMaxParts> escapes_;      // coded voxels that are none of their candidates
  std::array<PartBits, kMaxParts> exceptional_;  // steady ones that are not the first
  std::array<Third, kMaxParts + 1> thirds_;
  // Of all parts together:
  PartBits any_escapes_ = 0;
  PartBits any_exceptional_ = 0;
  std::uint32_t gap_ = 0;
};

bool analyse(const DenseVoxels& voxels, VolumeEvents& events) {
  Analyser analyser{voxels, events};
  return analyser.number(voxels) ? analyser.analyse() : analyse_volume_scalar(voxels, events);
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

#if HWY_TARGET == HWY_AVX3
  /// Up to sixteen symbols, with intervals of less than 256.
  HWY_INLINE void put(const std::uint8_t* starts, const std::uint8_t* sizes, std::size_t count) {
    const Half d;
    const auto active = static_cast<__mmask16>((1U << count) - 1);
    WordParts start;
    WordParts size;
    start.part[0] = WordVec{_mm256_maskz_cvtepu8_epi16(active, hn::LoadU(d, starts).raw)};
    size.part[0] = WordVec{
        _mm256_mask_cvtepu8_epi16(_mm256_set1_epi16(kProbabilityTotal), active, hn::LoadU(d, sizes).raw)};
    encode_symbols(states_, start, size, next_);
  }
#endif

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

void write(const VolumeEvents& events, const EventBatches& batches, const VolumeSymbols& symbols,
           RansSink& sink) {
  SymbolWriter writer{sink};
  std::size_t first = batches.first_coded + batches.coded;
#if HWY_TARGET == HWY_AVX3
  const VolumeVbmi* const vbmi = volume_vbmi();
  alignas(64) std::array<std::uint8_t, kMaxBatch> starts;
  alignas(64) std::array<std::uint8_t, kMaxBatch> sizes;
#endif
  for (std::size_t batch = batches.end; batch-- > batches.begin;) {
    const std::size_t count = events.batch[batch];
    first -= count;
    const std::uint8_t* const contexts = events.context.data() + first;
    const std::uint8_t* const coded = events.symbol.data() + first;
    const std::size_t first_context = first_context_of(batch);
#if HWY_TARGET == HWY_AVX3
    if (HWY_LIKELY(vbmi != nullptr)) {
      vbmi->intervals(symbols.ends.data() + first_context, first_context != 0, contexts, coded, count,
                      starts.data(), sizes.data());
      over_groups(count, [&](std::size_t at, std::size_t size)
                             HWY_ATTR { writer.put(starts.data() + at, sizes.data() + at, size); });
      continue;
    }
#endif
    over_groups(count, [&](std::size_t at, std::size_t size) HWY_ATTR {
      writer.put_voxels(contexts + at, coded + at, size, symbols.interval.data() + 4 * first_context);
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
