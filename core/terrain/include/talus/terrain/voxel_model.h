// Small voxel models, as placed by [[object]]. The core does not read files; programs do.
#pragma once

#include <cstdint>
#include <vector>

namespace talus::terrain {

/// x goes east, y up and z south from the model's lowest north-western corner.
struct VoxelModel {
  struct Voxel {
    std::uint8_t x = 0;
    std::uint8_t y = 0;
    std::uint8_t z = 0;
    std::uint8_t colour = 0;  // index in the file's palette, 1 to 255
    bool operator==(const Voxel&) const = default;
  };
  int width = 0;   // along x
  int height = 0;  // along y
  int depth = 0;   // along z
  std::vector<Voxel> voxels;
};

/// Maximum size of an object's model, and maximum number of models in a file, which are variants of one kind.
inline constexpr int kMaxModelWidth = 128;  // and depth
inline constexpr int kMaxModelHeight = 128;
inline constexpr int kMaxModels = 256;

}  // namespace talus::terrain
