// Replays the log's records that are newer than chunks and editors on the disk. Some of these may have
// records applied already: they are written one by one, and a power cut comes at any time.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include <talus/edits/batch.h>
#include <talus/store/edit_database.h>
#include <talus/store/replayed_chunks.h>
#include <talus/store/replayed_editors.h>

#include "edits/chunk_index.h"

namespace talus::server {

class Replay {
 public:
  /// `index` has the revisions of the database's chunks. Both outlive this.
  Replay(const store::EditDatabase& database, const ChunkIndex& index);

  /// An editor of the database. Call it for all of them before the first record.
  void start(edits::EditorId id, store::StoredEditor&& stored) { editors_.start(id, std::move(stored)); }
  /// Returns false if the record does not follow the last one, or a chunk cannot be read.
  [[nodiscard]] bool apply(const store::LogRecord& record);

  [[nodiscard]] std::unordered_map<ChunkKey, store::ReplayedChunks::Chunk> take_chunks() {
    return chunks_.take();
  }
  [[nodiscard]] edits::Editors take_editors() { return editors_.take(); }
  /// Editors whose record in the database differs or must be removed.
  [[nodiscard]] std::unordered_set<edits::EditorId> take_dirty_editors() { return editors_.take_dirty(); }

 private:
  store::ReplayedChunks chunks_;
  store::ReplayedEditors editors_;
  std::optional<std::uint64_t> revision_;
};

}  // namespace talus::server
