// Which revisions of a store were made lately, roughly: from 5 to 10 s ago on, longer where nobody asks. Any
// thread.
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

  /// `newest`: the store's now. Before the first question none was made lately.
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
  struct Look {
    Clock::time_point at{};
    std::uint64_t newest = 0;
  };

  std::mutex mutex_;
  std::optional<Look> before_;
  Look last_;
};

}  // namespace talus::server::web
