// SipHash-2-4 (Aumasson and Bernstein, 2012): a keyed hash that cannot be predicted without its key. Messages
// are whole 64-bit words, read as little-endian bytes. Private to core/terrain.
#pragma once

#include <bit>
#include <cstdint>

namespace talus::terrain {

/// The state after some words: a value, so that messages with equal beginnings share them.
class SipHash {
 public:
  constexpr SipHash(std::uint64_t key_low, std::uint64_t key_high)
      : a_{key_low ^ 0x736F6D6570736575U},
        b_{key_high ^ 0x646F72616E646F6DU},
        c_{key_low ^ 0x6C7967656E657261U},
        d_{key_high ^ 0x7465646279746573U} {}

  /// Appends a word to the message.
  [[nodiscard]] constexpr SipHash with(std::uint64_t word) const {
    SipHash next = *this;
    ++next.words_;
    next.compress(word);
    return next;
  }

  /// The hash of the message so far.
  [[nodiscard]] constexpr std::uint64_t value() const {
    SipHash last = *this;
    last.compress(std::uint64_t{static_cast<std::uint8_t>(words_ * 8)} << 56U);
    last.c_ ^= 0xFF;
    for (int round = 0; round < 4; ++round) last.mix();
    return last.a_ ^ last.b_ ^ last.c_ ^ last.d_;
  }

 private:
  constexpr void compress(std::uint64_t word) {
    d_ ^= word;
    mix();
    mix();
    a_ ^= word;
  }
  constexpr void mix() {
    a_ += b_;
    b_ = std::rotl(b_, 13) ^ a_;
    a_ = std::rotl(a_, 32);
    c_ += d_;
    d_ = std::rotl(d_, 16) ^ c_;
    a_ += d_;
    d_ = std::rotl(d_, 21) ^ a_;
    c_ += b_;
    b_ = std::rotl(b_, 17) ^ c_;
    c_ = std::rotl(c_, 32);
  }

  std::uint64_t a_;
  std::uint64_t b_;
  std::uint64_t c_;
  std::uint64_t d_;
  std::uint64_t words_ = 0;
};

}  // namespace talus::terrain
