// A client's View from the message to its last chunk: the newest View, which may be pending; the View in
// force; and the chunks that the client reports to hold. No I/O.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include <talus/voxel/content_hash.h>
#include <talus/voxel/coords.h>

#include "player/view/area_of_interest.h"
#include "player/view/heading.h"
#include "player/view/view_stream.h"

namespace talus::server {

class ViewSubscription {
 public:
  /// Maximum number of Views with different chunks that may be replaced between two apply(). Beyond that
  /// every chunk would be resent: the caller checks is_full().
  static constexpr std::size_t kMaxUnseenViews = 8;
  /// Maximum number of chunks that the client may report to hold; others are sent.
  static constexpr std::size_t kMaxKnownChunks = 8192;

  // ---- messages of the client
  /// Sets the newest View, in force from the next apply(). A chunk reported as held stays known if it lies in
  /// every View requested since: a client drops chunks that leave its View.
  void request(View view);
  /// The client holds the chunk with these voxels, and the newest View contains it again.
  void add_known(ChunkKey key, ContentHash hash);

  /// True if a View waits for apply().
  [[nodiscard]] bool waits() const { return requested_.has_value(); }
  /// True if that View replaced another pending one: they arrive faster than they are applied.
  [[nodiscard]] bool piles_up() const { return piles_up_; }
  /// True if no other View may be requested before apply().
  [[nodiscard]] bool is_full() const { return unseen_.size() == kMaxUnseenViews; }
  /// Puts the newest View in force. Chunks in flight may no longer be in flight. If has_base() is true then,
  /// call mark_edited() next.
  void apply();
  /// See ViewStream.
  void mark_edited(std::span<const ChunkKey> edited);
  /// Ends the subscription: removes the View, the known chunks and the chunks in flight.
  void clear();

  // ---- the View in force
  /// True if the client makes chunks. A View without base after one with base has none of its chunks: what
  /// the client made may be wrong.
  [[nodiscard]] bool has_base() const { return stream_.has_base(); }
  /// Boxes of its chunks, and of the chunks it will have soon if it keeps moving.
  [[nodiscard]] const std::vector<LevelBox>& ahead() const { return ahead_; }
  /// The client's number of the View.
  [[nodiscard]] std::uint32_t number() const { return number_; }
  /// Returns the View's number once, when all its chunks are done; nullopt for a View without a number, or
  /// once a newer one is requested.
  [[nodiscard]] std::optional<std::uint32_t> completed();
  /// True if nothing is left to be done or reported.
  [[nodiscard]] bool settled() const { return !requested_ && stream_.left() == 0 && !completion_due_; }
  [[nodiscard]] ViewStream& stream() { return stream_; }
  [[nodiscard]] const ViewStream& stream() const { return stream_; }
  /// The chunk in flight was sent, or answered otherwise.
  void done(ChunkKey key);

  /// Returns true if the client said that it holds the chunk.
  [[nodiscard]] bool is_known(ChunkKey key) const { return known_.contains(key); }
  /// Returns true if the client holds the chunk with these voxels.
  [[nodiscard]] bool knows(ChunkKey key, ContentHash hash) const;
  [[nodiscard]] std::size_t known_chunks() const { return known_.size(); }

  /// Approximate memory.
  [[nodiscard]] std::size_t bytes() const;

 private:
  /// Forgets known chunks that are done.
  void forget_known();

  ViewStream stream_;
  std::uint32_t number_ = 0;
  bool completion_due_ = false;  // only for a View with a number
  Heading heading_;
  std::vector<LevelBox> ahead_;
  std::optional<View> requested_;
  bool piles_up_ = false;
  std::vector<AreaOfInterest> unseen_;               // replaced before apply(), oldest first
  std::unordered_map<ChunkKey, ContentHash> known_;  // chunks that are not done
};

}  // namespace talus::server
