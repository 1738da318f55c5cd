// The decoder of an adaptive binary range coder. FORMAT.md, "Version 3: palette", gives the arithmetic in
// full.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <talus/voxel/codec.h>

namespace talus::codec {

/// How likely a bit is 0, learned at two speeds: the fast estimate follows changes, the slow one is exact.
/// A young model takes larger steps, because a chunk gives most models few bits to learn from.
class BitModel {
 public:
  static constexpr int kBits = 12;

  /// Of 2^kBits; never so near either end that a bit becomes impossible.
  [[nodiscard]] std::uint32_t zero() const { return (std::uint32_t{fast_} + slow_) >> 5; }

  void learn(bool bit) {
    const auto [slow_shift, fast_shift] = kShifts[age_];
    age_ = static_cast<std::uint16_t>(age_ + (age_ < kOldAge ? 1 : 0));
    if (bit) {
      fast_ = static_cast<std::uint16_t>(fast_ - (fast_ >> fast_shift));
      slow_ = static_cast<std::uint16_t>(slow_ - (slow_ >> slow_shift));
    } else {
      fast_ = static_cast<std::uint16_t>(fast_ + ((0x10000 - fast_) >> fast_shift));
      slow_ = static_cast<std::uint16_t>(slow_ + ((0x10000 - slow_) >> slow_shift));
    }
  }

 private:
  struct Shifts {
    std::uint8_t slow;
    std::uint8_t fast;
  };
  static constexpr std::uint16_t kOldAge = 31;
  // By age. A table, because this is the hottest loop.
  static constexpr auto kShifts = [] {
    std::array<Shifts, kOldAge + 1> shifts{};
    for (unsigned age = 0; age <= kOldAge; ++age) {
      const auto slow = static_cast<std::uint8_t>(std::bit_width(age + 1));  // of its binary digits
      shifts[age] = {slow, std::min<std::uint8_t>(slow, 4)};
    }
    return shifts;
  }();

  std::uint16_t fast_ = 0x8000;
  std::uint16_t slow_ = 0x8000;
  std::uint16_t age_ = 0;
};

inline constexpr std::uint32_t kMinRange = 1U << 24;

class RangeDecoder {
 public:
  explicit RangeDecoder(std::span<const std::byte> bytes) : bytes_{bytes} {
    for (int i = 0; i < 4; ++i) get();
    possible_ = code_ < range_;
  }

  [[gnu::always_inline]] bool read(BitModel& model) {
    const std::uint32_t bound = (range_ >> BitModel::kBits) * model.zero();
    const bool bit = code_ >= bound;
    if (bit) {
      code_ -= bound;
      range_ -= bound;
    } else {
      range_ = bound;
    }
    model.learn(bit);
    while (range_ < kMinRange) {
      get();
      range_ <<= 8;
    }
    return bit;
  }

  /// More was asked for than the bytes hold: what is decoded from here on means nothing.
  [[nodiscard]] bool starved() const { return next_ > bytes_.size() + 2; }

  /// What is wrong with the bytes as a whole, once all bits are read.
  [[nodiscard]] std::optional<DecodeError> fault() const {
    if (starved()) return DecodeError::truncated;
    if (next_ < bytes_.size() + 2) return DecodeError::too_long;
    if (!possible_ || code_ > 0xFFFF) return DecodeError::bad_ending;
    return std::nullopt;
  }

 private:
  void get() {
    const std::uint32_t byte = next_ < bytes_.size() ? std::to_integer<std::uint32_t>(bytes_[next_]) : 0U;
    ++next_;
    code_ = (code_ << 8) | byte;
  }

  std::span<const std::byte> bytes_;
  std::size_t next_ = 0;
  std::uint32_t code_ = 0;
  std::uint32_t range_ = 0xFFFFFFFF;
  bool possible_ = true;  // no encoder begins with four bytes of 255
};

}  // namespace talus::codec
