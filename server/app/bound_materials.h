// Ids for the placeable materials of a world: ids that the store has, and new ones bound by the log.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include <talus/edits/materials.h>
#include <talus/store/edit_database.h>
#include <talus/terrain/world.h>

#include "edits/edit_log.h"
#include "edits/edit_state.h"
#include "runtime/log/logger.h"

namespace talus::server {

/// Updates the store's names of the materials that `world` generates, and returns the names of `world`
/// without ids, in the world's order. An error is one line: a name is ambiguous, or a material with stored
/// voxels is missing. Call it before any thread changes `database` and `state`.
[[nodiscard]] tl::expected<std::vector<std::string>, std::string> names_without_ids(
    const terrain::World& world, store::EditDatabase& database, const EditState& state);

/// Binds the names by the log and returns its answers. Waits while the log is unreachable, and logs that now
/// and then. Once `waits` returns false (polled a few times a second), names without an answer are left out.
[[nodiscard]] tl::expected<edits::NamedIds, std::string> bind_by_log(std::vector<std::string> names,
                                                                     EditLog& edits, const Logger& log,
                                                                     const std::function<bool()>& waits);

}  // namespace talus::server
