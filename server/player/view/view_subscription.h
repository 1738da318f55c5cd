// A client's View from the message to its last chunk: the newest View, which may still wait to be applied;
// the View in force; and what the client says that it holds. No I/O.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
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
  /// Views of different chunks that may be replaced unseen between two apply(). With more every chunk would
  /// be sent again: the caller asks is_full().
  static constexpr std::size_t kMaxUnseenViews = 8;
  /// Chunks that the client may say it holds; those beyond are sent.
  static constexpr std::size_t kMaxKnownChunks = 8192;

  // ---- what the client says
  /// The newest View. It counts from the next apply() on. A chunk that the client said it holds stays
  /// known as long as it lies in every View requested since: a client drops what leaves its View.
  void request(View view);
  /// The client holds the chunk with these voxels, and the newest View brings it back.
  void add_known(ChunkKey key, ContentHash hash);

  /// Whether a View waits for apply().
  [[nodiscard]] bool waits() const { return requested_.has_value(); }
  /// Whether that View replaced one which waited too: they come faster than they are applied.
  [[nodiscard]] bool piles_up() const { return piles_up_; }
  /// Whether no other View may be requested before apply().
  [[nodiscard]] bool is_full() const { return unseen_.size() == kMaxUnseenViews; }
  /// Puts the newest View in force. Chunks that were in flight may be so no more.
  void apply();
  /// Ends the subscription: no View, nothing known, nothing in flight.
  void clear();

  // ---- the View in force
  /// Its chunks, and those that it comes to have soon if it moves on as it does.
  [[nodiscard]] const std::vector<LevelBox>& ahead() const { return ahead_; }
  /// As the client numbered it.
  [[nodiscard]] std::uint32_t number() const { return number_; }
  /// The View's number, once, when all its chunks are done; none for a View without number, and from when a
  /// newer one is requested.
  [[nodiscard]] std::optional<std::uint32_t> completed();
  /// Whether nothing is left to be done or said.
  [[nodiscard]] bool settled() const { return !requested_ && stream_.left() == 0 && !completion_due_; }
  [[nodiscard]] ViewStream& stream() { return stream_; }
  [[nodiscard]] const ViewStream& stream() const { return stream_; }
  /// The chunk in flight was sent or answered otherwise.
  void done(ChunkKey key);

  /// Whether the client holds the chunk with these voxels.
  [[nodiscard]] bool knows(ChunkKey key, ContentHash hash) const;
  [[nodiscard]] std::size_t known_chunks() const { return known_.size(); }

  /// Memory held, roughly.
  [[nodiscard]] std::size_t bytes() const;

 private:
  ViewStream stream_;
  std::uint32_t number_ = 0;
  bool completion_due_ = false;  // of a View with a number
  Heading heading_;
  std::vector<LevelBox> ahead_;
  std::optional<View> requested_;
  bool piles_up_ = false;
  std::vector<AreaOfInterest> unseen_;               // replaced before apply(), oldest first
  std::unordered_map<ChunkKey, ContentHash> known_;  // of chunks that are not done
};

}  // namespace talus::server
