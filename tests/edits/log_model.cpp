#include "log_model.h"

namespace talus::edits::testing {

using Kind = EntryResult::Kind;

std::vector<EntryResult> Store::commit(Batch& batch) {
  std::vector<EntryResult> applied = batch.applied();
  head = batch.head();
  state.hash = head.hash;
  for (auto& [id, editor] : std::move(batch).take_editors()) {
    if (editor) {
      editors.put(id, *std::move(editor));
    } else {
      editors.erase(id);
    }
  }
  state.write(batch.chunks());
  return applied;
}

std::vector<EntryResult> Store::apply(const std::vector<Entry>& entries, std::int64_t now_ms) {
  Batch batch{state, editors, head, now_ms};
  for (const Entry& each : entries) std::visit([&](const auto& entry) { batch.apply(entry); }, each);
  return commit(batch);
}

bool same(const EntryResult& a, const EntryResult& b) {
  return a.kind == b.kind && a.editor == b.editor && a.position == b.position && a.revision == b.revision &&
         a.result == b.result && a.is_unknown == b.is_unknown && a.changes == b.changes &&
         a.writes == b.writes;
}

const LogModel::Editor& LogModel::editor(EditorId id) const {
  static const Editor kNobody;
  const auto known = editors_.find(id);
  return known == editors_.end() ? kNobody : known->second;
}

std::string LogModel::follow(const Entry& entry, const EntryResult& applied) {
  std::string fault;
  const auto* const attach = std::get_if<AttachEntry>(&entry);
  const Kind kind = attach != nullptr ? apply(*attach) : apply(std::get<EditEntry>(entry), applied, fault);
  if (applied.kind != kind) fault = "another outcome";
  if (applied.position != ++position_) fault = "another position";
  revision_ += applied.changed() ? 1 : 0;
  if (applied.revision != revision_) fault = "another revision";
  if (kind == Kind::done || kind == Kind::conflict) {
    if (!happened_.emplace(applied.editor, applied.result.sequence).second) fault = "an edit happened twice";
  }
  return fault.empty() ? fault : "entry " + std::to_string(position_) + ": " + fault;
}

Kind LogModel::apply(const AttachEntry& attach) {
  Editor& editor = editors_[attach.editor];
  const bool fits =
      attach.epoch == editor.epoch + 1 && (editor.epoch == 0 || editor.subject == attach.subject);
  if (!fits) return Kind::superseded;
  editor.epoch = attach.epoch;
  editor.subject = attach.subject;
  return Kind::attached;
}

Kind LogModel::apply(const EditEntry& edit, const EntryResult& applied, std::string& fault) {
  Editor& editor = editors_[edit.editor];
  if (editor.epoch == 0 || editor.epoch != edit.epoch) return Kind::expired;
  if (edit.sequence <= editor.last) {
    const auto kept = editor.results.find(edit.sequence);
    if (kept == editor.results.end()) {
      const bool is_unknown =
          editor.results.size() == kKeptResults && edit.sequence < editor.results.begin()->first;
      if (applied.is_unknown != is_unknown) fault = "an edit's result is known, or not";
      return Kind::not_applied;
    }
    if (applied.result != kept->second) fault = "a repeat has another result";
    return Kind::repeat;
  }
  if (edit.base.empty() && !touched_voxels(edit.edit)->empty()) return Kind::invalid;
  const Model::Result result = model_.apply(edit.edit);
  const bool told = applied.result.sequence == edit.sequence && applied.result.changed == result.changed &&
                    applied.result.revision == applied.revision && applied.changed() == (result.changed > 0);
  if (!told) fault = "another result";
  editor.last = edit.sequence;
  editor.results[edit.sequence] = applied.result;
  if (editor.results.size() > kKeptResults) editor.results.erase(editor.results.begin());
  return result.conflict ? Kind::conflict : Kind::done;
}

}  // namespace talus::edits::testing
