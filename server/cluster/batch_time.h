// The time of a batch, which every server must take for the same. Its publisher says it, by a clock that may
// be wrong; the stream has a clock of its own, that of its leader, and keeps by it when it took each message.
// A batch that says more than a minute over what was last compared with that clock is compared: what it says
// beyond a minute more than the stream does not count. So a wrong clock, or a lie, moves the world's time by
// a minute at most, the stream is asked once a minute while edits flow, and all who read the stream come to
// the same times, whoever reads it and when. Pure.
#pragma once

#include <algorithm>
#include <cstdint>

namespace talus::server::cluster {

/// Clocks of sound servers differ by less.
inline constexpr std::int64_t kClocksDifferMs = 60'000;

/// Whether the stream must be asked when it took a batch that says `said_ms`; `looked_ms`: the place's.
[[nodiscard]] constexpr bool must_ask_stream(std::int64_t said_ms, std::int64_t looked_ms) {
  return said_ms > looked_ms && said_ms - looked_ms > kClocksDifferMs;
}

/// What a batch's time counts as, which the stream took at `stream_ms`.
[[nodiscard]] constexpr std::int64_t bounded_time(std::int64_t said_ms, std::int64_t stream_ms) {
  return std::min(said_ms,
                  std::clamp<std::int64_t>(stream_ms, 0, INT64_MAX - kClocksDifferMs) + kClocksDifferMs);
}

}  // namespace talus::server::cluster
