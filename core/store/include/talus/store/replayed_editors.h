// Applies unflushed log records to editors. A stored editor may include some of them already, because editors
// are written one by one and a power cut may come at any time.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <unordered_set>

#include <talus/edits/editors.h>
#include <talus/store/log_records.h>
#include <talus/store/records.h>

namespace talus::store {

class ReplayedEditors {
 public:
  /// Adds an editor of the database. Call it for all of them before the first record.
  void start(edits::EditorId id, StoredEditor&& stored);
  /// Applies the next record.
  void apply(const LogRecord& record);

  [[nodiscard]] edits::Editors take() { return std::move(editors_); }
  /// Returns the editors whose database values are outdated or must be deleted.
  [[nodiscard]] std::unordered_set<edits::EditorId> take_dirty() { return std::move(dirty_); }

 private:
  edits::Editors editors_;
  std::unordered_map<edits::EditorId, std::uint64_t> positions_;  // last entry included in the stored editor
  std::unordered_set<edits::EditorId> dirty_;
};

}  // namespace talus::store
