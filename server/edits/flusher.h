// Writes chunks and editors that the log's records alone hold, slice by slice, so that edits need not wait
// for all of them; then the records are history. Of the log's thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "edits/edit_state.h"
#include "store/edit_database.h"

namespace talus::server {

class Flusher {
 public:
  /// A slice has at most so much.
  static constexpr std::size_t kSliceBytes = std::size_t{256} << 10U;
  static constexpr std::size_t kSliceValues = 512;

  /// Both outlive this.
  Flusher(EditState& state, EditDatabase& database) : state_{state}, database_{database} {}

  [[nodiscard]] bool is_running() const { return running_; }
  /// Begins with all that is dirty now. REQUIRES: !is_running().
  void start();
  /// Writes one slice. An error is one line, and the slice is written again by the next step. Chunks count as
  /// clean only when all of them are on the disk for sure: until then nobody reads them there.
  [[nodiscard]] EditDatabase::Done step();
  /// What was written since start() may be lost: all of it stays dirty. REQUIRES: is_running().
  void abandon();

 private:
  /// As many as a slice has, of those that are on the disk for sure.
  void clean_some();

  EditState& state_;
  EditDatabase& database_;
  bool running_ = false;
  bool flushed_ = false;          // all is written, and is made clean
  std::uint64_t position_ = 0;    // all that is dirty up to it is flushed at the end
  std::vector<ChunkKey> chunks_;  // those left
  std::vector<edits::EditorId> editors_;
  std::size_t editors_left_ = 0;                             // of editors_, from the front
  std::vector<std::pair<ChunkKey, std::uint64_t>> written_;  // at which revision
};

}  // namespace talus::server
