// Chunks of the View that the client was sent and that were edited since: what it has of each, until it is
// sent what changed. No I/O.
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
    std::uint64_t has = kBaseRevision;  // the client has this revision, or a newer one
    EncodedChunkPtr chunk{};            // a newer one that the source gave; null: none
    bool under_way = false;             // it was asked for, or given
  };

  /// Whether it is new; else what the client has stays as it was noted first.
  bool add(ChunkKey key, std::uint64_t has) { return updates_.try_emplace(key, Update{has}).second; }
  [[nodiscard]] bool contains(ChunkKey key) const { return updates_.contains(key); }
  /// REQUIRES: contains(key).
  [[nodiscard]] const Update& at(ChunkKey key) const { return updates_.at(key); }
  /// The source gave a chunk that is newer than what the client has. REQUIRES: contains(key).
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
    release(found->second);
    updates_.erase(found);
  }

  /// The whole chunk is to be asked for. REQUIRES: contains(key).
  void want(ChunkKey key) {
    release(updates_.at(key));
    wanted_.push_back(key);
  }
  [[nodiscard]] std::optional<ChunkKey> next_wanted() const {
    return wanted_.empty() ? std::nullopt : std::optional{wanted_.front()};
  }
  /// What next_wanted() returns was asked for.
  void asked() {
    begin(updates_.at(wanted_.front()));
    wanted_.pop_front();
  }
  /// What next_wanted() returns need not be asked for.
  void found() { wanted_.pop_front(); }

  /// Forgets the chunks for which unwanted(key) is true.
  template <typename Unwanted>
  void drop(Unwanted&& unwanted) {
    std::erase_if(wanted_, unwanted);
    for (auto each = updates_.begin(); each != updates_.end();) {
      if (unwanted(each->first)) {
        release(each->second);
        each = updates_.erase(each);
      } else {
        ++each;
      }
    }
  }

  [[nodiscard]] std::size_t size() const { return updates_.size(); }
  /// Chunks that were asked for, or given, and did not go yet.
  [[nodiscard]] std::size_t under_way() const { return under_way_; }
  /// Memory of the chunks, as if nobody else held them.
  [[nodiscard]] std::size_t chunk_bytes() const { return chunk_bytes_; }
  /// All memory, with the place that an update has in the outbox.
  [[nodiscard]] std::size_t bytes() const {
    constexpr std::size_t kPerUpdate = 96;
    return updates_.size() * kPerUpdate + wanted_.size() * sizeof(ChunkKey) + chunk_bytes_;
  }

 private:
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
};

}  // namespace talus::server
