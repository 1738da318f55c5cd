// talus-gen erode-heightmap: erodes a height map file.
#pragma once

#include <filesystem>

#include <talus/tools/failure.h>

#include "droplet_erosion.h"

namespace talus::tools {

/// Reads `input`, erodes it and writes `output` with the input's sample type.
[[nodiscard]] Expected<void> erode_height_map(const std::filesystem::path& input,
                                              const std::filesystem::path& output,
                                              const DropletOptions& options);

}  // namespace talus::tools
