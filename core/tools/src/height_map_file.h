// Height maps as files that this program writes; core/world_files reads them.
#pragma once

#include <filesystem>

#include <talus/terrain/height_map.h>

#include "failure.h"

namespace talus::tools {

/// Refuses names that end in neither .png nor .npy, and .png for samples that are not uint16.
[[nodiscard]] Expected<void> check_height_map_name(const std::filesystem::path& target,
                                                   const terrain::HeightMap& map);

/// A 16-bit grey PNG or an array of the samples' type, by the name. The file appears whole or not at all.
[[nodiscard]] Expected<void> write_height_map(const std::filesystem::path& target,
                                              const terrain::HeightMap& map);

}  // namespace talus::tools
