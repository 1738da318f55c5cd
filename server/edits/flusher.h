// Writes chunks and editors that the log's records alone hold, slice by slice, so that edits need not wait
// for all of them; then the records are history. Of the log's thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <talus/store/edit_database.h>

#include "edits/edit_state.h"

namespace talus::server {

class Flusher {
 public:
  /// A slice has at most so much.
  static constexpr std::size_t kSliceBytes = std::size_t{256} << 10U;
  static constexpr std::size_t kSliceValues = 512;

  /// Whether all that was put into the database is on the disk; false: not yet, ask again. An error is one
  /// line.
  using Synced = std::function<tl::expected<bool, std::string>()>;

  /// Both outlive this. Waits for the disk itself.
  Flusher(EditState& state, store::EditDatabase& database);
  Flusher(EditState& state, store::EditDatabase& database, Synced synced)
      : state_{state}, database_{database}, synced_{std::move(synced)} {}

  [[nodiscard]] bool is_running() const { return running_; }
  /// Begins with all that is dirty now. REQUIRES: !is_running().
  void start();
  /// Writes one slice, or asks whether all are synced. An error is one line, and the slice is written again
  /// by the next step. Chunks count as clean only when all of them are on the disk for sure: until then
  /// nobody reads them there.
  [[nodiscard]] store::EditDatabase::Done step();
  /// What was written since start() may be lost: all of it stays dirty. REQUIRES: is_running().
  void abandon();

 private:
  /// All is put: says so in the database once it is synced.
  [[nodiscard]] store::EditDatabase::Done mark();
  /// As many as a slice has, of those that are on the disk for sure.
  void clean_some();

  EditState& state_;
  store::EditDatabase& database_;
  const Synced synced_;
  bool running_ = false;
  bool put_ = false;              // all is written
  bool flushed_ = false;          // and marked, and is made clean
  std::uint64_t position_ = 0;    // all that is dirty up to it is flushed at the end
  std::vector<ChunkKey> chunks_;  // those left
  std::vector<edits::EditorId> editors_;
  std::size_t editors_left_ = 0;                             // of editors_, from the front
  std::vector<std::pair<ChunkKey, std::uint64_t>> written_;  // at which revision
};

}  // namespace talus::server
