// Counters, gauges and histograms that many threads update and one reads occasionally. Lock-free; no call
// waits.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace talus::server {

/// Each thread adds to one of kStripes copies, and a read sums them up: a cache line bouncing between cores
/// costs more than the addition.
inline constexpr std::size_t kStripes = 4;
inline constexpr std::size_t kStripeBytes = 64;
/// Assigns stripes to threads in turn.
[[nodiscard]] std::size_t next_stripe();
/// The stripe of the calling thread. Inline, because every answer updates a counter.
[[nodiscard]] inline std::size_t stripe() {
  thread_local constinit std::size_t mine = kStripes;  // unassigned
  if (mine == kStripes) mine = next_stripe();
  return mine;
}

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

/// A counter for each value of a label. The counting module numbers the values from 0 by its own enum and
/// passes their names to the metrics page (MetricLabels).
class LabelledCounters {
 public:
  static constexpr std::size_t kMaxValues = 24;

  template <typename Value>
  requires std::is_enum_v<Value>
  [[nodiscard]] Counter& operator[](Value value) {
    const auto index = static_cast<std::size_t>(value);
    assert(index < kMaxValues);
    return counters_[index];
  }
  [[nodiscard]] std::uint64_t total(std::size_t value) const { return counters_[value].total(); }

 private:
  std::array<Counter, kMaxValues> counters_;
};

/// Current number of things, such as open connections.
class Gauge {
 public:
  void rise() { now_.fetch_add(1, std::memory_order_relaxed); }
  void fall() { now_.fetch_sub(1, std::memory_order_relaxed); }
  [[nodiscard]] std::int64_t now() const { return now_.load(std::memory_order_relaxed); }

 private:
  std::atomic<std::int64_t> now_{0};
};

/// Distribution of times, with three buckets per decade.
class LatencyHistogram {
 public:
  /// Inclusive upper bounds. The last bucket is unbounded.
  static constexpr std::array<double, 19> kBoundsSeconds{1e-5, 2e-5, 5e-5, 1e-4, 2e-4, 5e-4, 1e-3,
                                                         2e-3, 5e-3, 0.01, 0.02, 0.05, 0.1,  0.2,
                                                         0.5,  1.0,  2.0,  5.0,  10.0};

  /// Adds `count` samples of the same time. A negative time counts as 0.
  void add(std::chrono::nanoseconds time, std::uint64_t count = 1) {
    const auto ns = static_cast<std::uint64_t>(std::max<std::int64_t>(0, time.count()));
    const double seconds = static_cast<double>(ns) * 1e-9;
    const auto* const bound = std::lower_bound(kBoundsSeconds.begin(), kBoundsSeconds.end(), seconds);
    Stripe& mine = stripes_[stripe()];
    mine.counts[static_cast<std::size_t>(bound - kBoundsSeconds.begin())].fetch_add(
        count, std::memory_order_relaxed);
    mine.sum_ns.fetch_add(ns * count, std::memory_order_relaxed);
  }

  struct Snapshot {
    std::array<std::uint64_t, kBoundsSeconds.size() + 1> counts{};  // per bucket, not cumulative
    double sum_seconds = 0;
  };
  [[nodiscard]] Snapshot read() const;

 private:
  struct alignas(kStripeBytes) Stripe {
    std::array<std::atomic<std::uint64_t>, kBoundsSeconds.size() + 1> counts{};
    std::atomic<std::uint64_t> sum_ns{0};
  };
  std::array<Stripe, kStripes> stripes_;
};

}  // namespace talus::server
