// The bound of the index of edited chunks, as a log keeps it before it takes an edit: applying never asks.
#pragma once

#include <tl/expected.hpp>

#include "edits/edit_log.h"
#include "edits/edit_state.h"

namespace talus::server {

/// Where the index is full: that the edit changes no chunk that was never edited. One that only might let
/// material slide into such a chunk sets nothing loose. Any thread.
[[nodiscard]] tl::expected<void, LogFailure> keep_to_index(const EditState& state, LogEntry& entry);

}  // namespace talus::server
