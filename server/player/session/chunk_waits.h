// The waiters of one session for chunks from the source: the View, an update of a chunk that the View has
// sent, or requests. No I/O.
//
// Invariant: the session has submitted each chunk here to its source, has not cancelled it, and has received
// no answer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include <talus/voxel/coords.h>

#include "runtime/clock.h"

namespace talus::server {

class ChunkWaits {
 public:
  struct Waiters {
    Clock::time_point since;  // time of the first
    bool view = false;
    bool update = false;
    bool soon = false;  // submitted as wanted soon, or hastened
    std::vector<std::uint32_t> requests;
  };

  /// Number of chunks.
  [[nodiscard]] std::size_t size() const { return waits_.size(); }
  [[nodiscard]] bool contains(ChunkKey key) const { return waits_.contains(key); }
  /// Null if the chunk has no waiters. Valid until the next change.
  [[nodiscard]] Waiters* find(ChunkKey key) {
    const auto found = waits_.find(key);
    return found == waits_.end() ? nullptr : &found->second;
  }
  /// The chunk was submitted at `now`. It must not have waiters yet.
  Waiters& add(ChunkKey key, Clock::time_point now) {
    Waiters& waiters = waits_[key];
    waiters.since = now;
    return waiters;
  }

  /// The chunk was received: removes and returns its waiters; nullopt if the last one left before.
  [[nodiscard]] std::optional<Waiters> take(ChunkKey key) {
    auto found = waits_.extract(key);
    if (found.empty()) return std::nullopt;
    return std::move(found.mapped());
  }

  /// Removes one waiter. Returns true if it was the last; the caller then cancels the chunk at its source.
  [[nodiscard]] bool leave(ChunkKey key, std::uint32_t request) {
    const auto found = waits_.find(key);
    if (found == waits_.end()) return false;
    std::erase(found->second.requests, request);
    return erase_if_unwanted(found);
  }
  /// Ends the View's wait for the chunk, which is still expected, as its answer is on its way. Returns true
  /// if the View was waiting: a chunk with only requests may be one that the View already has and that waits
  /// for the client.
  bool end_view(ChunkKey key) {
    const auto found = waits_.find(key);
    return found != waits_.end() && std::exchange(found->second.view, false);
  }

  /// Ends the View's wait for the chunks for which gone(chunk) is true. Returns the chunks left without
  /// waiters; the caller cancels them at their source.
  template <typename Gone>
  [[nodiscard]] std::vector<ChunkKey> leave_view_where(Gone&& gone) {
    std::vector<ChunkKey> unwanted;
    for (auto& [key, waiters] : waits_) {
      if (!waiters.view || !gone(key)) continue;
      waiters.view = false;
      if (!waiters.update && waiters.requests.empty()) unwanted.push_back(key);
    }
    for (const ChunkKey key : unwanted) waits_.erase(key);
    return unwanted;
  }
  /// The same for updates.
  template <typename Gone>
  [[nodiscard]] std::vector<ChunkKey> leave_updates_where(Gone&& gone) {
    std::vector<ChunkKey> unwanted;
    for (auto& [key, waiters] : waits_) {
      if (!waiters.update || !gone(key)) continue;
      waiters.update = false;
      if (!waiters.view && waiters.requests.empty()) unwanted.push_back(key);
    }
    for (const ChunkKey key : unwanted) waits_.erase(key);
    return unwanted;
  }

  /// Marks the chunks that the View or an update waits for and for which near(chunk) is true as wanted soon.
  /// Returns the newly marked ones.
  template <typename Near>
  [[nodiscard]] std::vector<ChunkKey> hasten_where(Near&& near) {
    std::vector<ChunkKey> hastened;
    for (auto& [key, waiters] : waits_) {
      if ((!waiters.view && !waiters.update) || waiters.soon || !near(key)) continue;
      hastened.push_back(key);
      waiters.soon = true;
    }
    return hastened;
  }

  /// Removes all chunks and returns them.
  [[nodiscard]] std::vector<ChunkKey> clear() {
    std::vector<ChunkKey> keys;
    for (const auto& [key, waiters] : waits_) keys.push_back(key);
    waits_.clear();
    return keys;
  }

 private:
  using Waits = std::unordered_map<ChunkKey, Waiters>;

  bool erase_if_unwanted(Waits::iterator at) {
    if (at->second.view || at->second.update || !at->second.requests.empty()) return false;
    waits_.erase(at);
    return true;
  }

  Waits waits_;
};

}  // namespace talus::server
