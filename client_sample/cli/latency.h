// How long chunks took from being wanted to being there.
#pragma once

#include <chrono>
#include <cstddef>
#include <unordered_set>
#include <utility>
#include <vector>

#include <talus/client/view.h>

namespace talus::cli {

class Latency {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// A View that differs from the one before went out.
  void wanted(const client::View& view, Time now) { views_.emplace_back(now, client::ViewShape{view}); }

  /// A chunk of the View came; counted once, from the first View that had it.
  void arrived(const ChunkKey& key, Time now);

  [[nodiscard]] std::size_t count() const { return waits_.size(); }
  /// The wait that `part` of all chunks (0 to 1) did not exceed; zero when none came.
  [[nodiscard]] std::chrono::duration<double, std::milli> percentile(double part) const;

 private:
  std::vector<std::pair<Time, client::ViewShape>> views_;
  std::unordered_set<ChunkKey> seen_;
  std::vector<std::chrono::duration<double, std::milli>> waits_;
};

}  // namespace talus::cli
