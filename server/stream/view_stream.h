// What of a session's current View was sent, is under way, and is still to come. No I/O.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include <talus/voxel/coords.h>

namespace talus::server {

class ViewStream {
 public:
  /// Replaces the wanted chunks by `wanted`, most wanted first, each once. What stays wanted keeps its
  /// state; the result is what was under way and is wanted no more. A chunk that left is forgotten, so
  /// that it is sent again when it comes back.
  [[nodiscard]] std::vector<ChunkKey> replace(std::vector<ChunkKey> wanted);

  /// The most wanted chunk that is neither under way nor sent, now under way.
  [[nodiscard]] std::optional<ChunkKey> next();
  /// A chunk under way could not be had: it is wanted again.
  void put_back(ChunkKey key);
  /// A chunk under way was sent, or will never be.
  void done(ChunkKey key);

  [[nodiscard]] bool under_way(ChunkKey key) const { return under_way_.contains(key); }
  [[nodiscard]] std::size_t under_way_count() const { return under_way_.size(); }

 private:
  enum class State : std::uint8_t { wanted, under_way, done };

  void leave(ChunkKey key, State state);

  // A View may have many chunks, but only a few of them are under way: those alone can be found by key.
  std::vector<ChunkKey> order_;
  std::vector<State> states_;                            // of the chunks in order_
  std::size_t cursor_ = 0;                               // no chunk before it is in state wanted
  std::unordered_map<ChunkKey, std::size_t> under_way_;  // places in order_
};

}  // namespace talus::server
