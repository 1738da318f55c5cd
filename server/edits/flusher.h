// Writes dirty chunks and editors, which only the log's records have, slice by slice, so that edits do not
// wait for all of them; then the records are history. For the log's thread.
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
  /// Maximum size of a slice.
  static constexpr std::size_t kSliceBytes = std::size_t{256} << 10U;
  static constexpr std::size_t kSliceValues = 512;

  /// Returns true if all values that were written to the database are durable; false: not yet, retry. An
  /// error is one line.
  using SyncCheck = std::function<tl::expected<bool, std::string>()>;

  /// Both outlive this. The first blocks for the disk.
  Flusher(EditState& state, store::EditDatabase& database);
  Flusher(EditState& state, store::EditDatabase& database, SyncCheck synced)
      : state_{state}, database_{database}, synced_{std::move(synced)} {}

  [[nodiscard]] bool is_running() const { return running_; }
  /// Begins with everything that is dirty now. REQUIRES: !is_running().
  void start();
  /// Writes one slice, or checks that all are synced. An error is one line, and the next step writes the
  /// slice again. Chunks become clean only when all of them are durable: until then they are not read from
  /// the database.
  [[nodiscard]] store::EditDatabase::Status step();
  /// Values written since start() may be lost: all stay dirty. REQUIRES: is_running().
  void abandon();

 private:
  /// Everything is written: records that in the database once it is synced.
  [[nodiscard]] store::EditDatabase::Status mark();
  /// Makes one slice of durable chunks clean.
  void clean_some();

  EditState& state_;
  store::EditDatabase& database_;
  const SyncCheck synced_;
  bool running_ = false;
  bool put_ = false;              // all is written
  bool flushed_ = false;          // and recorded; chunks are being made clean
  std::uint64_t position_ = 0;    // everything dirty up to it is flushed at the end
  std::vector<ChunkKey> chunks_;  // not yet written
  std::vector<edits::EditorId> editors_;
  std::size_t editors_left_ = 0;                             // at the front of editors_
  std::vector<std::pair<ChunkKey, std::uint64_t>> written_;  // with their revisions
};

}  // namespace talus::server
