// Waits, counted in buckets that are a thousandth of their value wide (log-linear, after HdrHistogram, which
// Debian 12 does not have for C++): 1 us exactly up to 2 ms, three significant digits above, 19 hours at
// most.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace talus::measure {

class Histogram {
 public:
  /// What is negative counts as 0, what is longer than the longest as the longest.
  void record(std::chrono::nanoseconds wait, std::uint64_t times = 1);
  void merge(const Histogram& other);

  [[nodiscard]] std::uint64_t count() const { return count_; }
  /// The wait in milliseconds that `part` of all (0 to 1) did not exceed: never too little, and too much by
  /// a thousandth at most. 0 where there are none.
  [[nodiscard]] double percentile_ms(double part) const;
  [[nodiscard]] double max_ms() const { return static_cast<double>(max_us_) / 1e3; }
  [[nodiscard]] double mean_ms() const;

 private:
  [[nodiscard]] static std::size_t bucket_of(std::uint64_t us);
  /// The largest wait in the bucket.
  [[nodiscard]] static std::uint64_t end_of(std::size_t bucket);

  std::vector<std::uint64_t> counts_;  // grows to the longest wait there was
  std::uint64_t count_ = 0;
  std::uint64_t max_us_ = 0;
  double sum_us_ = 0;
};

}  // namespace talus::measure
