#include "net/view_turns.h"

#include <algorithm>
#include <tuple>

namespace talus::server {

void ViewTurns::enter(FlowId flow, TimedEvent& waiter) {
  if (!flow_of_.emplace(&waiter, flow).second) return;
  try {
    turns_.enter({}, flow, &waiter);
  } catch (...) {
    flow_of_.erase(&waiter);
    throw;
  }
  choose();
}

void ViewTurns::leave(TimedEvent& waiter) noexcept {
  const auto found = flow_of_.find(&waiter);
  if (found == flow_of_.end()) return;
  turns_.leave(found->second, &waiter);
  flow_of_.erase(found);
  if (next_ == &waiter) next_ = nullptr;
  choose();
}

Clock::time_point ViewTurns::due(const TimedEvent& waiter) const {
  return next_ == &waiter ? free_at_ : Clock::time_point::max();
}

void ViewTurns::applied(TimedEvent& waiter, Clock::time_point began, std::chrono::nanoseconds cost) noexcept {
  free_at_ = std::max(free_at_, began + kIntervalPerCost * cost);
  if (const auto found = flow_of_.find(&waiter); found != flow_of_.end()) {
    turns_.charge(static_cast<double>(cost.count()), found->second, &waiter);
  }
  leave(waiter);
}

void ViewTurns::choose() noexcept {
  if (next_ != nullptr) return;
  const auto next = turns_.next();
  if (!next) return;
  next_ = std::get<TimedEvent*>(*next);
  next_->notify();
}

}  // namespace talus::server
