#include "measure/histogram.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace talus::measure {
namespace {

// Up to 2 * kHalf every microsecond has a bucket; each doubling above has kHalf buckets.
constexpr std::uint64_t kHalf = 1024;
constexpr int kHalfBits = 10;
constexpr std::uint64_t kMaxUs = (std::uint64_t{1} << 36) - 1;

}  // namespace

void Histogram::record(std::chrono::nanoseconds wait, std::uint64_t times) {
  const auto ns = static_cast<std::uint64_t>(std::max<std::int64_t>(wait.count(), 0));
  const std::uint64_t us = std::min((ns + 999) / 1000, kMaxUs);
  const std::size_t bucket = bucket_of(us);
  if (bucket >= counts_.size()) counts_.resize(bucket + 1);
  counts_[bucket] += times;
  count_ += times;
  max_us_ = std::max(max_us_, us);
  sum_us_ += static_cast<double>(us) * static_cast<double>(times);
}

void Histogram::merge(const Histogram& other) {
  if (other.counts_.size() > counts_.size()) counts_.resize(other.counts_.size());
  for (std::size_t i = 0; i < other.counts_.size(); ++i) counts_[i] += other.counts_[i];
  count_ += other.count_;
  max_us_ = std::max(max_us_, other.max_us_);
  sum_us_ += other.sum_us_;
}

double Histogram::percentile_ms(double part) const {
  if (count_ == 0) return 0;
  const auto rank =
      std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::ceil(part * static_cast<double>(count_))));
  std::uint64_t seen = 0;
  for (std::size_t bucket = 0; bucket < counts_.size(); ++bucket) {
    seen += counts_[bucket];
    if (seen >= rank) return static_cast<double>(std::min(end_of(bucket), max_us_)) / 1e3;
  }
  return max_ms();
}

double Histogram::mean_ms() const {
  return count_ == 0 ? 0 : sum_us_ / static_cast<double>(count_) / 1e3;
}

std::size_t Histogram::bucket_of(std::uint64_t us) {
  if (us < 2 * kHalf) return us;
  const int shift = static_cast<int>(std::bit_width(us)) - kHalfBits - 1;
  return (static_cast<std::size_t>(shift) << kHalfBits) + (us >> shift);
}

std::uint64_t Histogram::end_of(std::size_t bucket) {
  if (bucket < 2 * kHalf) return bucket;
  const std::size_t shift = (bucket >> kHalfBits) - 1;
  const std::uint64_t first = bucket - (shift << kHalfBits);
  return ((first + 1) << shift) - 1;
}

}  // namespace talus::measure
