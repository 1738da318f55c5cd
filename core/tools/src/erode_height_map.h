// talus-gen erode-heightmap: a height map in, a height map out.
#pragma once

#include <filesystem>

#include "droplet_erosion.h"
#include "failure.h"

namespace talus::tools {

/// Reads `input`, erodes it and writes `output`, in the input's type of samples.
[[nodiscard]] Expected<void> erode_height_map(const std::filesystem::path& input,
                                              const std::filesystem::path& output,
                                              const DropletOptions& options);

}  // namespace talus::tools
