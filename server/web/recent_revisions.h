// Remembers roughly which revisions of a store are recent: made since 5 to 10 s ago, or longer if calls are
// rarer. Callable from any thread.
#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>

#include "runtime/clock.h"

namespace talus::server::web {

class RecentRevisions {
 public:
  static constexpr std::chrono::seconds kSpan{5};

  /// `newest`: the store's current revision. Returns false at the first call.
  [[nodiscard]] bool has(std::uint64_t revision, std::uint64_t newest, Clock::time_point now) {
    const std::lock_guard lock{mutex_};
    if (!before_) before_ = last_ = {now, newest};
    if (now >= last_.at + kSpan) {
      before_ = last_;
      last_ = {now, newest};
    }
    return revision > before_->newest;
  }

 private:
  struct Sample {
    Clock::time_point at{};
    std::uint64_t newest = 0;
  };

  std::mutex mutex_;
  std::optional<Sample> before_;
  Sample last_;
};

}  // namespace talus::server::web
