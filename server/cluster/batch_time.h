// Determines the time of a batch, on which all servers must agree. The publisher states it by a clock that
// may be wrong; the stream records when its leader took each message. A batch stated more than a minute after
// the last time compared with the leader's clock is compared with it: anything beyond a minute after the
// leader's time is ignored. So a wrong clock, or a lie, advances the world's time by at most a minute, the
// stream is asked once a minute while edits flow, and every reader of the stream computes the same times.
// Pure.
#pragma once

#include <algorithm>
#include <cstdint>

namespace talus::server::cluster {

/// Upper bound for the difference between correct clocks.
inline constexpr std::int64_t kClocksDifferMs = 60'000;

/// True if the stream must be asked when it took a batch stated at `said_ms`. `asked_ms` is StreamPlace's.
[[nodiscard]] constexpr bool must_ask_stream(std::int64_t said_ms, std::int64_t asked_ms) {
  return said_ms > asked_ms && said_ms - asked_ms > kClocksDifferMs;
}

/// Effective time of a batch that the stream took at `stream_ms`.
[[nodiscard]] constexpr std::int64_t bounded_time(std::int64_t said_ms, std::int64_t stream_ms) {
  return std::min(said_ms,
                  std::clamp<std::int64_t>(stream_ms, 0, INT64_MAX - kClocksDifferMs) + kClocksDifferMs);
}

}  // namespace talus::server::cluster
