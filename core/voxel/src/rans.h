// An entropy coder with fixed odds, two states that take turns: FORMAT.md, "The coder of planes".
//
// The writer goes backwards through what the reader will find, last symbol first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <talus/voxel/codec.h>

namespace talus::codec {

inline constexpr int kOddsBits = 12;
inline constexpr std::uint32_t kOddsTotal = 1U << kOddsBits;
inline constexpr std::uint32_t kLeastState = 1U << 16;  // a state holds 16 to 24 bits
inline constexpr int kStateBytes = 3;

/// A symbol's share of kOddsTotal, from `start` on, as its writer needs it.
struct Share {
  constexpr Share() = default;
  constexpr Share(std::uint32_t first, std::uint32_t end)
      : reciprocal{((std::uint64_t{1} << kShift) + (end - first) - 1) / (end - first)},
        limit{(end - first) << kOddsBits},
        rest{static_cast<std::uint16_t>(kOddsTotal - (end - first))},
        start{static_cast<std::uint16_t>(first)} {}

  static constexpr int kShift = 24 + kOddsBits;
  /// state * reciprocal >> kShift is state / size, exact for states below 2^24: the product with what the
  /// reciprocal was rounded by stays below 2^kShift / kOddsTotal.
  std::uint64_t reciprocal = 0;
  std::uint32_t limit = 0;  // of states that take the symbol without growing past 24 bits
  std::uint16_t rest = 0;   // kOddsTotal - size
  std::uint16_t start = 0;
};

/// Writes backwards, from the end of its buffer.
class RansWriter {
 public:
  /// `buffer` must hold all that is written: two bytes a symbol at most, and six at the end.
  explicit RansWriter(std::span<std::byte> buffer) : next_{buffer.data() + buffer.size()} {}

  [[gnu::always_inline]] void put(std::uint32_t& state, const Share& share) {
    while (state >= share.limit) [[unlikely]] {
        *--next_ = static_cast<std::byte>(state & 0xFF);
        state >>= 8;
      }
    const auto quotient = static_cast<std::uint32_t>((state * share.reciprocal) >> Share::kShift);
    state += quotient * share.rest + share.start;
  }

  /// Returns where the written bytes begin.
  [[nodiscard]] const std::byte* finish() {
    for (const std::uint32_t state : {odd, even}) {
      for (int byte = 0; byte < kStateBytes; ++byte) {
        *--next_ = static_cast<std::byte>((state >> (8 * byte)) & 0xFF);
      }
    }
    return next_;
  }

  [[nodiscard]] const std::byte* next() const { return next_; }

  std::uint32_t even = kLeastState;
  std::uint32_t odd = kLeastState;

 private:
  std::byte* next_;
};

class RansReader {
 public:
  explicit RansReader(std::span<const std::byte> bytes)
      : next_{bytes.data()}, end_{bytes.data() + bytes.size()} {
    for (std::uint32_t* const state : {&even, &odd}) {
      for (int byte = 0; byte < kStateBytes; ++byte) *state = (*state << 8) | take();
    }
  }

  /// To be asked before the first symbol is read.
  [[nodiscard]] std::optional<DecodeError> fault_of_beginning() const {
    if (starved_) return DecodeError::truncated;
    if (even < kLeastState || odd < kLeastState) return DecodeError::bad_ending;  // no writer's states
    return std::nullopt;
  }

  /// Where in 0 to kOddsTotal - 1 the next symbol of a state lies.
  [[nodiscard]] static std::uint32_t place(std::uint32_t state) { return state & (kOddsTotal - 1); }

  /// Takes the symbol of that place, whose share is `start` to `start + size`.
  [[gnu::always_inline]] void took(std::uint32_t& state, std::uint32_t start, std::uint32_t size) {
    state = size * (state >> kOddsBits) + place(state) - start;
    while (state < kLeastState) [[unlikely]] state = (state << 8) | take();
  }

  /// More was asked for than the bytes hold: what is read from here on means nothing.
  [[nodiscard]] bool starved() const { return starved_; }

  /// What is wrong with the bytes as a whole, once all symbols are read.
  [[nodiscard]] std::optional<DecodeError> fault() const {
    if (starved_) return DecodeError::truncated;
    if (next_ != end_) return DecodeError::too_long;
    if (even != kLeastState || odd != kLeastState) return DecodeError::bad_ending;
    return std::nullopt;
  }

  std::uint32_t even = 0;
  std::uint32_t odd = 0;

 private:
  std::uint32_t take() {
    if (next_ != end_) return std::to_integer<std::uint32_t>(*next_++);
    starved_ = true;
    return 0xFF;  // any but 0, with which a state might never grow
  }

  const std::byte* next_;
  const std::byte* end_;
  bool starved_ = false;
};

}  // namespace talus::codec
