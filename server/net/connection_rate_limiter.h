// Limits the rate at which an address opens connections: with TLS each costs the server a signature. Callable
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

/// GCRA, the generic cell rate algorithm: a token bucket kept as one number, the theoretical arrival time.
/// Each connection advances it by one interval; it may be at most one burst ahead of now.
///
/// The numbers are in a table of fixed size, one for each address as counted_as() counts it. Addresses that
/// share a hash share a set of a few entries. A new address replaces the entry of its set with the earliest
/// time and starts with a full bucket. So a flood of addresses can erase the debts of others, but cannot get
/// their connections refused.
class ConnectionRateLimiter {
 public:
  /// Both at least 1. `seed` prevents clients from choosing addresses that share a hash.
  ConnectionRateLimiter(std::uint64_t per_second, std::uint64_t burst, std::uint64_t seed);

  /// Addresses keep their debts.
  void change(std::uint64_t per_second, std::uint64_t burst);

  /// Counts a connection and returns 0, or returns the time until one is allowed.
  [[nodiscard]] Clock::duration admit(const asio::ip::address& address, Clock::time_point now);

  static constexpr std::size_t kSets = 4096;
  static constexpr std::size_t kEntriesPerSet = 4;  // 384 KiB in total

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
