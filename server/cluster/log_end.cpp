#include "cluster/log_end.h"

#include <algorithm>
#include <utility>

namespace talus::server::cluster {

void LogEnd::heard(std::uint64_t last, TimePoint asked) {
  last_ = last;
  heard_ = asked;
  // A report of a larger end was wrong, as by a leader that was cut off, and would never be reached.
  while (!ahead_.empty() && ahead_.back().last > last) ahead_.pop_back();
  if (last <= applied_) {
    reached_ = true;
  } else {
    ahead_.push_back({last, asked});
  }
  if (ahead_.size() > kMaxReports) {
    // Far behind: half of the reports suffice.
    std::deque<Report> thinner;
    for (std::size_t i = 0; i < ahead_.size(); i += 2) thinner.push_back(ahead_[i]);
    ahead_.swap(thinner);
  }
  judge();
}

void LogEnd::unanswered(TimePoint asked) {
  if (!silent_since_) silent_since_ = asked;
}

void LogEnd::answered(TimePoint asked) {
  const auto since = std::exchange(silent_since_, std::nullopt);
  if (!since || asked - *since <= kSilent) return;
  const auto silence = asked - *since;
  for (Report& report : ahead_) report.asked += silence;
  heard_ += silence;
}

void LogEnd::applied(std::uint64_t sequence) {
  applied_ = std::max(applied_, sequence);
  for (; !ahead_.empty() && ahead_.front().last <= applied_; ahead_.pop_front()) reached_ = true;
  judge();
}

std::chrono::steady_clock::duration LogEnd::behind() const {
  return ahead_.empty() ? std::chrono::steady_clock::duration{} : heard_ - ahead_.front().asked;
}

void LogEnd::judge() {
  if (behind() > kFar) {
    ready_ = false;
    reached_ = false;
  } else if (reached_ && behind() <= kNear) {
    ready_ = true;
  }
}

}  // namespace talus::server::cluster
