// Writes a store's edits as the save of a single player.
#pragma once

#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include <talus/store/read_only_store.h>

#include "commands/store/transfer.h"

namespace talus::server {

/// Writes the save `file`, whole or not at all; a save that is there is replaced, unless a program uses it.
/// `world_file` is that of the store's world, empty for the built-in one; `settles`: loose material settles
/// in the save. Fails if the world has another fingerprint, or does not name a material that was placed.
[[nodiscard]] tl::expected<ExportResult, std::string> export_save(const store::ReadOnlyStore& store,
                                                                  const std::filesystem::path& world_file,
                                                                  bool settles,
                                                                  const std::filesystem::path& file);

}  // namespace talus::server
