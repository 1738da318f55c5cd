// Chunks recently resent whole: each pauses before it is resent. However often a chunk is edited, and by
// however many players, it costs a client one whole chunk per pause. No I/O.
#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include <talus/voxel/coords.h>

#include "runtime/clock.h"

namespace talus::server {

class ResendPauses {
 public:
  static constexpr std::chrono::milliseconds kPause{500};

  /// The chunk is sent whole.
  void resent(ChunkKey key, Clock::time_point now) {
    forget_ended(now);
    if (!ends_.try_emplace(key, now + kPause).second) return;  // its pause has not ended
    in_order_.emplace_back(now + kPause, key);
  }

  /// Returns true if the chunk is in its pause; take_ended() then returns it when the pause ends.
  [[nodiscard]] bool holds(ChunkKey key, Clock::time_point now) {
    const auto found = ends_.find(key);
    if (found == ends_.end() || found->second <= now) return false;
    waiting_.emplace(found->second, key);
    return true;
  }

  /// Time at which the first held chunk may be sent; max() if there are none.
  [[nodiscard]] Clock::time_point next() const {
    return waiting_.empty() ? Clock::time_point::max() : waiting_.begin()->first;
  }
  /// Returns a held chunk with an ended pause.
  [[nodiscard]] std::optional<ChunkKey> take_ended(Clock::time_point now) {
    if (next() > now) return std::nullopt;
    return waiting_.extract(waiting_.begin()).value().second;
  }

  /// Drops the held chunks for which unwanted(key) is true. Their pauses continue.
  template <typename Unwanted>
  void drop(Unwanted&& unwanted) {
    std::erase_if(waiting_, [&](const auto& each) { return unwanted(each.second); });
  }

  /// Total memory, approximately.
  [[nodiscard]] std::size_t bytes() const {
    constexpr std::size_t kPerWaiting = 80;
    constexpr std::size_t kPerPause = 96;
    return waiting_.size() * kPerWaiting + in_order_.size() * kPerPause;
  }

 private:
  void forget_ended(Clock::time_point now) {
    for (; !in_order_.empty() && in_order_.front().first <= now; in_order_.pop_front()) {
      ends_.erase(in_order_.front().second);
    }
  }

  std::unordered_map<ChunkKey, Clock::time_point> ends_;
  std::deque<std::pair<Clock::time_point, ChunkKey>> in_order_;  // all of ends_
  std::set<std::pair<Clock::time_point, ChunkKey>> waiting_;
};

}  // namespace talus::server
