// The 16-way interleaved range asymmetric numeral system (rANS) of every coded part: 8-bit probabilities,
// 16-bit states, byte renormalisation. FORMAT.md, "Entropy coding".
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace talus::codec {

inline constexpr std::size_t kLanes = 16;
inline constexpr std::uint32_t kMinState = 256;
inline constexpr int kProbabilityTotal = 256;
inline constexpr std::size_t kStatesBytes = kLanes * sizeof(std::uint16_t);

/// Number of bytes that encoders may overwrite before their output.
inline constexpr std::size_t kScribbled = 8;

/// Input of a decoder. Kernels read ahead: readable bytes must follow `end`, with any contents. `next` beyond
/// `end` means that the payload is truncated.
struct RansSource {
  std::array<std::uint16_t, kLanes> states{};  // each at least kMinState
  const std::uint8_t* next = nullptr;
  const std::uint8_t* end = nullptr;
};

/// Output of an encoder, written backwards: the last symbol to be read is written first.
struct RansSink {
  std::array<std::uint16_t, kLanes> states{};
  std::uint8_t* next = nullptr;  // start of the output; kScribbled bytes before it may be overwritten too
};

/// A symbol's interval of the probability range 0 to 256.
struct Interval {
  std::uint16_t start = 0;
  std::uint16_t size = 0;  // 1 to 256
};

/// Unpacks start + 65536 * size.
[[nodiscard]] constexpr Interval unpacked(std::uint32_t interval) {
  return {static_cast<std::uint16_t>(interval & 0xFFFFU), static_cast<std::uint16_t>(interval >> 16U)};
}

/// Returns the interval, of `count`, that holds the state's low byte; `starts` has count + 1 entries, the
/// last is 256.
[[nodiscard]] inline std::size_t decode_symbol(RansSource& source, std::size_t lane, const int* starts) {
  std::uint16_t& state = source.states[lane];
  const int slot = state % kProbabilityTotal;
  std::size_t symbol = 0;
  while (starts[symbol + 1] <= slot) ++symbol;
  const int rest =
      (starts[symbol + 1] - starts[symbol]) * (state / kProbabilityTotal) + slot - starts[symbol];
  state = static_cast<std::uint16_t>(rest < int{kMinState} ? rest * 256 + *source.next++ : rest);
  return symbol;
}

inline void encode_symbol(RansSink& sink, std::size_t lane, Interval interval) {
  std::uint32_t state = sink.states[lane];
  const std::uint32_t size = interval.size;
  const bool full = state >= size * kProbabilityTotal;
  sink.next[-1] = static_cast<std::uint8_t>(state % 256);  // kept if the state is full
  sink.next -= full ? 1 : 0;
  state = full ? state / 256 : state;
  sink.states[lane] =
      static_cast<std::uint16_t>(state / size * kProbabilityTotal + state % size + interval.start);
}

/// Reads the initial states. Returns false if one is too small.
[[nodiscard]] inline bool take_states(RansSource& source) {
  for (std::uint16_t& state : source.states) {
    state = static_cast<std::uint16_t>(source.next[0] | source.next[1] << 8U);
    source.next += 2;
    if (state < kMinState) return false;
  }
  return true;
}

inline void put_states(RansSink& sink) {
  for (std::size_t lane = kLanes; lane-- > 0;) {
    *--sink.next = static_cast<std::uint8_t>(sink.states[lane] >> 8U);
    *--sink.next = static_cast<std::uint8_t>(sink.states[lane] & 0xFFU);
  }
}

}  // namespace talus::codec
