#include "net/view_turns.h"

#include <algorithm>
#include <new>

namespace talus::server {

void ViewTurns::enter(FlowId flow, TimedEvent& waiter) {
  if (!flow_of_.emplace(&waiter, flow).second) return;
  try {
    waiting_[flow].push_back(&waiter);
    turns_.enter(flow);
  } catch (...) {
    leave(waiter);
    throw;
  }
  choose();
}

void ViewTurns::leave(TimedEvent& waiter) noexcept {
  const auto found = flow_of_.find(&waiter);
  if (found == flow_of_.end()) return;
  if (const auto waiting = waiting_.find(found->second); waiting != waiting_.end()) {
    std::erase(waiting->second, &waiter);
    if (waiting->second.empty()) waiting_.erase(waiting);
  }
  flow_of_.erase(found);
  if (next_ == &waiter) next_ = nullptr;
  choose();
}

Clock::time_point ViewTurns::due(const TimedEvent& waiter) const {
  const bool may = next_ == nullptr ? flow_of_.contains(&waiter) : next_ == &waiter;
  return may ? free_at_ : Clock::time_point::max();
}

void ViewTurns::applied(TimedEvent& waiter, Clock::time_point began, std::chrono::nanoseconds cost) noexcept {
  free_at_ = std::max(free_at_, began + kIntervalPerCost * cost);
  if (const auto found = flow_of_.find(&waiter); found != flow_of_.end()) {
    turns_.charge(found->second, cost.count());
  }
  leave(waiter);
}

// Without the memory to choose, the turn stays free, and the first waiter that checks may go.
void ViewTurns::choose() noexcept {
  if (next_ != nullptr || waiting_.empty()) return;
  const auto waits = [this](FlowId flow) { return waiting_.contains(flow); };
  try {
    const auto flow = turns_.next(kTurn.count(), waits, waits);
    if (flow) next_ = waiting_.at(*flow).front();
  } catch (const std::bad_alloc&) {
    waiting_.begin()->second.front()->notify();
  }
  if (next_ != nullptr) next_->notify();
}

}  // namespace talus::server
