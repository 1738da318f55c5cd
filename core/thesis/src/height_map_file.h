// Writes height map files; core/world_files reads them.
#pragma once

#include <filesystem>

#include <talus/terrain/height_map.h>
#include <talus/tools/failure.h>

namespace talus::tools {

/// Rejects names that end in neither .png nor .npy, and .png if the samples are not uint16.
[[nodiscard]] Expected<void> check_height_map_name(const std::filesystem::path& target,
                                                   const terrain::HeightMap& map);

/// Writes a 16-bit grey PNG, or an array of the samples' type, by the name. The file is written atomically.
[[nodiscard]] Expected<void> write_height_map(const std::filesystem::path& target,
                                              const terrain::HeightMap& map);

}  // namespace talus::tools
