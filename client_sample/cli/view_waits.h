// Measures the time from the first View with a chunk to the chunk's arrival.
#pragma once

#include <chrono>
#include <unordered_set>
#include <utility>
#include <vector>

#include <talus/client/view.h>

#include "measure/histogram.h"

namespace talus::cli {

class ViewWaits {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// Call when a View that differs from the previous one was set.
  void view_set(client::ViewShape shape, Time now) { views_.emplace_back(now, std::move(shape)); }

  /// Call when a chunk arrived. Counts once, from the first View with it; chunks in no View are ignored.
  void chunk_arrived(const ChunkKey& key, Time now);

  [[nodiscard]] const measure::Histogram& waits() const { return waits_; }

 private:
  std::vector<std::pair<Time, client::ViewShape>> views_;
  std::unordered_set<ChunkKey> seen_;
  measure::Histogram waits_;
};

}  // namespace talus::cli
