// Sends players to other servers: all of them when this one ends, one after the other, and some while it has
// more than its share of those that a balancer deals out. Who is told to go comes again somewhere within a
// second: all at once would be a herd.
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
  std::uint64_t per_second = 0;             // sessions that are sent elsewhere; 0: none
  std::uint64_t above_percent = 0;          // of its share, by which a server may have more
  std::chrono::milliseconds session_age{};  // none that is younger is sent
};

/// On the thread of `io`.
class Departures {
 public:
  /// All of them outlive it.
  Departures(asio::io_context& io, Registry& registry, const Clock& clock);

  /// All sessions, evenly within `time`, and then who still comes; HTTP connections at once.
  void send_all(std::chrono::milliseconds time);

  /// A balancer has said this of the sessions that came by its `ports`, of all where none are given. Returns
  /// how many of them were sent elsewhere: as many as are too many, the longest connected first, unless that
  /// would be too fast, or they have not been here for long.
  std::size_t balancer_says(std::string_view state, const BalanceSettings& settings,
                            std::optional<PortRange> ports = {});

 private:
  void send_some();

  Registry& registry_;
  const Clock& clock_;
  asio::steady_timer timer_;
  Clock::time_point end_{};  // of send_all()
  TokenBucket sent_;
};

}  // namespace talus::server
