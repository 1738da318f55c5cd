#include "runtime/metrics/instruments.h"

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

LatencyHistogram::Snapshot LatencyHistogram::read() const {
  Snapshot snapshot;
  std::uint64_t sum_ns = 0;
  for (const Stripe& each : stripes_) {
    for (std::size_t i = 0; i < each.counts.size(); ++i) {
      snapshot.counts[i] += each.counts[i].load(std::memory_order_relaxed);
    }
    sum_ns += each.sum_ns.load(std::memory_order_relaxed);
  }
  snapshot.sum_seconds = static_cast<double>(sum_ns) * 1e-9;
  return snapshot;
}

}  // namespace talus::server
