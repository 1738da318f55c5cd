#include "net/view_turns.h"

#include <algorithm>

namespace talus::server {

void ViewTurns::enter(FlowId flow, TimedEvent& waiter) {
  if (!flow_of_.emplace(&waiter, flow).second) return;
  waiting_[flow].push_back(&waiter);
  turns_.enter(flow);
  choose();
}

void ViewTurns::leave(TimedEvent& waiter) {
  const auto found = flow_of_.find(&waiter);
  if (found == flow_of_.end()) return;
  const auto waiting = waiting_.find(found->second);
  std::erase(waiting->second, &waiter);
  if (waiting->second.empty()) waiting_.erase(waiting);
  flow_of_.erase(found);
  if (next_ != &waiter) return;
  next_ = nullptr;
  choose();
}

Clock::time_point ViewTurns::due(const TimedEvent& waiter) const {
  return next_ == &waiter ? free_at_ : Clock::time_point::max();
}

void ViewTurns::applied(TimedEvent& waiter, Clock::time_point began, std::chrono::nanoseconds cost) {
  free_at_ = std::max(free_at_, began + kIntervalPerCost * cost);
  if (const auto found = flow_of_.find(&waiter); found != flow_of_.end()) {
    turns_.charge(found->second, cost.count());
  }
  leave(waiter);
}

void ViewTurns::choose() {
  if (next_ != nullptr) return;
  const auto waits = [this](FlowId flow) { return waiting_.contains(flow); };
  const auto flow = turns_.next(kTurn.count(), waits, waits);
  if (!flow) return;
  next_ = waiting_.at(*flow).front();
  next_->notify();
}

}  // namespace talus::server
