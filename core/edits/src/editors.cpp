#include <talus/edits/editors.h>

#include <algorithm>

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
  erase(id);
  by_use_.emplace(editor.used_ms, id);
  editors_.emplace(id, std::move(editor));
}

void Editors::erase(EditorId id) {
  const auto at = editors_.find(id);
  if (at == editors_.end()) return;
  by_use_.erase({at->second.used_ms, id});
  editors_.erase(at);
}

}  // namespace talus::edits
