#include <talus/edits/batch.h>

#include <algorithm>
#include <utility>

namespace talus::edits {

Batch::Batch(const OverrideSource& overrides, const Editors& editors, const Head& head, std::int64_t now_ms,
             const MaterialIds* materials)
    : editors_{editors},
      materials_{materials},
      head_{head},
      staging_{overrides, head.hash},
      count_{editors.size()},
      never_used_{editors.never_used().begin()} {
  head_.time_ms = std::max(head.time_ms, now_ms);
}

const Editor* Batch::find(EditorId id) const {
  const auto touched = touched_.find(id);
  if (touched == touched_.end()) return editors_.find(id);
  return touched->second ? &touched->second->editor : nullptr;
}

const EditResult* Batch::result_of(EditorId id, std::uint64_t sequence) const {
  const auto touched = touched_.find(id);
  std::size_t newer = 0;
  if (touched != touched_.end()) {
    if (!touched->second) return nullptr;
    const EditorChange& change = *touched->second;
    if (const EditResult* const kept = change.editor.result_of(sequence)) return kept;
    if (change.is_new) return nullptr;
    newer = change.editor.results.size();
  }
  const Editor* const before = editors_.find(id);
  if (before == nullptr) return nullptr;
  const EditResult* const kept = before->result_of(sequence);
  if (kept == nullptr) return nullptr;
  // Newer results displace the oldest.
  const auto behind = static_cast<std::size_t>(before->results.data() + before->results.size() - kept);
  return behind + newer <= kKeptResults ? kept : nullptr;
}

bool Batch::has_forgotten(EditorId id, std::uint64_t sequence) const {
  const auto later = [&](const std::vector<EditResult>& results) {
    return results.end() - std::ranges::upper_bound(results, sequence, {}, &EditResult::sequence);
  };
  std::ptrdiff_t count = 0;
  const auto touched = touched_.find(id);
  if (touched != touched_.end() && touched->second) count = later(touched->second->editor.results);
  if (touched == touched_.end() || (touched->second && !touched->second->is_new)) {
    if (const Editor* const before = editors_.find(id)) count += later(before->results);
  }
  return count >= static_cast<std::ptrdiff_t>(kKeptResults);
}

void Batch::forget_idle() {
  // A batch has a single time.
  if (std::exchange(forgot_idle_, true)) return;
  for (const EditorId id : editors_.idle_at(head_.time_ms)) {
    // Editors touched by this batch are not idle.
    if (touched_.try_emplace(id, std::nullopt).second) --count_;
  }
}

std::optional<EditorId> Batch::forget_never_used() {
  // The choice does not depend on how the log is divided into batches: the editor with the earliest last use,
  // in this batch or before, then the lowest id.
  const Editors::ByUse& known = editors_.never_used();
  while (never_used_ != known.end() && touched_.contains(never_used_->second)) ++never_used_;
  std::optional<EditorId> first;
  if (never_used_ != known.end() && (new_.empty() || *never_used_ < *new_.begin())) {
    first = never_used_->second;
  } else if (!new_.empty()) {
    first = new_.extract(new_.begin()).value().second;
  }
  if (first) {
    touched_[*first] = std::nullopt;
    --count_;
  }
  return first;
}

Editor& Batch::touch(EditorId id, const Editor* editor) {
  std::optional<EditorChange>& touched = touched_[id];
  if (!touched) {
    touched.emplace();
    touched->is_new = editor == nullptr;
    if (editor != nullptr) {  // leave out the results: they take 2 KiB
      touched->editor.epoch = editor->epoch;
      touched->editor.last_sequence = editor->last_sequence;
      touched->editor.subject = editor->subject;
    }
  }
  touched->editor.used_ms = head_.time_ms;
  return touched->editor;
}

EntryResult& Batch::begin(EditorId editor, EntryResult::Kind kind) {
  ++head_.position;
  EntryResult& applied = applied_.emplace_back();
  applied.kind = kind;
  applied.editor = editor;
  applied.position = head_.position;
  applied.revision = head_.revision;
  return applied;
}

const EntryResult& Batch::apply(const AttachEntry& entry) {
  using Kind = EntryResult::Kind;
  if (entry.subject.size() > kMaxSubjectBytes) return begin(entry.editor, Kind::invalid);
  forget_idle();
  const Editor* const before = find(entry.editor);
  if (entry.epoch != (before == nullptr ? 0 : before->epoch) + 1 ||
      (before != nullptr && before->subject != entry.subject)) {
    return begin(entry.editor, Kind::superseded);
  }
  std::optional<EditorId> forgotten;
  const std::size_t most = kMaxEditors + (entry.subject == kOperatorSubject ? kOperatorEditors : 0);
  if (before == nullptr && count_ >= most) {
    forgotten = forget_never_used();
    if (!forgotten) return begin(entry.editor, Kind::editors_full);
  }
  Editor& after = touch(entry.editor, before);
  if (before == nullptr) {
    after.subject = entry.subject;
    ++count_;
  }
  after.epoch = entry.epoch;
  if (!after.is_used()) new_.emplace(head_.time_ms, entry.editor);
  EntryResult& applied = begin(entry.editor, Kind::attached);
  applied.epoch = entry.epoch;
  applied.subject = entry.subject;
  applied.forgotten = forgotten;
  return applied;
}

const EntryResult& Batch::apply(const EditEntry& entry) {
  using Kind = EntryResult::Kind;
  const Editor* const editor = find(entry.editor);
  if (editor == nullptr || editor->epoch != entry.epoch) return begin(entry.editor, Kind::expired);
  if (entry.sequence <= editor->last_sequence) {
    const EditResult* const kept = result_of(entry.editor, entry.sequence);
    EntryResult& repeated = begin(entry.editor, kept == nullptr ? Kind::not_applied : Kind::repeat);
    if (kept != nullptr) {
      repeated.result = *kept;
    } else {
      repeated.is_unknown = has_forgotten(entry.editor, entry.sequence);
    }
    return repeated;
  }
  if (entry.subject.size() > kMaxSubjectBytes) return begin(entry.editor, Kind::invalid);
  auto outcome =
      evaluate(entry.edit, entry.base, staging_, entry.settles.get(), entry.touched, &entry.secrets);
  if (!outcome) return begin(entry.editor, Kind::invalid);

  EntryResult& applied = begin(entry.editor, outcome->conflict ? Kind::conflict : Kind::done);
  if (outcome->changed > 0) {
    applied.writes = staging_.stage(*outcome);
    head_.hash = staging_.hash();
    applied.revision = ++head_.revision;
  }
  applied.result = {.sequence = entry.sequence,
                    .revision = head_.revision,
                    .changed = static_cast<std::uint32_t>(outcome->changed),
                    .conflict = std::nullopt};
  if (outcome->conflict) applied.result.conflict = static_cast<std::uint32_t>(*outcome->conflict);
  applied.changes = std::move(outcome->chunks);
  applied.subject = entry.subject.empty() ? editor->subject : entry.subject;

  touch(entry.editor, editor).keep(applied.result);
  new_.erase({head_.time_ms, entry.editor});
  return applied;
}

const EntryResult& Batch::apply(const BindEntry& entry) {
  using Kind = EntryResult::Kind;
  static const MaterialIds kNone;
  const MaterialIds& known = bound_ ? *bound_ : materials_ != nullptr ? *materials_ : kNone;
  auto ids = ids_for(entry.names, known);
  if (!ids) return begin({}, Kind::invalid);
  if (!bound_) bound_ = known;
  for (const auto& [name, id] : *ids) bound_->insert_or_assign(name, id);
  EntryResult& applied = begin({}, Kind::bound);
  applied.materials = *std::move(ids);
  return applied;
}

}  // namespace talus::edits
