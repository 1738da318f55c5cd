// Which server of a world's this is, whenever it is started: by it servers are counted where states differ.
#pragma once

#include <cstdint>
#include <filesystem>

namespace talus::server::cluster {

/// What the file `server_number` of a data directory says. Where there is none, or it is not as this wrote
/// it, another number is drawn, and written. It is no part of the store: neither checkpoints nor backups have
/// it, and it stays when another server's store takes the place of this one's.
[[nodiscard]] std::uint32_t server_number(const std::filesystem::path& directory);

}  // namespace talus::server::cluster
