// What every Welcome says about the world; made once at startup.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <talus/terrain/stacks.h>
#include <talus/terrain/world.h>
#include <talus/voxel/content_hash.h>
#include <talus/voxel/coords.h>

namespace talus::server {

struct WorldInfo {
  ContentHash fingerprint;
  ContentHash store_id;  // 0: nothing is kept
  std::vector<terrain::Material> materials;
  terrain::HeightRange heights;
  VoxelPos spawn;
  std::string server;  // name and version
  /// Tiles of 32 x 32 columns that one GetHeights may name.
  std::uint64_t height_tiles_per_request = std::numeric_limits<std::uint64_t>::max();
};

}  // namespace talus::server
