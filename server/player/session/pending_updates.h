// Chunks of the View that were edited after the client was sent them, with the revision that the client has,
// until it is sent the changes. No I/O.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <unordered_map>
#include <utility>

#include <talus/voxel/coords.h>

#include "chunks/encoded_chunk.h"

namespace talus::server {

class PendingUpdates {
 public:
  struct Update {
    std::uint64_t has = kBaseRevision;  // the client has this revision or a newer one
    EncodedChunkPtr chunk{};            // a newer one from the source; may be null
    bool under_way = false;             // requested or received
    bool first = false;                 // the View is not complete without it
  };

  /// Returns true if the chunk is new here; otherwise the revision noted first stays.
  bool add(ChunkKey key, std::uint64_t has) { return updates_.try_emplace(key, Update{has}).second; }
  /// Adds a chunk that the client made, which is the first that the View sends of it. REQUIRES:
  /// !contains(key).
  void add_first(ChunkKey key) {
    updates_[key].first = true;
    ++first_;
  }
  /// Number of chunks of add_first() that were not sent yet.
  [[nodiscard]] std::size_t first() const { return first_; }
  [[nodiscard]] bool contains(ChunkKey key) const { return updates_.contains(key); }
  /// REQUIRES: contains(key).
  [[nodiscard]] const Update& at(ChunkKey key) const { return updates_.at(key); }
  /// The source gave a chunk newer than the client's. REQUIRES: contains(key).
  void give(ChunkKey key, EncodedChunkPtr chunk) {
    Update& update = updates_.at(key);
    release(update);
    begin(update);
    chunk_bytes_ += chunk->bytes();
    update.chunk = std::move(chunk);
  }
  void erase(ChunkKey key) {
    const auto found = updates_.find(key);
    if (found == updates_.end()) return;
    forget(found->second);
    updates_.erase(found);
  }

  /// Queues the whole chunk for a request to the source. REQUIRES: contains(key).
  void want(ChunkKey key) {
    release(updates_.at(key));
    wanted_.push_back(key);
  }
  [[nodiscard]] std::optional<ChunkKey> next_wanted() const {
    return wanted_.empty() ? std::nullopt : std::optional{wanted_.front()};
  }
  /// The chunk of next_wanted() was requested.
  void asked() {
    begin(updates_.at(wanted_.front()));
    wanted_.pop_front();
  }
  /// The chunk of next_wanted() need not be requested.
  void found() { wanted_.pop_front(); }

  /// Removes the chunks for which unwanted(key) is true.
  template <typename Unwanted>
  void drop(Unwanted&& unwanted) {
    std::erase_if(wanted_, unwanted);
    for (auto each = updates_.begin(); each != updates_.end();) {
      if (unwanted(each->first)) {
        forget(each->second);
        each = updates_.erase(each);
      } else {
        ++each;
      }
    }
  }

  [[nodiscard]] std::size_t size() const { return updates_.size(); }
  /// Number of chunks requested or received but not yet sent.
  [[nodiscard]] std::size_t under_way() const { return under_way_; }
  /// Memory of the chunks, as if they were not shared.
  [[nodiscard]] std::size_t chunk_bytes() const { return chunk_bytes_; }
  /// Total memory, including the updates' places in the outbox.
  [[nodiscard]] std::size_t bytes() const {
    constexpr std::size_t kPerUpdate = 96;
    return updates_.size() * kPerUpdate + wanted_.size() * sizeof(ChunkKey) + chunk_bytes_;
  }

 private:
  void forget(Update& update) {
    release(update);
    if (update.first) --first_;
  }
  void begin(Update& update) {
    if (!std::exchange(update.under_way, true)) ++under_way_;
  }
  void release(Update& update) {
    if (std::exchange(update.under_way, false)) --under_way_;
    if (update.chunk != nullptr) chunk_bytes_ -= update.chunk->bytes();
    update.chunk = nullptr;
  }

  std::unordered_map<ChunkKey, Update> updates_;
  std::deque<ChunkKey> wanted_;  // oldest first; each is in updates_
  std::size_t chunk_bytes_ = 0;
  std::size_t under_way_ = 0;
  std::size_t first_ = 0;
};

}  // namespace talus::server
