// What lies in a save's file besides its chunks: ../FORMAT.md.
#pragma once

#include <filesystem>
#include <string_view>

#include <talus/saves/save_file.h>

#include "database.h"

namespace talus::saves {

[[nodiscard]] tl::unexpected<SaveError> damaged(const std::filesystem::path& file, std::string_view what);

/// Checks that the database is a save of this format, with its tables and no others.
[[nodiscard]] Result<void> check_form(Database& database);
[[nodiscard]] Result<SavedWorld> read_world_of(Database& database);
[[nodiscard]] Result<SaveState> read_state_of(Database& database);
/// Makes an empty database a save without chunks.
[[nodiscard]] Result<void> write_world(Database& database, const SavedWorld& world);

}  // namespace talus::saves
