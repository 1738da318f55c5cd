// A chunk as a NumPy array.
#pragma once

#include <cstddef>
#include <vector>

#include <talus/client/world_info.h>
#include <talus/voxel/chunk.h>

namespace talus::cli {

/// A .npy file of shape (32, 32, 32), axes y, z, x, C order: uint8 where every material of the world has
/// an id below 256, as talus-gen export writes it, else uint16 little endian.
[[nodiscard]] std::vector<std::byte> npy_of(const Chunk& chunk,
                                            const std::vector<client::Material>& materials);

}  // namespace talus::cli
