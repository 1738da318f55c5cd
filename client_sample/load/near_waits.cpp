#include "near_waits.h"

#include <algorithm>

namespace talus::load {

void NearWaits::step(Time due, const PendingChunks& pending) {
  open_.push_back(due);
  // A newer View's nearest rings replace the earlier Views', which the player has flown through.
  if (pending.near_waiting() == 0) close_steps(due);
  const bool waited = std::exchange(waits_, pending.waiting() > 0);
  if (!waited) fast_since_ = due;
}

void NearWaits::came(Time now, const PendingChunks& pending) {
  end_fast(now);
  waits_ = pending.waiting() > 0;
  fast_since_ = now;
  if (pending.near_waiting() == 0) close_steps(now);
}

void NearWaits::stop(Time now) {
  end_fast(now);
  waits_ = false;
  close_steps(now);
}

void NearWaits::close_steps(Time now) {
  for (const Time since : open_) done_.push_back({since, std::max(now - since, Clock::duration{})});
  open_.clear();
}

void NearWaits::end_fast(Time now) {
  if (waits_) longest_without_ = std::max(longest_without_, now - std::max(fast_since_, from_));
}

}  // namespace talus::load
