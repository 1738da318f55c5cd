// Keeps a reason that comes again and again from filling the log.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace talus::server::jetstream {

class ToldReason {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  static constexpr std::chrono::seconds kBetween{60};

  /// True if the same reason was the last one, within kBetween; else it counts as told now.
  [[nodiscard]] bool is_told(std::string_view reason, TimePoint now) {
    if (reason == reason_ && now <= at_ + kBetween) return true;
    reason_ = reason;
    at_ = now;
    return false;
  }

 private:
  std::string reason_;
  TimePoint at_{};
};

}  // namespace talus::server::jetstream
