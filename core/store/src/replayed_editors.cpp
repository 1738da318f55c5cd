#include <talus/store/replayed_editors.h>

#include <utility>

namespace talus::store {

void ReplayedEditors::start(edits::EditorId id, StoredEditor&& stored) {
  positions_.emplace(id, stored.position);
  editors_.put(id, std::move(stored.editor));
}

void ReplayedEditors::apply(const LogRecord& record) {
  using Kind = edits::EntryResult::Kind;
  const bool attach =
      record.kind == Kind::attached || record.kind == Kind::superseded || record.kind == Kind::editors_full;
  // The stored editor includes the record, or is a later one of that id.
  const auto is_stored = [&](edits::EditorId id) {
    const auto has = positions_.find(id);
    return has != positions_.end() && has->second >= record.position;
  };
  if (attach) {
    for (const edits::EditorId id : editors_.idle_at(record.time_ms)) {
      if (is_stored(id)) continue;  // times of the log may fall
      editors_.erase(id);
      dirty_.insert(id);
    }
  }
  if (record.forgotten && !is_stored(*record.forgotten)) {
    editors_.erase(*record.forgotten);
    dirty_.insert(*record.forgotten);
  }
  if (record.kind != Kind::attached && record.kind != Kind::done && record.kind != Kind::conflict) return;
  if (is_stored(record.editor)) return;
  const edits::Editor* const before = editors_.find(record.editor);
  // A later record forgets the editor, and the database already lacks it.
  if (before == nullptr && record.kind != Kind::attached) return;
  edits::Editor editor = before == nullptr ? edits::Editor{} : *before;
  editor.used_ms = record.time_ms;
  if (record.kind == Kind::attached) {
    editor.epoch = record.epoch;
    editor.subject = record.subject;
  } else {
    editor.keep(record.result);
  }
  editors_.put(record.editor, std::move(editor));
  dirty_.insert(record.editor);
}

}  // namespace talus::store
