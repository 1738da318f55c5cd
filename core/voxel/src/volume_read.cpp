#include "volume_kernels.h"

#include <algorithm>

#include "volume_read.h"
#include "volume_scalar.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "volume_read.cpp"
#include <talus/vectors/tables.h>

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

VolumeFault read(VolumeSource& source, const VolumeCode& code, PaddedVoxels& padded) {
  return read_volume_scalar(source, code, padded);
}

void read_slots(VolumeSource& source, const SlotTable& slots, std::size_t count, std::uint8_t* kinds) {
  read_slots_scalar(source, slots, count, kinds);
}

#else

/// Contexts of a batch, then its symbols as two bit strings.
class Batch {
 public:
  /// Room for the contexts and one part more.
  [[nodiscard]] std::uint8_t* contexts() { return contexts_.data(); }
  void set_size(std::size_t size) { size_ = size; }
  [[nodiscard]] std::size_t size() const { return size_; }

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
      // Assembled in registers: later reads span several of these.
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
    std::uint32_t low;
    std::uint32_t high;
  };
  /// Symbols of the next `count` voxels, at most 32.
  HWY_INLINE Symbols take(std::size_t count) {
    const auto mask = static_cast<std::uint32_t>((std::uint64_t{1} << count) - 1);
    const Symbols symbols{bits_at(low_) & mask, bits_at(high_) & mask};
    next_ += count;
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

  std::array<std::uint8_t, kMaxBatch + 64> contexts_;
  BitString low_;
  BitString high_;
  std::size_t size_ = 0;
  std::size_t next_ = 0;
};

class Reader {
 public:
  Reader(VolumeSource& source, const VolumeCode& code, DenseVoxels& voxels)
      : source_{source},
        code_{code},
        voxels_{voxels.data()},
        exceptions_{code, source},
        row_writer_{code.materials} {}

  VolumeFault read() {
    for (int wave = 0; wave < kWaves; ++wave) {
      const NearRows rows{bytes_, equals_, wave};
      const WaveParts parts{wave};
      add_missing_rows(rows, wave);
      const auto voxels = static_cast<std::uint32_t>(parts.rows() * kChunkSize);
      const bool has_exception = exceptions_.gap() < voxels;
      const PartSet mixed = (has_exception ? parts.all() : whole_rows(unequal_.near(wave))) & parts.all();
      repeat_rows(rows, parts);
      unequal_.set(wave, 0);
      if (mixed == 0) {
        exceptions_.pass(voxels);
      } else if (!read_parts(rows, parts, mixed, wave)) {
        return source_.next > source_.end ? VolumeFault::truncated : VolumeFault::bad_number;
      }
      write_rows(rows, parts, wave);
    }
    return exceptions_.all_taken() ? VolumeFault::none : VolumeFault::bad_number;
  }

 private:
  /// Makes all voxels of a wave equal to their neighbours, as in parts that are not mixed.
  HWY_INLINE void repeat_rows(const NearRows& rows, const WaveParts& parts) {
    for (std::size_t p = parts.first; p <= parts.last; ++p) {
      store(load(rows.below + p * kPartBytes), rows.now + p * kPartBytes);
      store(bytes_of(kEqualsAll), rows.equals_now + p * kPartBytes);
    }
  }

  HWY_INLINE void write_rows(const NearRows& rows, const WaveParts& parts, int wave) {
    std::size_t row = parts.first_row * (kChunkSize - 2) + static_cast<std::size_t>(wave);
    for (std::size_t y = parts.first_row; y <= parts.last_row; ++y) {
      row_writer_.write(rows.now + y * kRowBytes, voxels_ + row * kChunkSize);
      row += kChunkSize - 2;
    }
  }

