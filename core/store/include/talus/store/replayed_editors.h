// What the log's records behind the flushed ones make of editors, which may be as of later ones already: they
// are written one by one, and a power cut comes at any time.
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
  /// An editor of the database. All of them before the first record.
  void start(edits::EditorId id, StoredEditor&& stored);
  /// The next record.
  void apply(const LogRecord& record);

  [[nodiscard]] edits::Editors take() { return std::move(editors_); }
  /// Those that the database has otherwise, or has and should not.
  [[nodiscard]] std::unordered_set<edits::EditorId> take_dirty() { return std::move(dirty_); }

 private:
  edits::Editors editors_;
  std::unordered_map<edits::EditorId, std::uint64_t>
      positions_;  // up to which entry the database has an editor
  std::unordered_set<edits::EditorId> dirty_;
};

}  // namespace talus::store
