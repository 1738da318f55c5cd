// Probabilities of a volume's symbols, and its exceptions, which are coded in groups: FORMAT.md, "Volume".
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include <talus/voxel/chunk.h>

#include "rans.h"
#include "volume_model.h"

namespace talus::codec {

/// Ends of the intervals of symbols 0, 1 and 2, one per byte from the lowest, by context: even columns'
/// contexts from 0, odd columns' from kOddContexts.
using VolumeIntervals = std::array<std::uint32_t, kVolumeContexts>;

[[nodiscard]] constexpr Interval interval_of(std::uint32_t ends, std::uint8_t symbol) {
  const std::uint32_t start = symbol == 0 ? 0 : ends >> (8 * (symbol - 1)) & 0xFFU;
  const std::uint32_t end = symbol == kEscape ? 256U : ends >> (8 * symbol) & 0xFFU;
  return {static_cast<std::uint16_t>(start), static_cast<std::uint16_t>(end - start)};
}

/// Symbols of up to 256 kinds, indexed by slot of the probability range (the low byte of a state).
struct SlotTable {
  std::array<std::uint32_t, kProbabilityTotal> slot{};   // kind + 256 * start + 65536 * size of its interval
  std::array<std::uint16_t, kProbabilityTotal> value{};  // by kind
};

/// Decodes the kind of a lane's next symbol.
[[nodiscard]] inline std::uint8_t decode_kind(RansSource& source, std::size_t lane, const SlotTable& slots) {
  const std::uint32_t state = source.states[lane];
  const std::uint32_t low = state % kProbabilityTotal;
  const std::uint32_t slot = slots.slot[low];
  const std::uint32_t rest = (slot >> 16U) * (state / kProbabilityTotal) + low - (slot >> 8U & 0xFFU);
  // Without a branch: whether a byte is taken is unpredictable.
  const bool takes = rest < kMinState;
  const std::uint32_t more = rest * 256 + *source.next;
  source.states[lane] = static_cast<std::uint16_t>(takes ? more : rest);
  source.next += takes ? 1 : 0;
  return static_cast<std::uint8_t>(slot & 0xFFU);
}

[[nodiscard]] inline std::uint16_t decode_slot(RansSource& source, std::size_t lane, const SlotTable& slots) {
  return slots.value[decode_kind(source, lane, slots)];
}

/// Numbers below 2^15 are coded as their number of binary digits, then the digits after the first.
inline constexpr std::size_t kDigitCounts = 16;

/// Interval sizes of a gap's digit count.
inline constexpr std::array<std::uint16_t, kDigitCounts> kGapSizes{60, 10, 11, 12, 17, 12, 13, 17,
                                                                   22, 24, 20, 15, 11, 6,  4,  2};

/// Values 0, 1, 2 and so on with intervals of these sizes, which sum to kProbabilityTotal.
template <std::size_t count>
constexpr SlotTable slots_of(const std::array<std::uint16_t, count>& sizes) {
  SlotTable slots{};
  std::uint32_t start = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    slots.value[i] = static_cast<std::uint16_t>(i);
    for (std::size_t s = 0; s < sizes[i]; ++s)
      slots.slot[start + s] = i | start << 8U | std::uint32_t{sizes[i]} << 16U;
    start += sizes[i];
  }
  return slots;
}
inline constexpr SlotTable kGapSlots = slots_of(kGapSizes);

/// Known to a decoder before the coded voxels.
struct VolumeCode {
  MaterialId first{};  // material of the row north of the first row
  const VolumeIntervals* intervals = nullptr;
  SlotTable materials;  // exceptions and escapes; values are ids
  std::size_t exceptions = 0;
};

/// Reads the digits after the first of numbers with `counts` digits: a string of bits, lowest first, padded
/// to a whole byte.
template <class Numbers>
void take_digits(RansSource& source, const std::uint8_t* counts, std::size_t count, Numbers numbers) {
  std::uint64_t bits = 0;
  unsigned available = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const unsigned wanted = counts[i] > 1 ? counts[i] - 1U : 0U;
    while (available < wanted) {
      bits |= std::uint64_t{*source.next++} << available;
      available += 8;
    }
    const auto low = static_cast<std::uint32_t>(bits & ((1U << wanted) - 1));
    numbers(i, counts[i] == 0 ? 0 : low | 1U << wanted);
    bits >>= wanted;
    available -= wanted;
  }
}

