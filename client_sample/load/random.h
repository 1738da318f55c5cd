// Seeded random numbers, the same on every machine (the standard library's distributions differ).
#pragma once

#include <cstdint>

namespace talus::load {

/// SplitMix64: eight bytes of state, so that every player can have its own.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t stream) : state_{seed * 0x9E3779B97F4A7C15U + stream} {
    (void)next();
  }

  [[nodiscard]] std::uint64_t next() {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t mixed = (state_ ^ (state_ >> 30)) * 0xBF58476D1CE4E5B9U;
    mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EBU;
    return mixed ^ (mixed >> 31);
  }
  /// 0 (inclusive) to 1 (exclusive).
  [[nodiscard]] double part() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  [[nodiscard]] double between(double low, double high) { return low + (high - low) * part(); }
  [[nodiscard]] std::uint64_t below(std::uint64_t end) { return next() % end; }

 private:
  std::uint64_t state_;
};

}  // namespace talus::load
