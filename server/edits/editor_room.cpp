#include "edits/editor_room.h"

#include <chrono>

#include <fmt/format.h>

namespace talus::server {

tl::expected<void, LogFailure> keep_to_editors(const EditState& state, const LogEntry& entry,
                                               const Clock& clock) {
  const auto* const attach = std::get_if<edits::AttachEntry>(&entry);
  if (attach == nullptr || attach->subject == edits::kOperatorSubject || !state.has_all_editors()) return {};
  if (state.editor(attach->editor)) return {};
  return room_for_editor(state, clock);
}

tl::expected<void, LogFailure> room_for_editor(const EditState& state, const Clock& clock) {
  if (!state.has_all_editors()) return {};
  const auto now = std::chrono::duration_cast<std::chrono::milliseconds>(clock.wall().time_since_epoch());
  if (state.any_editor_idle_at(now.count())) return {};
  return tl::unexpected{
      LogFailure{LogFailure::Kind::editors_full,
                 fmt::format("those who came to edit in the last day take all the memory that editors may "
                             "here, {} bytes; come back later",
                             state.editor_limit())}};
}

}  // namespace talus::server
