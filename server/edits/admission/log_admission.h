// The bounds of memory that a log checks before it accepts an entry, on any thread. Applying never checks
// them, so that all servers of a cluster reach the same state.
#pragma once

#include <tl/expected.hpp>

#include "edits/edit_log.h"
#include "edits/edit_state.h"
#include "runtime/clock.h"

namespace talus::server {

/// If the index of edited chunks is full, rejects an edit that may write or guards a chunk that was never
/// edited; if loose material alone may reach such a chunk, turns settling off for the edit; reveals nothing
/// in such a chunk. If the editor table is full, rejects an Attach that would create an editor. Rollback is
/// exempt.
[[nodiscard]] tl::expected<void, EditError> admit_to_log(LogEntry& entry, const EditState& state,
                                                         const Clock& clock);

/// Rejects a new editor if the editor table is full, unless by `clock` applying the Attach removes an idle
/// editor.
[[nodiscard]] tl::expected<void, EditError> admit_editor(const EditState& state, const Clock& clock);

}  // namespace talus::server
