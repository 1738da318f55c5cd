#include "request_pace.h"

#include <algorithm>

#include <talus/client/options.h>

namespace talus::client {

RequestPace::RequestPace(const ServerLimits& limits, Time now) : updated_{now} {
  for (const auto& rates : {limits.session_rates, limits.address_rates}) {
    if (!rates || rates->requests == 0 || (limited() && rates->requests >= per_second_)) continue;
    per_second_ = rates->requests;
    const double burst =
        static_cast<double>(rates->requests) * static_cast<double>(rates->burst.count()) / 1000;
    max_level_ = std::max(1.0, burst * 7 / 8);
  }
  level_ = max_level_;
}

double RequestPace::level(Time now) const {
  const double seconds = std::max(0.0, std::chrono::duration<double>(now - updated_).count());
  return std::min(max_level_, level_ + seconds * static_cast<double>(per_second_));
}

bool RequestPace::take(Time now) {
  if (now < held_until_) return false;
  if (limited() && level(now) < 1) return false;
  spend(now);
  return true;
}

void RequestPace::spend(Time now) {
  if (!limited()) return;
  level_ = level(now) - 1;
  updated_ = std::max(updated_, now);
}

void RequestPace::refused(Time now, std::chrono::milliseconds retry_after) {
  if (now >= held_until_) refused_ = 0;
  held_until_ = std::max(held_until_, now + std::min(retry_after, kLongestRetryAfter));
  level_ = std::min(max_level_, ++refused_);
  updated_ = held_until_;
}

RequestPace::Time RequestPace::next(Time now) const {
  if (!limited()) return held_until_;
  const double missing = 1 - level(std::max(now, held_until_));
  if (missing <= 0) return held_until_;
  const std::chrono::duration<double> wait{missing / static_cast<double>(per_second_)};
  return std::max(now, held_until_) + std::chrono::ceil<Time::duration>(wait);
}

}  // namespace talus::client
