// How often an address may begin a connection: with TLS each costs the server a signature. Callable from any
// thread.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

#include <asio/ip/address.hpp>

namespace talus::server {

/// A token bucket for each address, as counted_as() counts it. The table does not grow: it has a few places
/// for all addresses that share a hash, and one more takes the place of the one that owes least, whose bucket
/// is then full again. Many addresses can so have debts forgotten; none can have another refused.
class HandshakeBudget {
 public:
  using Clock = std::chrono::steady_clock;

  /// Both at least 1. `seed` keeps others from choosing addresses that share a hash.
  HandshakeBudget(std::uint64_t per_second, std::uint64_t burst, std::uint64_t seed);

  /// Takes a token and returns 0, or how long it takes until there is one.
  [[nodiscard]] Clock::duration take(const asio::ip::address& address, Clock::time_point now);

  static constexpr std::size_t kSets = 4096;
  static constexpr std::size_t kPlaces = 4;  // of each set; 384 KiB in all

 private:
  /// A bucket as one number: when it will be full. Each token taken is one interval later.
  struct Bucket {
    std::array<std::uint64_t, 2> address{};
    Clock::time_point full{};
  };

  const Clock::duration interval_;
  const Clock::duration depth_;
  const std::uint64_t seed_;
  std::mutex mutex_;
  std::vector<Bucket> buckets_;
};

}  // namespace talus::server