  HWY_INLINE bool read_parts(const NearRows& rows, const WaveParts& parts, PartSet mixed, int wave) {
    std::size_t count = 0;
    over_bits(mixed, [&](std::size_t p) HWY_ATTR {
      place_[count] = p;
      const NearPart near = near_part(rows, p);
      store(near.base, rows.now + near.at);
      begin(count, even_half(near), kEvenBits & parts.inside(p));
      near_[count] = near;
      ++count;
    });
    count_ = count;
    if (!read_half<false>(rows, parts)) return false;
    for (std::size_t i = 0; i < count; ++i) {
      std::uint8_t* const bytes = rows.now + near_[i].at;
      const PartVec now = load(bytes);
      const HalfPart half = odd_half(near_[i], now, bytes, place_[i]);
      store(hn::IfThenElse(columns<IsOddColumn>(place_[i]), half.first, now), bytes);
      begin(i, half, kOddBits & parts.inside(place_[i]));
    }
    if (!read_half<true>(rows, parts)) return false;
    PartSet unequal = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t p = place_[i];
      const PartBits found = find_equals(rows, near_[i], load(rows.now + near_[i].at), p, wave);
      unequal |= PartSet{(found & parts.inside(p)) != 0 ? 1U : 0U} << p;
    }
    unequal_.set(wave, unequal);
    return true;
  }

  HWY_INLINE void begin(std::size_t i, const HalfPart& half, PartBits inside) {
    coded_[i] = bits_of(hn::Not(half.steady)) & inside;
    store(half.context, contexts_.data() + i * kPartBytes);
    second_[i] = half.second;
    alike_[i] = half.alike;
  }

  /// Decodes the symbols of half the columns and assigns their voxels' materials. Returns false after a
  /// fault.
  template <bool odd>
  HWY_INLINE bool read_half(const NearRows& rows, const WaveParts& parts) {
    batch_.set_size(pack_coded<odd>(contexts_.data(), coded_.data(), count_, vbmi_, batch_.contexts()));
    const auto steady = static_cast<std::uint32_t>(parts.rows() * kChunkSize / 2 - batch_.size());
    if (HWY_LIKELY(exceptions_.gap() >= steady)) {
      exceptions_.pass(steady);
    } else {
      take_exceptions(rows, parts, odd ? kOddBits : kEvenBits);
    }
    source_.keep_ahead();
    batch_.decode(source_, code_.intervals->data() + (odd ? kOddContexts : 0));
    // The parts with symbols other than 0 are unpredictable: if there are any, all parts are finished.
    std::uint32_t surprising = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      symbols_[i] = batch_.take(static_cast<std::size_t>(std::popcount(coded_[i])));
      surprising |= symbols_[i].low | symbols_[i].high;
    }
    if (surprising != 0) {
      for (std::size_t i = 0; i < count_; ++i) finish(rows, i);
    }
    for (std::size_t i = 0; i < escapes_; ++i)
      *escaped_[i] = decode_kind(source_, i % kLanes, code_.materials);
    escapes_ = 0;
    return source_.next <= source_.end && !bad_number_;
  }

  /// Assigns the exceptions among the steady voxels. All parts of the wave are mixed.
  HWY_INLINE void take_exceptions(const NearRows& rows, const WaveParts& parts, PartBits half) {
    // In a register: the compiler must assume that the voxels written in between alias it.
    std::uint32_t gap = exceptions_.gap();
    for (std::size_t i = 0; i < count_; ++i) {
      PartBits steady = half & parts.inside(place_[i]) & ~coded_[i];
      auto count = static_cast<std::uint32_t>(std::popcount(steady));
      while (gap < count) {
        const auto x = static_cast<std::size_t>(std::countr_zero(deposit_bits(PartBits{1} << gap, steady)));
        rows.now[near_[i].at + x] = exceptions_.take(source_);
        gap = exceptions_.gap();
        steady &= ~((PartBits{2} << x) - 1);
        count = static_cast<std::uint32_t>(std::popcount(steady));
      }
      gap -= count;
    }
    exceptions_.pass(exceptions_.gap() - gap);
  }

  HWY_INLINE void finish(const NearRows& rows, std::size_t i) {
    const NearPart& near = near_[i];
    std::uint8_t* const bytes = rows.now + near.at;
    const PartBits low = deposit_bits(symbols_[i].low, coded_[i]);
    const PartBits high = deposit_bits(symbols_[i].high, coded_[i]);
    const PartVec now = load(bytes);  // first candidates
    const PartVec second = hn::IfThenElse(alike_[i], first_different(rows, near), second_[i]);
    PartVec found = hn::IfThenElse(mask_of(low & ~high), second, now);
    const PartBits is_third = high & ~low;
    if (is_third != 0) {
      PartMask exists;
      const PartVec third = third_candidate(rows, near, now, second, place_[i], exists);
      found = hn::IfThenElse(mask_of(is_third), third, found);
      bad_number_ |= (is_third & ~bits_of(exists)) != 0;
    }
    store(found, bytes);
    for (PartBits left = high & low; left != 0; left &= left - 1) {
      escaped_[escapes_++] = bytes + std::countr_zero(left);
    }
  }

  VolumeSource& source_;
  const VolumeCode& code_;
  MaterialId* voxels_;
  ExceptionReader exceptions_;
  const VolumeVbmi* const vbmi_ = volume_vbmi();
  RowWriter row_writer_;
  WaveBytes bytes_{0};  // numbers of materials; the first is north of the first row
  WaveBytes equals_{kEqualsAll};
  UnequalParts unequal_;
  // State of the mixed parts of a wave:
  std::array<NearPart, kMaxParts> near_;
  std::array<PartVec, kMaxParts> second_;
  std::array<PartMask, kMaxParts> alike_;
  std::array<std::size_t, kMaxParts> place_;
  std::array<Batch::Symbols, kMaxParts> symbols_;
  std::size_t count_ = 0;
  alignas(64) std::array<std::uint8_t, kMaxParts * kPartBytes> contexts_;
  std::array<PartBits, kMaxParts> coded_;
  Batch batch_;
  std::array<std::uint8_t*, kMaxBatch> escaped_;
  std::size_t escapes_ = 0;
  bool bad_number_ = false;
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
