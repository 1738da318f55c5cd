// Numbers that many threads add to and one reads now and then: no locks, nothing waits.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace talus::server {

/// Threads add in stripes apart, as a line of memory that cores take from each other costs more than the
/// addition.
inline constexpr std::size_t kStripes = 4;
inline constexpr std::size_t kStripeBytes = 64;
/// This thread's; threads take them in turn.
[[nodiscard]] std::size_t stripe();

/// A total that only grows.
class Counter {
 public:
  void add(std::uint64_t more = 1) { stripes_[stripe()].total.fetch_add(more, std::memory_order_relaxed); }
  [[nodiscard]] std::uint64_t total() const;

 private:
  struct alignas(kStripeBytes) Stripe {
    std::atomic<std::uint64_t> total{0};
  };
  std::array<Stripe, kStripes> stripes_;
};

/// How many there are now.
class Level {
 public:
  void rise() { now_.fetch_add(1, std::memory_order_relaxed); }
  void fall() { now_.fetch_sub(1, std::memory_order_relaxed); }
  [[nodiscard]] std::int64_t now() const { return now_.load(std::memory_order_relaxed); }

 private:
  std::atomic<std::int64_t> now_{0};
};

/// How many things took how long, in buckets three to a decade.
class LatencyTally {
 public:
  /// Inclusive upper bounds; what is longer than the last counts beyond all of them.
  static constexpr std::array<double, 19> kBoundsSeconds{1e-5, 2e-5, 5e-5, 1e-4, 2e-4, 5e-4, 1e-3,
                                                         2e-3, 5e-3, 0.01, 0.02, 0.05, 0.1,  0.2,
                                                         0.5,  1.0,  2.0,  5.0,  10.0};

  /// `things` that took so long each.
  void add(std::chrono::nanoseconds time, std::uint64_t things = 1);

  struct Reading {
    std::array<std::uint64_t, kBoundsSeconds.size() + 1> counts{};  // of each bucket alone
    double sum_seconds = 0;
  };
  [[nodiscard]] Reading read() const;

 private:
  struct alignas(kStripeBytes) Stripe {
    std::array<std::atomic<std::uint64_t>, kBoundsSeconds.size() + 1> counts{};
    std::atomic<std::uint64_t> sum_ns{0};
  };
  std::array<Stripe, kStripes> stripes_;
};

}  // namespace talus::server
