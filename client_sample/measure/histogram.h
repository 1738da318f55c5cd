// Counts waits in log-linear buckets (after HdrHistogram, which Debian 12 lacks for C++): exact to 1 us up to
// 2 ms, three significant digits above, at most 19 hours.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace talus::measure {

class Histogram {
 public:
  /// Negative waits count as 0, longer ones than the maximum as the maximum.
  void record(std::chrono::nanoseconds wait, std::uint64_t times = 1);
  void merge(const Histogram& other);

  [[nodiscard]] std::uint64_t count() const { return count_; }
  /// The wait in milliseconds that `part` of all (0 to 1) did not exceed: never too low, and at most a
  /// thousandth too high. 0 if empty.
  [[nodiscard]] double percentile_ms(double part) const;
  [[nodiscard]] double max_ms() const { return static_cast<double>(max_us_) / 1e3; }
  [[nodiscard]] double mean_ms() const;

 private:
  [[nodiscard]] static std::size_t bucket_of(std::uint64_t us);
  /// Longest wait in the bucket.
  [[nodiscard]] static std::uint64_t end_of(std::size_t bucket);

  std::vector<std::uint64_t> counts_;  // grows with the longest wait
  std::uint64_t count_ = 0;
  std::uint64_t max_us_ = 0;
  double sum_us_ = 0;
};

}  // namespace talus::measure
