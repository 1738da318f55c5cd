// Estimates whether a rate advertised by the server delayed players: simulates its token bucket with the
// observed arrivals. No I/O, no clock.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace talus::load {

class RateModel {
 public:
  /// 0 per second: unlimited. The bucket is initially full.
  RateModel(std::uint64_t per_second, std::chrono::milliseconds burst)
      : per_second_{static_cast<double>(per_second)},
        max_level_{per_second_ * static_cast<double>(burst.count()) / 1000},
        level_{max_level_} {}

  /// `count` arrived in the next `seconds`. `counts`: this time is part of the measurement.
  void add(double seconds, double count, bool counts) {
    level_ = std::max(0.0, std::min(max_level_, level_ + per_second_ * seconds) - count);
    if (!counts) return;
    seconds_ += seconds;
    count_ += count;
    // The server has counted a quarter of a second more than the players have received.
    if (level_ <= std::min(per_second_ / 4, max_level_ / 10)) empty_seconds_ += seconds;
  }

  /// The share of time, 0 to 1, in which the bucket was empty. If the bucket was not full at first, the
  /// observed rate equals the limit all the time.
  [[nodiscard]] double held() const {
    if (per_second_ == 0 || seconds_ == 0) return 0;
    const double share_of_limit = count_ / (per_second_ * seconds_);
    if (share_of_limit > 0.97 && share_of_limit < 1.03) return 1;
    return empty_seconds_ / seconds_;
  }
  [[nodiscard]] double per_second() const { return per_second_; }

 private:
  double per_second_, max_level_, level_;
  double seconds_ = 0, count_ = 0, empty_seconds_ = 0;
};

}  // namespace talus::load
