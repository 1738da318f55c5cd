#include "edits/admission/log_admission.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <fmt/format.h>

namespace talus::server {
namespace {

tl::expected<void, EditError> admit(edits::EditEntry& entry, const EditState& state) {
  if (!state.is_full()) return {};
  const auto is_new = [&](ChunkCoord chunk) { return state.revision({chunk, Lod{}}) == 0; };
  // Not refused: that would tell where ore is.
  for (auto* const secrets : {&entry.secrets.hidden, &entry.secrets.base}) {
    std::erase_if(*secrets, [&](const auto& of_chunk) { return is_new(of_chunk.first); });
  }
  if (entry.secrets.empty()) entry.secrets = {};
  const auto first = std::ranges::find_if(entry.base, is_new, &edits::BaseVoxels::value_type::first);
  if (first == entry.base.end()) return {};
  ChunkCoord chunk = first->first;
  if (entry.settles != nullptr) {  // some of the base may be there for settling only
    const auto touched = std::ranges::find_if(entry.touched, is_new, &edits::TouchedChunk::chunk);
    if (touched == entry.touched.end()) {
      entry.settles = nullptr;
      return {};
    }
    chunk = touched->chunk;
  }
  return edit_error(
      EditErrorCode::index_full,
      fmt::format("the index of edited chunks is full (limit {} bytes), and chunk {} was never edited; "
                  "edit chunks that were edited before",
                  state.index_limit(), to_string(chunk)));
}

}  // namespace

tl::expected<void, EditError> admit_to_log(LogEntry& entry, const EditState& state, const Clock& clock) {
  if (auto* const edit = std::get_if<edits::EditEntry>(&entry)) return admit(*edit, state);
  const auto* const attach = std::get_if<edits::AttachEntry>(&entry);
  if (attach == nullptr || attach->subject == edits::kOperatorSubject || !state.has_all_editors()) return {};
  if (state.editor(attach->editor)) return {};
  return admit_editor(state, clock);
}

tl::expected<void, EditError> admit_editor(const EditState& state, const Clock& clock) {
  if (!state.has_all_editors()) return {};
  const auto now = std::chrono::duration_cast<std::chrono::milliseconds>(clock.wall().time_since_epoch());
  if (state.any_editor_idle_at(now.count())) return {};
  return edit_error(
      EditErrorCode::editors_full,
      fmt::format("the editor table is full (limit {} bytes); retry later", state.editor_limit()));
}

}  // namespace talus::server
