// Chunks that were sent again whole not long ago: each pauses before it is sent again. However often a chunk
// is edited, and by however many, it costs a client one chunk a pause. No I/O.
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

  /// The chunk goes out whole.
  void resent(ChunkKey key, Clock::time_point now) {
    forget_ended(now);
    if (!ends_.try_emplace(key, now + kPause).second) return;  // it was not to be sent again yet
    in_order_.emplace_back(now + kPause, key);
  }

  /// Whether the chunk pauses; then it is noted, and take_ended() returns it in its time.
  [[nodiscard]] bool holds(ChunkKey key, Clock::time_point now) {
    const auto found = ends_.find(key);
    if (found == ends_.end() || found->second <= now) return false;
    waiting_.emplace(found->second, key);
    return true;
  }

  /// When the next of those that were noted is to be sent; none are: max().
  [[nodiscard]] Clock::time_point next() const {
    return waiting_.empty() ? Clock::time_point::max() : waiting_.begin()->first;
  }
  /// One that was noted, and whose pause ended.
  [[nodiscard]] std::optional<ChunkKey> take_ended(Clock::time_point now) {
    if (next() > now) return std::nullopt;
    return waiting_.extract(waiting_.begin()).value().second;
  }

  /// Forgets the chunks that were noted and for which unwanted(key) is true. Their pauses go on.
  template <typename Unwanted>
  void drop(Unwanted&& unwanted) {
    std::erase_if(waiting_, [&](const auto& each) { return unwanted(each.second); });
  }

  /// All memory, roughly.
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
