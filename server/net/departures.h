// Sends players to other servers: all of them, one after the other, when this server ends, and some while it
// has more than its share of a balancer's sessions. A player sent away reconnects within a second, so sending
// all at once would cause a stampede.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>

#include "limits/rates/token_bucket.h"
#include "net/port_range.h"
#include "net/registry.h"
#include "runtime/clock.h"

namespace talus::server {

struct BalanceSettings {
  std::uint64_t per_second = 0;             // sessions sent elsewhere; 0: off
  std::uint64_t above_percent = 0;          // excess over its share that a server may keep
  std::chrono::milliseconds session_age{};  // younger sessions are not sent away
};

/// Call on the thread of `io`.
class Departures {
 public:
  /// The arguments outlive it.
  Departures(asio::io_context& io, Registry& registry, const Clock& clock);

  /// Sends all sessions away, evenly spread over `time`, then any that still arrive; HTTP connections at
  /// once.
  void send_all(std::chrono::milliseconds time);

  /// Handles a balancer's state of the sessions that arrived through its `ports` (all if empty). Sends the
  /// excess elsewhere, the longest connected first, within settings.per_second and except sessions younger
  /// than settings.session_age. Returns the number sent.
  std::size_t balancer_says(std::string_view state, const BalanceSettings& settings,
                            std::optional<PortRange> ports = {});

 private:
  void send_some();

  Registry& registry_;
  const Clock& clock_;
  asio::steady_timer timer_;
  Clock::time_point end_{};  // end of send_all()
  TokenBucket sent_;
};

}  // namespace talus::server
