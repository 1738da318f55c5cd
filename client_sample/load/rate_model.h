// Whether a rate that the server told has held players up: its token bucket, filled and emptied by what was
// seen to come. No I/O, no clock.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace talus::load {

class RateModel {
 public:
  /// 0 a second: no limit. The bucket is full at first.
  RateModel(std::uint64_t per_second, std::chrono::milliseconds burst)
      : per_second_{static_cast<double>(per_second)},
        most_{per_second_ * static_cast<double>(burst.count()) / 1000},
        level_{most_} {}

  /// `count` were sent in the next `seconds`. `counts`: this time is of those that are looked at.
  void add(double seconds, double count, bool counts) {
    level_ = std::max(0.0, std::min(most_, level_ + per_second_ * seconds) - count);
    if (!counts) return;
    seconds_ += seconds;
    count_ += count;
    // What the server has counted and the players have not yet: a quarter of a second.
    if (level_ <= std::min(per_second_ / 4, most_ / 10)) empty_seconds_ += seconds;
  }

  /// The part of the time, 0 to 1, in which the bucket was empty. A bucket that was not full at first shows
  /// in a rate that is the limit's all the time.
  [[nodiscard]] double held() const {
    if (per_second_ == 0 || seconds_ == 0) return 0;
    const double share_of_limit = count_ / (per_second_ * seconds_);
    if (share_of_limit > 0.97 && share_of_limit < 1.03) return 1;
    return empty_seconds_ / seconds_;
  }
  [[nodiscard]] double per_second() const { return per_second_; }

 private:
  double per_second_, most_, level_;
  double seconds_ = 0, count_ = 0, empty_seconds_ = 0;
};

}  // namespace talus::load
