// The bound of the memory that editors take, as a log keeps it before it takes an Attach: applying never
// asks, as all servers must come to the same editors.
#pragma once

#include <tl/expected.hpp>

#include "edits/edit_log.h"
#include "edits/edit_state.h"
#include "runtime/clock.h"

namespace talus::server {

/// Where editors have all the memory that they may: that the entry is no Attach of a new one. Who undoes what
/// others did comes in nevertheless, and so does anybody where some editor was idle for so long by `clock`
/// that applying an Attach forgets it. Any thread.
[[nodiscard]] tl::expected<void, LogFailure> keep_to_editors(const EditState& state, const LogEntry& entry,
                                                             const Clock& clock);

/// The same of anybody new who is no operator, before there is an entry.
[[nodiscard]] tl::expected<void, LogFailure> room_for_editor(const EditState& state, const Clock& clock);

}  // namespace talus::server
