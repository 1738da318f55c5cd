// Ids for the materials that a world lets people place: those that the store has, and new ones by the log.
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

/// Names of `world` that the store gives no ids yet, in the world's order. Tells the store what the world
/// calls what it generates. An error is one line: a name would be two things, or one is missing of which the
/// store has voxels. Before any thread changes database and state.
[[nodiscard]] tl::expected<std::vector<std::string>, std::string> names_without_ids(
    const terrain::World& world, store::EditDatabase& database, const EditState& state);

/// What the log answers to them, which may take as long as it cannot be reached: then `log` says so now and
/// then. Once `waits` is false, which is asked a few times a second, those are left out that it has not
/// answered.
[[nodiscard]] tl::expected<edits::NamedIds, std::string> bind_by_log(std::vector<std::string> names,
                                                                     EditLog& edits, const Logger& log,
                                                                     const std::function<bool()>& waits);

}  // namespace talus::server
