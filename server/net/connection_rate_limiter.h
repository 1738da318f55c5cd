// How many connections an address may begin in a time: with TLS each costs the server a signature. Callable
// from any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

#include <asio/ip/address.hpp>

#include "runtime/clock.h"

namespace talus::server {

/// GCRA, the generic cell rate algorithm: a token bucket kept as one number, the theoretical arrival time,
/// which each connection moves on by one interval and which may lie at most a burst ahead of now.
///
/// One such number for each address, as counted_as() counts it, in a table of fixed size: a set of a few
/// entries for all addresses that share a hash. One address more replaces the entry whose time is earliest,
/// and begins with a full bucket. So many addresses can have debts forgotten, and none can have another one
/// refused.
class ConnectionRateLimiter {
 public:
  /// Both at least 1. `seed` keeps others from choosing addresses that share a hash.
  ConnectionRateLimiter(std::uint64_t per_second, std::uint64_t burst, std::uint64_t seed);

  /// What addresses owe stays.
  void change(std::uint64_t per_second, std::uint64_t burst);

  /// Counts a connection and returns 0, or returns how long it takes until one is allowed.
  [[nodiscard]] Clock::duration admit(const asio::ip::address& address, Clock::time_point now);

  static constexpr std::size_t kSets = 4096;
  static constexpr std::size_t kEntriesPerSet = 4;  // 384 KiB in all

 private:
  struct Entry {
    std::array<std::uint64_t, 2> address{};
    Clock::time_point theoretical_arrival{};
  };

  const std::uint64_t seed_;
  std::mutex mutex_;
  Clock::duration interval_;
  Clock::duration burst_;
  std::vector<Entry> entries_;
};

}  // namespace talus::server
