// How long chunks took from the View that first had them to their arrival.
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

  /// A View that differs from the one before was set.
  void view_set(client::ViewShape shape, Time now) { views_.emplace_back(now, std::move(shape)); }

  /// A chunk arrived. It counts once, from the first View that has it; a chunk of no View does not count.
  void chunk_arrived(const ChunkKey& key, Time now);

  [[nodiscard]] const measure::Histogram& waits() const { return waits_; }

 private:
  std::vector<std::pair<Time, client::ViewShape>> views_;
  std::unordered_set<ChunkKey> seen_;
  measure::Histogram waits_;
};

}  // namespace talus::cli
