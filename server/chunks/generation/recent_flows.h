// Knows if more than one flow has asked for work recently. For one thread; GenerationPool locks.
#pragma once

#include <chrono>

#include "limits/flows/flow_ids.h"
#include "runtime/clock.h"

namespace talus::server {

class RecentFlows {
 public:
  /// Time for which a flow that asked counts as asking again.
  static constexpr std::chrono::seconds kRecently{1};

  void asked(FlowId flow, Clock::time_point now) {
    if (flow != last_flow_ && now - last_asked_ < kRecently) two_asked_ = now;
    last_flow_ = flow;
    last_asked_ = now;
  }
  /// Returns true if two flows asked within kRecently of each other, not longer ago than that.
  [[nodiscard]] bool several(Clock::time_point now) const { return now - two_asked_ <= kRecently; }

 private:
  FlowId last_flow_{};
  Clock::time_point last_asked_{};
  Clock::time_point two_asked_{};
};

}  // namespace talus::server
