// Small models of voxels, as [[object]] places them. Reading files is the business of programs.
#pragma once

#include <cstdint>
#include <vector>

namespace talus::terrain {

/// x goes east, y up and z south, from the model's lowest north-western corner.
struct VoxelModel {
  struct Voxel {
    std::uint8_t x = 0;
    std::uint8_t y = 0;
    std::uint8_t z = 0;
    std::uint8_t colour = 0;  // of the file's palette, 1 to 255
    bool operator==(const Voxel&) const = default;
  };
  int width = 0;   // along x
  int height = 0;  // along y
  int depth = 0;   // along z
  std::vector<Voxel> voxels;
};

/// The largest model of an object, and the most in one file: a file's models are variants of one kind.
inline constexpr int kMaxModelWidth = 21;  // and depth
inline constexpr int kMaxModelHeight = 32;
inline constexpr int kMaxModels = 32;

}  // namespace talus::terrain
