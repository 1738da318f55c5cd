#include "metrics/instruments.h"

#include <algorithm>

namespace talus::server {

std::size_t next_stripe() {
  static std::atomic<std::size_t> threads{0};
  return threads.fetch_add(1, std::memory_order_relaxed) % kStripes;
}

std::uint64_t Counter::total() const {
  std::uint64_t sum = 0;
  for (const Stripe& each : stripes_) sum += each.total.load(std::memory_order_relaxed);
  return sum;
}

void LatencyHistogram::add(std::chrono::nanoseconds time, std::uint64_t count) {
  const auto ns = static_cast<std::uint64_t>(std::max<std::int64_t>(0, time.count()));
  const double seconds = static_cast<double>(ns) * 1e-9;
  const auto bound = std::lower_bound(kBoundsSeconds.begin(), kBoundsSeconds.end(), seconds);
  Stripe& mine = stripes_[stripe()];
  mine.counts[static_cast<std::size_t>(bound - kBoundsSeconds.begin())].fetch_add(count,
                                                                                  std::memory_order_relaxed);
  mine.sum_ns.fetch_add(ns * count, std::memory_order_relaxed);
}

LatencyHistogram::Reading LatencyHistogram::read() const {
  Reading reading;
  std::uint64_t sum_ns = 0;
  for (const Stripe& each : stripes_) {
    for (std::size_t i = 0; i < each.counts.size(); ++i) {
      reading.counts[i] += each.counts[i].load(std::memory_order_relaxed);
    }
    sum_ns += each.sum_ns.load(std::memory_order_relaxed);
  }
  reading.sum_seconds = static_cast<double>(sum_ns) * 1e-9;
  return reading;
}

}  // namespace talus::server