/// Inverse of take_digits(), for `count` numbers number(i), at most kLanes.
template <class Number>
void put_digits(RansSink& sink, std::size_t count, const Number& number) {
  std::array<std::uint8_t, 2 * kLanes> bytes;
  std::size_t size = 0;
  std::uint64_t bits = 0;
  unsigned held = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t value = number(i);
    const auto digits = static_cast<unsigned>(std::bit_width(value));
    if (digits < 2) continue;
    bits |= std::uint64_t{value ^ 1U << (digits - 1)} << held;
    for (held += digits - 1; held >= 8; held -= 8, bits >>= 8U)
      bytes[size++] = static_cast<std::uint8_t>(bits);
  }
  if (held > 0) bytes[size++] = static_cast<std::uint8_t>(bits);
  sink.next -= size;
  std::memcpy(sink.next, bytes.data(), size);
}

/// A source that needs no room after the payload: the last bytes are read from a copy.
class VolumeSource : public RansSource {
 public:
  /// Maximum bytes of a batch or a group, plus one vector.
  static constexpr std::size_t kAhead = 2 * 256 + 64;

  /// Makes the next kAhead bytes readable. If the payload is truncated, reading stops there.
  void keep_ahead() {
    if (!in_tail_) {
      const auto left = static_cast<std::size_t>(end - next);
      if (left >= kAhead) return;
      in_tail_ = true;
      tail_.fill(0);
      std::copy(next, end, tail_.begin());
      next = tail_.data();
      end = next + left;
    }
    next = std::min(next, end + 1);
  }

 private:
  bool in_tail_ = false;
  std::array<std::uint8_t, 2 * kAhead> tail_;
};

/// Reads the exceptions of a volume in groups of up to kLanes; the next group is read as soon as the last
/// exception of a group is used.
class ExceptionReader {
 public:
  ExceptionReader(const VolumeCode& code, VolumeSource& source) : code_{code}, left_{code.exceptions} {
    if (left_ > 0) read_group(source);
  }

  /// Number of steady voxels as predicted before the next exception.
  [[nodiscard]] std::uint32_t gap() const { return gap_; }
  void pass(std::uint32_t voxels) { gap_ -= voxels; }

  /// Material of the next exception, as its number in the list. REQUIRES: gap() == 0.
  [[nodiscard]] std::uint8_t take(VolumeSource& source) {
    const std::uint8_t material = materials_[next_];
    ++next_;
    if (next_ < size_) {
      gap_ = gaps_[next_];
    } else if (left_ > 0) {
      read_group(source);
    } else {
      gap_ = kNever;
    }
    return material;
  }

  [[nodiscard]] bool all_taken() const { return next_ == size_ && left_ == 0; }

 private:
  static constexpr std::uint32_t kNever = 1U << 30U;

  void read_group(VolumeSource& source) {
    source.keep_ahead();
    size_ = std::min(left_, kLanes);
    left_ -= size_;
    std::array<std::uint8_t, kLanes> digits;
    for (std::size_t i = 0; i < size_; ++i) {
      digits[i] = static_cast<std::uint8_t>(decode_slot(source, i, kGapSlots));
    }
    take_digits(source, digits.data(), size_, [this](std::size_t i, std::uint32_t gap) { gaps_[i] = gap; });
    for (std::size_t i = 0; i < size_; ++i) {
      materials_[i] = decode_kind(source, i, code_.materials);
    }
    next_ = 0;
    gap_ = gaps_[0];
  }

  const VolumeCode& code_;
  std::size_t left_;
  std::size_t size_ = 0;
  std::size_t next_ = 0;
  std::uint32_t gap_ = kNever;
  std::array<std::uint32_t, kLanes> gaps_{};
  std::array<std::uint8_t, kLanes> materials_{};
};

}  // namespace talus::codec
