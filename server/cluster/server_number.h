// Identifies a world's server across restarts, for counting servers if states differ.
#pragma once

#include <cstdint>
#include <filesystem>

namespace talus::server::cluster {

/// Reads the file `server_number` of a data directory. If it is missing or malformed, draws a new number and
/// writes it. The file is not part of the store: checkpoints and backups omit it, and it stays when the store
/// is replaced by another server's.
[[nodiscard]] std::uint32_t server_number(const std::filesystem::path& directory);

}  // namespace talus::server::cluster
