// Who of one session waits for a chunk from the source: the View, an update of a chunk that the View has
// sent, or requests. No I/O.
//
// Invariant: the session has submitted each chunk here to its source, has not cancelled it, and had no
// answer.
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
    Clock::time_point since;  // of the first
    bool view = false;
    bool update = false;
    bool soon = false;  // it was submitted as wanted soon, or hastened
    std::vector<std::uint32_t> requests;
  };

  /// Chunks that are waited for.
  [[nodiscard]] std::size_t size() const { return waits_.size(); }
  [[nodiscard]] bool contains(ChunkKey key) const { return waits_.contains(key); }
  /// Null where nobody waits. Valid until the next change.
  [[nodiscard]] Waiters* find(ChunkKey key) {
    const auto found = waits_.find(key);
    return found == waits_.end() ? nullptr : &found->second;
  }
  /// The chunk was submitted at `now`. Nobody may wait for it yet.
  Waiters& add(ChunkKey key, Clock::time_point now) {
    Waiters& waiters = waits_[key];
    waiters.since = now;
    return waiters;
  }

  /// The chunk came: removes and returns its waiters; none where the last left before it came.
  [[nodiscard]] std::optional<Waiters> take(ChunkKey key) {
    auto found = waits_.extract(key);
    if (found.empty()) return std::nullopt;
    return std::move(found.mapped());
  }

  /// One waiter leaves. Returns true where it was the last: then the caller cancels the chunk at its source.
  [[nodiscard]] bool leave(ChunkKey key, std::uint32_t request) {
    const auto found = waits_.find(key);
    if (found == waits_.end()) return false;
    std::erase(found->second.requests, request);
    return erase_if_unwanted(found);
  }
  /// The View waits for the chunk no more, which is expected all the same, as its answer is on its way.
  /// Returns whether the View waited for it: where a request alone does, the View's own may have come before,
  /// and wait for the client.
  bool end_view(ChunkKey key) {
    const auto found = waits_.find(key);
    return found != waits_.end() && std::exchange(found->second.view, false);
  }

  /// The View waits no more for the chunks for which gone(chunk) is true. Returns those of them for which
  /// nobody else waits: the caller cancels them at their source.
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
  /// Likewise of updates.
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

  /// The chunks for which the View waits, that are not wanted soon yet, and for which near(chunk) is true;
  /// from now on they are.
  template <typename Near>
  [[nodiscard]] std::vector<ChunkKey> hasten_where(Near&& near) {
    std::vector<ChunkKey> hastened;
    for (auto& [key, waiters] : waits_) {
      if (!waiters.view || waiters.soon || !near(key)) continue;
      hastened.push_back(key);
      waiters.soon = true;
    }
    return hastened;
  }

  /// Forgets all chunks, and returns them.
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
