#include <talus/edits/editors.h>

#include <algorithm>
#include <utility>

namespace talus::edits {

void Editor::keep(const EditResult& result) {
  if (results.size() == kKeptResults) results.erase(results.begin());
  results.push_back(result);
  last_sequence = result.sequence;
}

const EditResult* Editor::result_of(std::uint64_t sequence) const {
  const auto at = std::ranges::lower_bound(results, sequence, {}, &EditResult::sequence);
  return at != results.end() && at->sequence == sequence ? &*at : nullptr;
}

const Editor* Editors::find(EditorId id) const {
  const auto at = editors_.find(id);
  return at == editors_.end() ? nullptr : &at->second;
}

void Editors::put(EditorId id, Editor editor) {
  const auto [at, added] = editors_.try_emplace(id);
  if (added) {
    by_use_.emplace(editor.used_ms, id);
  } else if (at->second.used_ms != editor.used_ms) {
    auto use = by_use_.extract({at->second.used_ms, id});
    use.value().first = editor.used_ms;
    by_use_.insert(std::move(use));
  }
  if (!added && !at->second.is_used()) never_used_.erase({at->second.used_ms, id});
  if (!editor.is_used()) never_used_.emplace(editor.used_ms, id);
  at->second = std::move(editor);
}

void Editors::put(EditorId id, EditorChange change) {
  const auto at = editors_.find(id);
  if (!change.is_new && at != editors_.end()) {
    std::vector<EditResult> all = std::move(at->second.results);
    const std::vector<EditResult>& newer = change.editor.results;
    const std::size_t kept = std::min(all.size(), kKeptResults - newer.size());
    all.erase(all.begin(), all.end() - static_cast<std::ptrdiff_t>(kept));
    // By default a vector at its limit would allocate up to twice the maximum.
    if (const std::size_t wanted = kept + newer.size(); wanted > all.capacity()) {
      all.reserve(std::min(kKeptResults, std::max(wanted, 2 * all.capacity())));
    }
    all.insert(all.end(), newer.begin(), newer.end());
    change.editor.results = std::move(all);
  }
  put(id, std::move(change.editor));
}

void Editors::erase(EditorId id) {
  const auto at = editors_.find(id);
  if (at == editors_.end()) return;
  by_use_.erase({at->second.used_ms, id});
  never_used_.erase({at->second.used_ms, id});
  editors_.erase(at);
}

std::vector<EditorId> Editors::idle_at(std::int64_t time_ms) const {
  std::vector<EditorId> idle;
  for (const auto& [used_ms, id] : by_use_) {
    if (used_ms > time_ms - kEditorIdleMs) break;
    idle.push_back(id);
  }
  return idle;
}

bool Editors::any_idle_at(std::int64_t time_ms) const {
  return !by_use_.empty() && by_use_.begin()->first <= time_ms - kEditorIdleMs;
}

}  // namespace talus::edits
